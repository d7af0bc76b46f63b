/**
 * The menu of layers: a box and a sample of the line for each.
 *
 * @import { Context } from "../types.d.ts"
 */
import { h, s } from "../dom.js";
import { mark } from "../help-mark.js";
import { LAYERS, applies } from "./layers.js";

/** @param {Context} context */
export function layersMenu({ store, t }) {
  const title = h("summary");
  const items = /** @type {(keyof typeof LAYERS)[]} */ (Object.keys(LAYERS)).map((layer) => {
    const box = h("input", { type: "checkbox", onchange: () => store.set({ layers: { ...store.state.layers, [layer]: box.checked } }) });
    const sample = s("svg", { class: `stage-sample stage-sample-${layer}`, viewBox: "0 0 28 8", "aria-hidden": "true" }, s("path", { d: "M1 4H27" }));
    const name = h("span", { id: `layer-name-${layer}` });
    return { layer, box, name, row: h("div", { class: "stage-layer" }, h("label", {}, box, sample, name), mark(`layer-${layer}`, name.id)) };
  });
  const root = h("details", { class: "stage-layers" }, title, h("div", { class: "stage-layers-list" }, ...items.map(({ row }) => row)));
  root.addEventListener("keydown", (event) => {
    if (event.key !== "Escape" || !root.open) return;
    root.open = false;
    title.focus();
    event.stopPropagation();
  });
  document.addEventListener("pointerdown", (event) => {
    if (root.open && !root.contains(/** @type {Node} */ (event.target))) root.open = false;
  });

  return {
    root,

    word() {
      title.textContent = t("stage.layers");
      for (const { layer, name } of items) name.textContent = t(`stage.layer.${layer}`);
    },

    update() {
      for (const { layer, box, row } of items) {
        box.checked = store.state.layers[layer] ?? LAYERS[layer];
        row.hidden = !applies(layer, store.state.report);
      }
    },
  };
}
