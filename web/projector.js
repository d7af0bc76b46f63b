/**
 * The projector view: its button, and what a class may see in it besides: the speed of the animation, and large instant values of the
 * diagrams that are shown. Which of them is wanted is remembered; style sheets read it from the root element.
 *
 * @import { ShellContext, State } from "./types.d.ts"
 * @import { Texts } from "./texts.js"
 */
import { h } from "./dom.js";
import { icon } from "./icons.js";
import { tabOf } from "./stage/plots.js";

/** What can be shown besides, each with its key. @type {readonly { part: "projectorSpeed" | "projectorValues", key: string, name: string, hint: string }[]} */
const PARTS = [
  { part: "projectorSpeed", key: "s", name: "projector.speed", hint: "projector.speed.hint" },
  { part: "projectorValues", key: "v", name: "projector.values", hint: "projector.values.hint" },
];

/** What has Escape for itself while it is open. */
const OPEN = "dialog[open], :popover-open, .tour";

/**
 * @param {ShellContext} context
 * @param {Texts} texts
 */
export function createProjector({ store }, texts) {
  const button = h("button", { type: "button", class: "quiet" }, icon("projector"));
  button.addEventListener("click", () => store.set({ projector: !store.state.projector }));
  texts.attribute(button, "aria-label", "header.projector");
  texts.attribute(button, "title", "header.projector.hint");
  const choices = PARTS.map(({ part, key, name, hint }) => {
    const choice = texts.text(h("button", { type: "button", class: "quiet projector-choice", "aria-keyshortcuts": key.toUpperCase() }), name);
    texts.attribute(choice, "title", hint);
    choice.addEventListener("click", () => store.set({ [part]: !store.state[part] }));
    return { part, choice };
  });

  function update() {
    button.setAttribute("aria-pressed", String(store.state.projector));
    for (const { part, choice } of choices) choice.setAttribute("aria-pressed", String(store.state[part]));
  }

  update();
  dress(store.state);
  store.subscribe(["projector", "projectorSpeed", "projectorValues"], update);
  store.subscribe(["projectorSpeed", "projectorValues", "tab", "report"], dress);
  return { button, choices: choices.map(({ choice }) => choice) };
}

/** Says on the root element what is wanted, and of which diagrams. @param {Readonly<State>} state */
function dress(state) {
  const { dataset } = document.documentElement;
  const wanted = { projectorSpeed: state.projectorSpeed ? "" : undefined, projectorValues: state.projectorValues ? tabOf(state) : undefined };
  for (const [name, value] of Object.entries(wanted)) {
    if (value === undefined) delete dataset[name];
    else if (dataset[name] !== value) dataset[name] = value;
  }
}

/**
 * What a key changes in the projector view; null when it is no key of it.
 * @param {Readonly<State>} state
 * @param {string} key
 */
export function afterProjectorKey(state, key) {
  if (!state.projector) return null;
  const asked = PARTS.find((part) => part.key === key);
  return asked ? { [asked.part]: !state[asked.part] } : null;
}

/** Whether Escape leaves the projector view: nothing is open that it would close. @param {Readonly<State>} state */
export const leavesProjector = ({ projector }) => projector && !document.querySelector(OPEN);
