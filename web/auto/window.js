/**
 * The window: drawing and table of what the machine must do, the program that is joined from it, why, and the button that takes it.
 *
 * @import { Design, ShellContext } from "../types.d.ts"
 * @import { Demand, Kind } from "./demands.js"
 */
import { h, write } from "../dom.js";
import { icon } from "../icons.js";
import { exact, fieldText } from "../numbers.js";
import { riseUnit } from "../segment-row.js";
import { choice } from "../stage/choice.js";
import { KINDS, asked, placed, suggested } from "./demands.js";
import { createDrawing } from "./drawing.js";
import { createList } from "./list.js";
import { createTable } from "./table.js";

/** What the window needs of the engine. @typedef {{ joined: { design: Design, choices: string[] }, error?: undefined } | { error: { path: string, message: string }, joined?: undefined }} Answer */

/** @param {ShellContext} context */
export function createWindow(context) {
  const { store, t, workshop } = context;
  const list = createList(() => store.state.language);
  /** @type {Kind} */
  let tool = "dwell";
  /** @type {Design | null} */
  let found = null;
  /** For which design the requirements are. */
  let subject = "";
  let waiting = false;

  const heading = h("h2", { id: "auto-heading" });
  const about = h("p");
  const tools = choice("auto-tool", Object.keys(KINDS), (value) => {
    tool = /** @type {Kind} */ (value);
    say("");
  });
  const spoken = h("p", { class: "auto-said", "aria-hidden": "true" });
  const undo = h("button", { type: "button", class: "quiet" }, icon("undo"));
  const redo = h("button", { type: "button", class: "quiet" }, icon("redo"));
  const drawing = createDrawing(context, list, () => tool, say);
  const problem = h("p", { class: "auto-problem", role: "status" });
  const add = h("button", { type: "button", class: "quiet" });
  const none = h("button", { type: "button", class: "quiet" });
  const table = createTable(context, list, () => add.focus());
  const fast = h("input", { type: "checkbox", id: "auto-fast" });
  const fastLabel = h("label", { for: "auto-fast" });
  const least = h("select", { id: "auto-least" });
  const leastLabel = h("label", { for: "auto-least" });
  const why = h("ul", { class: "auto-why" });
  const take = h("button", { type: "button", class: "primary" });
  const close = h("button", { type: "button" });
  const dialog = h(
    "dialog",
    { id: "auto", "aria-labelledby": heading.id },
    heading,
    about,
    h("div", { class: "auto-tools" }, tools.element, spoken, h("span", { class: "auto-history" }, undo, redo)),
    drawing.root,
    problem,
    h(
      "div",
      { class: "auto-halves" },
      h("div", {}, table.root, h("div", { class: "auto-bar" }, add, none)),
      h("div", {}, h("div", { class: "auto-bar" }, h("span", {}, leastLabel, " ", least), h("span", {}, fast, fastLabel)), why),
    ),
    h("div", { class: "auto-foot" }, close, take),
  );
  document.body.append(dialog);

  list.watch((what) => {
    if (what === "light") return;
    undo.disabled = !list.canUndo;
    redo.disabled = !list.canRedo;
    none.disabled = list.all.length === 0;
    ask();
  });
  close.addEventListener("click", () => dialog.close());
  undo.addEventListener("click", () => list.undo());
  redo.addEventListener("click", () => list.redo());
  none.addEventListener("click", () => list.edit((draft) => void draft.splice(0)));
  add.addEventListener("click", () => {
    const others = list.all.flatMap((demand) => placed(demand) ?? []);
    const values = suggested(tool, others, drawing.usualHeight());
    list.edit((draft) => void draft.push({ kind: tool, ...list.texts(values) }));
    table.focus(list.all.length - 1);
  });
  fast.addEventListener("change", () => void join());
  least.addEventListener("change", () => void join());
  take.addEventListener("click", () => {
    const program = found?.segments;
    if (!program) return;
    store.edit(t("edit.auto"), [{ path: ["segments"], value: program }]);
    subject = subjectOf();
    dialog.close();
  });
  dialog.addEventListener("keydown", (event) => {
    if (event.key === "Escape" && drawing.letGo()) event.preventDefault();
    if (!(event.ctrlKey || event.metaKey) || event.altKey) return;
    const key = event.key.toLowerCase();
    if (key !== "z" && key !== "y") return;
    // Here it is the requirements that are taken back, and not the design behind them.
    event.preventDefault();
    if (key === "y" || event.shiftKey) list.redo();
    else list.undo();
  });
  store.subscribe(["language"], () => {
    if (dialog.open) word();
  });

  /** What of the program on screen a machine may have asked for; a dwell below and one above when that is nothing. */
  function guess() {
    const { design, language, outline } = store.state;
    const text = (/** @type {number} */ value) => fieldText(exact(value), language);
    let from = 0;
    /** @type {Demand[]} */
    const kept = [];
    design.segments.forEach((segment, k) => {
      const [to, s, end] = [from + segment.beta, outline.heights[k] ?? 0, outline.heights[k + 1] ?? 0];
      if (segment.law === "dwell") kept.push({ kind: "dwell", from: text(from), to: text(to), s: text(s) });
      if (segment.law === "constant-velocity") kept.push({ kind: "line", from: text(from), to: text(to), s: text(s), end: text(end) });
      from = to;
    });
    const moves = kept.some(({ kind, s }) => kind === "line" || s !== "0");
    if (moves) return kept;
    return [/** @type {Demand} */ ({ kind: "dwell", from: "0", to: "60", s: "0" }), /** @type {Demand} */ ({ kind: "dwell", from: "180", to: "240", s: text(outline.lift || 10) })];
  }

  /** Changes with the design that is open and the unit of its heights. */
  const subjectOf = () => `${store.origin()} ${riseUnit(store.state.design)}`;

  /** What the hand does or might do, under the tools. @param {string} sentence */
  function say(sentence) {
    write(spoken, sentence || t(`auto.hint.${tool}`));
    spoken.classList.toggle("telling", sentence !== "");
  }

  /** One joining a frame, however fast the hand is. */
  function ask() {
    if (waiting || !dialog.open) return;
    waiting = true;
    requestAnimationFrame(() => {
      waiting = false;
      void join();
    });
  }

  async function join() {
    const { join_requirements } = await workshop();
    const { all, bad } = asked(list.all);
    if (!all) return tell({ error: { path: `requirements[${bad}]`, message: t("auto.unreadable") } });
    if (all.length === 0) return tell({ error: { path: "", message: t("auto.nothing") } });
    /** @type {Partial<Design>} */
    const around = { ...store.lastGood() };
    delete around.segments;
    tell(join_requirements({ ...around, requirements: all, high_speed: fast.checked, least: least.value }, store.state.language));
  }

  /** @param {Answer} answer */
  function tell({ joined, error }) {
    const place = /^requirements\[(\d+)\]/.exec(error?.path ?? "")?.[1];
    write(problem, error ? (place === undefined ? error.message : t("auto.problem", { number: Number(place) + 1, message: error.message })) : "");
    // Nothing asked for is no fault.
    problem.classList.toggle("error", list.all.length > 0);
    table.blame(place);
    drawing.blame(place);
    found = joined?.design ?? null;
    take.disabled = found === null;
    const choices = joined?.choices ?? [];
    while (why.children.length > choices.length) why.lastChild?.remove();
    choices.forEach((sentence, k) => write(why.children[k] ?? why.appendChild(h("li")), sentence));
    drawing.show(found);
  }

  function word() {
    write(heading, t("auto.title"));
    write(about, t("auto.about"));
    tools.word(t("auto.tool"), (value) => t(`auto.kind.${value}`), (value) => t(`auto.hint.${value}`), tool);
    for (const [button, name] of /** @type {const} */ ([[undo, "header.undo"], [redo, "header.redo"]])) {
      button.setAttribute("aria-label", t(name));
      button.title = t(name);
    }
    write(add, t("auto.add"));
    write(none, t("auto.none"));
    write(fastLabel, t("auto.fast"));
    write(leastLabel, t("auto.least"));
    write(close, t("auto.close"));
    write(take, t("auto.take"));
    table.root.setAttribute("aria-label", t("auto.table"));
    const chosen = least.value || "acceleration";
    least.replaceChildren(...["velocity", "acceleration", "jerk"].map((id) => h("option", { value: id, selected: id === chosen }, t(`auto.least.${id}`))));
    say("");
    table.word();
    drawing.word();
    list.speak();
  }

  return {
    open() {
      if (subject !== subjectOf()) list.begin(guess());
      subject = subjectOf();
      dialog.showModal();
      word();
    },
  };
}
