// What the type checker cannot see: risky or careless JavaScript.
import js from "@eslint/js";
import globals from "globals";

/** Markup enters the page as elements and text, so that a design's title can never become markup. */
const markup = ["innerHTML", "outerHTML", "insertAdjacentHTML", "setHTMLUnsafe"].map((property) => ({
  property,
  message: "Build elements and set textContent.",
}));

export default [
  { ignores: ["target/", "dist/", "web/pkg/"] },
  js.configs.recommended,
  {
    linterOptions: { reportUnusedDisableDirectives: "error" },
    rules: {
      curly: ["error", "multi-line"],
      eqeqeq: "error",
      "no-eval": "error",
      "no-implied-eval": "error",
      "no-restricted-properties": ["error", ...markup],
      "no-unused-vars": ["error", { argsIgnorePattern: "^_" }],
      "no-var": "error",
      "object-shorthand": "error",
      "prefer-const": "error",
    },
  },
  { files: ["web/**/*.js"], languageOptions: { globals: globals.browser } },
  // Browser tests hold functions that run inside the page.
  { files: ["tests/**/*.js"], languageOptions: { globals: { ...globals.browser, ...globals.node } } },
  { files: ["web/**/*.test.js", "crates/{xtask,theory}/**/*.js", "eslint.config.js"], languageOptions: { globals: globals.node } },
];
