/** The words of the main screen, in Spanish. */
export { names } from "../pkg/names.es.js";
export { es } from "./es.js";
export { filesEs } from "./files.es.js";
export { freeEs } from "./free.es.js";
export { kindsEs } from "./kinds.es.js";
export { parametersEs } from "./parameters.es.js";
export { stageEs } from "./stage.es.js";
export { unitsEs } from "./units.es.js";
