/** The reasons for which a module of the calculation is not there. */

/** A module that did not arrive: for want of the network or an answer, or because the file is none. */
export class MissingModule extends Error {
  /** @param {string} reason @param {"network" | "damaged"} kind @param {unknown} [cause] */
  constructor(reason, kind, cause) {
    super(reason, { cause });
    this.kind = kind;
  }
}

/** True when the browser, or a policy that governs it, refuses to compile any module. @param {unknown} error */
export const forbidden = (error) => error instanceof WebAssembly.CompileError && /embedder|Content.Security.Policy|unsafe-eval|blocked|disallowed/i.test(error.message);
