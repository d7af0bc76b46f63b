/**
 * The choice of the kind of cam, and the parts of the panel that only some kinds need, made when the first such cam is met.
 *
 * @import { Design, KindId, ShellContext } from "./types.d.ts"
 * @import { Texts } from "./texts.js"
 */
import { h, hide } from "./dom.js";
import { mark } from "./help-mark.js";
import { createBreadthPanel } from "./kind-panel/breadth.js";
import { createPairPanel } from "./kind-panel/pair.js";

/** @typedef {{ root: HTMLElement, update: () => void, speak: () => void }} Part */

/**
 * @param {ShellContext} context
 * @param {Texts} texts
 */
export function createKindChoice(context, texts) {
  const { store, catalogue, t } = context;
  const select = h("select", { id: "field-kind" }, ...catalogue.kinds.map(({ id }) => h("option", { value: id })));
  const pair = texts.text(h("button", { type: "button", class: "quiet", hidden: true }), "pair.add");
  const line = h("div", { class: "kind-line" }, texts.text(h("label", { for: "field-kind", id: "field-kind-label" }), "design.kind"), select, mark("kind", "field-kind-label"), pair);
  /** Beneath the geometry. */
  const root = h("div", { class: "kind-parts" });
  /** @type {Record<"breadth" | "pair", Part | null>} */
  const parts = { breadth: null, pair: null };

  select.addEventListener("change", () => {
    change(/** @type {KindId} */ (select.value));
    // A kind that was refused does not stay chosen.
    update();
  });
  pair.addEventListener("click", () => show("pair").add?.());

  /** The designs of the kinds that were left, and what the next kind made of each: the way back gives what was not changed since. @type {Map<KindId, { before: Design, after: Design }>} */
  const left = new Map();
  let origin = store.origin();

  /** @param {KindId} kind */
  function change(kind) {
    if (store.origin() !== origin) left.clear();
    origin = store.origin();
    const before = store.state.design;
    if (store.edit(t("edit.kind"), [{ op: "kind", kind, ...left.get(kind) }])) return;
    const after = store.state.design;
    for (const other of left.values()) if (JSON.stringify(other.after) === JSON.stringify(before)) other.after = after;
    left.set(before.cam.kind, { before, after });
  }

  /** @param {"breadth" | "pair"} name */
  function show(name) {
    const part = parts[name] ?? (name === "breadth" ? createBreadthPanel(context) : createPairPanel(context, pair));
    if (!parts[name]) {
      parts[name] = part;
      root[name === "breadth" ? "append" : "prepend"](part.root);
    }
    part.update();
    return /** @type {Part & { add?: () => void }} */ (part);
  }

  texts.also(() => {
    for (const option of select.options) option.textContent = t(`kind.${option.value}`);
    for (const part of [parts.breadth, parts.pair]) part?.speak();
  });

  function update() {
    const { cam, conjugate } = store.state.design;
    if (select.value !== cam.kind) select.value = cam.kind;
    const pairs = cam.kind === "rotating" || cam.kind === "constant-breadth";
    hide(pair, !pairs || conjugate !== undefined);
    for (const [name, wanted] of /** @type {const} */ ([["breadth", cam.kind === "constant-breadth"], ["pair", conjugate !== undefined]])) {
      if (parts[name]) parts[name].update();
      else if (wanted) show(name);
    }
  }

  return { line, root, update };
}
