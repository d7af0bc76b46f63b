/**
 * The upper line: name, title, examples, undo and redo, link, files, language, theme, projector, help.
 *
 * @import { Language, ShellContext, Theme } from "./types.d.ts"
 * @import { Texts } from "./texts.js"
 */
import { h } from "./dom.js";
import { createCompare } from "./compare.js";
import { createFiles } from "./files.js";
import { icon } from "./icons.js";
import { onDemand } from "./on-demand.js";
import { createProjector } from "./projector.js";
import { createShare } from "./share.js";
import { createSkips } from "./skip.js";
import { learn } from "./strings/index.js";
import { createTexts } from "./texts.js";
import { createTitleField } from "./title-field.js";
import { sayWhatLeaves } from "./unfinished.js";

/** @type {Theme[]} */
const THEMES = ["system", "light", "dark"];

/** @type {Language[]} */
const LANGUAGES = ["es", "en"];

/**
 * @param {HTMLElement} root
 * @param {ShellContext} context
 * @param {import("./files.js").FileEngine & import("./compare.js").CompareEngine} engine
 */
export function mount(root, context, engine) {
  const { store, t } = context;
  const texts = createTexts(t);
  const title = createTitleField(context, texts);
  const history = createHistory(context);
  const share = createShare(context, texts);
  const files = createFiles(context, texts, engine);
  const help = h("button", { type: "button", class: "quiet", id: "help-button", "aria-haspopup": "dialog" }, "?");
  onDemand(context, help, () => import("./help/dialog.js"), (dialog) => dialog.open(context));
  texts.attribute(help, "aria-label", "header.help");
  texts.attribute(help, "title", "header.help");
  const theme = createTheme(context);
  const languages = createLanguages(context, texts);
  const projector = createProjector(context, texts);

  root.append(
    ...createSkips(texts),
    texts.attribute(h("h1", {}, "LevaLab"), "title", "app.tagline"),
    title.input,
    h(
      "div",
      { class: "tools" },
      createExamples(context, texts, engine.check),
      h("div", { class: "group for-hands" }, history.undo, history.redo),
      h("div", { class: "group for-hands" }, share.root, ...files),
      createSolution(context, texts),
      createCompare(context, texts, engine),
    ),
    h("div", { class: "group end" }, ...projector.choices, languages.root, theme.button, projector.button, help),
  );

  function follow() {
    title.update();
    history.update();
    share.update();
  }

  function dress() {
    theme.update();
    languages.update();
  }

  follow();
  dress();
  store.subscribe(["design", "report"], follow);
  store.subscribe(["theme", "language"], (_, changed) => {
    if (changed.has("language")) texts.refresh();
    follow();
    dress();
  });
}

/** @param {ShellContext} context */
function createHistory({ store, t }) {
  const undo = h("button", { type: "button", class: "quiet", "aria-keyshortcuts": "Control+Z" }, icon("undo"));
  const redo = h("button", { type: "button", class: "quiet", "aria-keyshortcuts": "Control+Y" }, icon("redo"));
  undo.addEventListener("click", () => store.undo());
  redo.addEventListener("click", () => store.redo());

  /**
   * @param {HTMLButtonElement} button
   * @param {boolean} possible
   * @param {string} name
   */
  function show(button, possible, name) {
    if (button.title === name && button.disabled !== possible) return;
    button.disabled = !possible;
    button.setAttribute("aria-label", name);
    button.title = name;
  }

  return {
    undo,
    redo,
    update() {
      show(undo, store.canUndo(), store.canUndo() ? t("header.undo.what", { what: store.undoLabel() }) : t("header.undo"));
      show(redo, store.canRedo(), store.canRedo() ? t("header.redo.what", { what: store.redoLabel() }) : t("header.redo"));
    },
  };
}

/**
 * @param {ShellContext} context
 * @param {Texts} texts
 * @param {import("./recent.js").Check} check
 */
function createExamples(context, texts, check) {
  const button = texts.text(h("button", { type: "button", class: "quiet", id: "examples", "aria-haspopup": "dialog" }), "header.examples");
  /** @type {(() => void) | undefined} */
  let gallery;
  onDemand(context, button, () => import("./examples.js"), ({ createGallery }) => {
    gallery ??= createGallery(context, check);
    gallery();
  });
  return button;
}

/** The window and its calculation. @param {ShellContext} context */
export async function loadSolution({ workshop }) {
  const [solution] = await Promise.all([import("./solution/index.js"), workshop()]);
  return solution;
}

/**
 * @param {ShellContext} context
 * @param {Texts} texts
 */
function createSolution(context, texts) {
  const button = texts.text(h("button", { type: "button", class: "quiet", id: "solve", "aria-haspopup": "dialog" }), "header.solution");
  texts.attribute(button, "title", "header.solution.hint");
  onDemand(context, button, () => loadSolution(context), (solution) => {
    sayWhatLeaves(context);
    return solution.open(context);
  });
  return button;
}

/** @param {ShellContext} context */
function createTheme({ store, t }) {
  const button = h("button", { type: "button", class: "quiet" });
  button.addEventListener("click", () => {
    const next = THEMES[(THEMES.indexOf(store.state.theme) + 1) % THEMES.length];
    if (next) store.set({ theme: next });
  });
  return {
    button,
    update() {
      const { theme } = store.state;
      const name = t("header.theme", { theme: t(`theme.${theme}`) });
      button.replaceChildren(icon(theme));
      button.setAttribute("aria-label", name);
      button.title = name;
    },
  };
}

/**
 * @param {ShellContext} context
 * @param {Texts} texts
 */
function createLanguages(context, texts) {
  const { store } = context;
  const buttons = LANGUAGES.map((language) => {
    const button = h("button", { type: "button", class: "quiet", lang: language }, language.toUpperCase());
    onDemand(context, button, () => learn(language), () => store.set({ language }));
    button.title = language === "es" ? "Español" : "English";
    return { language, button };
  });
  const root = h("div", { class: "languages", role: "group" }, ...buttons.map(({ button }) => button));
  texts.attribute(root, "aria-label", "header.language");
  return {
    root,
    update() {
      for (const { language, button } of buttons) button.setAttribute("aria-pressed", String(store.state.language === language));
    },
  };
}
