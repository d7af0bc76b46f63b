/** The words that every visit needs, in English. */
export { en } from "./en.js";
export { stageEn } from "./stage.en.js";
