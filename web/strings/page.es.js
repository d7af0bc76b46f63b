/** The words that every visit needs, in Spanish. */
export { es } from "./es.js";
export { stageEs } from "./stage.es.js";
