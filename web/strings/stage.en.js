/** @type {Record<string, import("./index.js").Phrase>} */
export const stageEn = {};
