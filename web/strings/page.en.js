/** The words of the main screen, in English. */
export { names } from "../pkg/names.en.js";
export { en } from "./en.js";
export { filesEn } from "./files.en.js";
export { freeEn } from "./free.en.js";
export { kindsEn } from "./kinds.en.js";
export { parametersEn } from "./parameters.en.js";
export { stageEn } from "./stage.en.js";
export { unitsEn } from "./units.en.js";
