/** The generated JavaScript of each module, as `bundle.js` puts it into the single-file page. */
declare module "levalab:glue" {
  /** A copy of its own, with an instance of its own. */
  export function freshGlue(name: string): any;
}
