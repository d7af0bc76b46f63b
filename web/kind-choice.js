/**
 * The choice of the kind of cam, and the parts of the panel that only some kinds need, made when the first such cam is met.
 *
 * @import { KindId, ShellContext } from "./types.d.ts"
 * @import { Texts } from "./texts.js"
 */
import { h, hide } from "./dom.js";
import { mark } from "./help-mark.js";
import { changeKind } from "./kind-change.js";
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
    const kind = /** @type {KindId} */ (select.value);
    const { program } = store.state.report;
    store.edit(t("edit.kind"), (draft) => changeKind(draft, kind, catalogue, program));
  });
  pair.addEventListener("click", () => show("pair").add?.());

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
