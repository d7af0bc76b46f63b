/**
 * The motion of a cam of constant breadth, in the design panel.
 *
 * @import { Generator, ShellContext } from "../types.d.ts"
 */
import { h, hide, write } from "../dom.js";
import { rounded } from "./rounded.js";

/** Rows of a ready-made motion that are listed; a longer one repeats itself. */
const LISTED = 4;

/** @param {ShellContext} context */
export function createBreadthPanel(context) {
  const { store, catalogue, t, format } = context;
  const select = h("select", { id: "field-generator" }, ...catalogue.generators.map((value) => h("option", { value })));
  const label = h("label", { for: select.id });
  const sides = h("select", { id: "field-sides" }, ...catalogue.polygons.map(({ sides: value }) => h("option", { value }, String(value))));
  const sidesLabel = h("label", { for: sides.id });
  const rule = h("p", { class: "hint rule" });
  const rows = h("ol", { class: "ready" });
  const note = h("p", { class: "hint" });
  const error = h("p", { class: "error", hidden: true });
  const root = h("fieldset", { class: "breadth" }, h("legend", { class: "unseen" }), h("div", { class: "choices-row" }, label, select, h("span", { class: "sides" }, sidesLabel, sides)), error, rule, rows, note);

  const adopt = () => store.edit(t("edit.generator"), [{ op: "generator", generator: /** @type {Generator} */ (select.value), sides: Number(sides.value) }]);
  select.addEventListener("change", adopt);
  sides.addEventListener("change", adopt);

  function update() {
    const { design, report, error: wrong, stale, outline } = store.state;
    const { cam, length_unit: unit } = design;
    hide(root, cam.kind !== "constant-breadth");
    if (root.hidden) return;
    if (select.value !== (cam.generator ?? "harmonic")) select.value = cam.generator ?? "harmonic";
    if (cam.sides !== undefined) sides.value = String(cam.sides);
    for (const part of [sides, sidesLabel]) hide(part, cam.generator !== "circular-arc");
    const length = (/** @type {number} */ value) => format.number(value, { unit });
    write(rule, t("breadth.rule", { breadth: format.number(cam.breadth), radius: format.number(cam.base_radius), travel: length(outline.travel ?? 0) }));
    const own = wrong && /generator|sides/.test(wrong.path) ? wrong.message : "";
    hide(error, own === "");
    write(error, own);
    const program = (!stale && report.program) || [];
    hide(rows, program.length === 0);
    const listed = program.slice(0, LISTED);
    while (rows.childElementCount > listed.length) rows.lastElementChild?.remove();
    while (rows.childElementCount < listed.length) rows.append(h("li", {}, h("span"), h("span"), h("span")));
    listed.forEach(({ law, beta, rise }, index) => {
      const texts = [t(`law.${law}`), format.number(rounded(beta), { unit: "°" }), rise === 0 ? "" : format.number(rounded(rise), { unit })];
      texts.forEach((text, column) => write(/** @type {Element} */ (rows.children[index]?.children[column]), text));
    });
    write(note, cam.generator === "mirror" ? t("breadth.mirror") : t(program.length > LISTED ? "breadth.ready.more" : "breadth.ready", { count: program.length - LISTED }));
  }

  function speak() {
    root.firstElementChild?.replaceChildren(t("breadth.title"));
    label.textContent = t("breadth.generator");
    sidesLabel.textContent = t("breadth.sides");
    for (const option of select.options) option.textContent = t(`generator.${option.value}`);
    update();
  }

  speak();
  store.subscribe(["report"], update);
  return { root, update, speak };
}
