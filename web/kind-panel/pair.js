/**
 * The second cam of a pair, in the design panel.
 *
 * @import { NumberField } from "../number-field.js"
 * @import { Design, ShellContext, TieKey } from "../types.d.ts"
 */
import { h, hide, symbol, write } from "../dom.js";
import { mark } from "../help-mark.js";
import { pairDrawing } from "../kind-drawings.js";
import { createNumberField, lengthStep } from "../number-field.js";
import { rounded } from "./rounded.js";

/**
 * @param {ShellContext} context
 * @param {HTMLButtonElement} opener  the button that adds the second cam, to which the focus returns
 */
export function createPairPanel(context, opener) {
  const { store, t, format, room, announce, module } = context;
  const legend = h("legend");
  const title = h("span");
  const remove = h("button", { type: "button", class: "quiet" });
  legend.append(title, remove);
  const kind = h("select", { id: "field-tie" }, h("option", { value: "angle" }), h("option", { value: "base_radius" }));
  const kindLabel = h("label", { for: kind.id, class: "unseen" });
  const fields = h("div", { class: "fields" });
  const picture = h("div", { class: "pair-drawing" });
  const hint = h("p", { class: "hint" });
  const advice = h("button", { type: "button", class: "cure", hidden: true });
  const problem = h("p", { class: "error", hidden: true });
  const root = h("fieldset", { class: "pair" }, legend, h("div", { class: "drawing-and-fields" }, picture, h("div", {}, kindLabel, kind, fields)), problem, advice, hint);
  /** @type {{ key: string, field: NumberField }[]} */
  let shown = [];
  let built = "";
  /** The tie that the button of advice sets. @type {{ key: TieKey, value: number } | null} */
  let advised = null;

  /** @param {Readonly<Design>} design @returns {TieKey} */
  const tieOf = ({ conjugate, follower }) => (follower.motion === "translating" ? "distance" : conjugate?.base_radius === undefined ? "angle" : "base_radius");
  /** @param {Readonly<Design>} design */
  const radiusKey = ({ follower }) => (["roller_radius", "face_radius"].find((key) => key in follower) ?? null);
  /** @param {TieKey} key */
  const unitOf = (key) => (key === "angle" ? "°" : store.state.design.length_unit);

  /** One click: the second cam with a tie that works, or the reason why there is none. */
  function add() {
    const { design } = store.state;
    const keys = /** @type {TieKey[]} */ (design.follower.motion === "translating" ? ["distance"] : ["angle", "base_radius"]);
    for (const key of keys) {
      const found = room(design, key);
      if (!found) continue;
      store.edit(t("edit.pair"), [{ op: "pair", tie: key, value: found.value }]);
      refused(false);
      update();
      shown[0]?.field.input.focus();
      announce(t("pair.added"));
      return;
    }
    refused(true);
    announce(t("pair.impossible"));
    why(keys[0] ?? "distance");
  }

  /** The reason of this very pair, in the place of the one that holds for all. @param {TieKey} key */
  function why(key) {
    const { design, language } = store.state;
    const reason = module().why_no_second(design, key, language);
    if (!reason) return;
    write(problem, `${reason} ${t("pair.remedy")}`);
    announce(problem.textContent);
  }

  /** @param {boolean} impossible */
  function refused(impossible) {
    root.classList.toggle("refused", impossible);
    problem.hidden = !impossible;
    write(remove, t(impossible ? "banner.close" : "pair.remove"));
    write(problem, impossible ? t("pair.impossible") : "");
    root.hidden = !impossible && store.state.design.conjugate === undefined;
  }

  remove.addEventListener("click", () => {
    if (store.state.design.conjugate) store.edit(t("edit.pair.removed"), [{ op: "clear", path: ["conjugate"] }]);
    refused(false);
    update();
    opener.hidden = false;
    opener.focus();
  });
  kind.addEventListener("change", () => {
    const key = /** @type {TieKey} */ (kind.value);
    store.edit(t("edit.pair"), [{ op: "pair", tie: key }]);
    kind.value = tieOf(store.state.design);
  });
  advice.addEventListener("click", () => {
    if (!advised) return;
    const { key, value } = advised;
    store.edit(t("edit.pair"), [{ op: "pair", tie: key, value }]);
    shown[0]?.field.input.focus();
  });

  /**
   * @param {string} key
   * @param {string} sign
   */
  function createField(key, sign) {
    const own = /** @type {TieKey | "roller_radius" | "face_radius"} */ (key);
    const isRadius = key.endsWith("r_radius") || key === "face_radius";
    const field = createNumberField(context, {
      id: `field-pair-${key}`,
      label: symbol(sign),
      name: () => t(`pair.${key}`),
      unit: () => unitOf(/** @type {TieKey} */ (key)),
      read: (design) => design.conjugate?.[own] ?? (isRadius ? Number(design.follower[key]) : undefined),
      write: (value) => [{ path: ["conjugate", own], value }],
      step: (design) => (key === "angle" ? 1 : lengthStep(design)),
      path: () => `conjugate.${key}`,
      highlight: () => ({ parameter: `conjugate.${key}` }),
    });
    return { key, field };
  }

  function update() {
    const { design, error } = store.state;
    if (root.classList.contains("refused") && (error || design !== refusedFor)) {
      if (refusedFor !== null && design !== refusedFor) refused(false);
    }
    refusedFor = root.classList.contains("refused") ? design : null;
    const pair = design.conjugate;
    hide(root, pair === undefined && !root.classList.contains("refused"));
    if (pair === undefined) return;
    if (root.classList.contains("refused")) refused(false);
    const [tie, radius] = [tieOf(design), radiusKey(design)];
    const state = [tie, radius, design.follower.contact].join();
    if (state !== built) {
      built = state;
      shown = [createField(tie, { distance: "D", angle: "Γ", base_radius: "R_b2" }[tie]), ...(radius ? [createField(radius, "R_f2")] : [])];
      fields.replaceChildren(...shown.map(({ key, field }) => h("div", { class: "field" }, field.label, field.input, field.unit, key === "angle" ? null : mark(key, `field-pair-${key}-label`), field.error)));
      picture.replaceChildren(pairDrawing(design.follower, tie));
      kind.hidden = tie === "distance";
      kind.value = tie;
      speak();
    }
    for (const { field } of shown) {
      field.update(store.state);
      field.speakUnit();
    }
    const wrong = error?.path.startsWith("conjugate") ? error : null;
    const orphan = wrong && !shown.some(({ key }) => wrong.path === `conjugate.${key}`);
    hide(problem, !orphan);
    write(problem, orphan ? wrong.message : "");
    advise(wrong !== null, tie);
    const { pair_angle: angle, pair_note: note, conjugate } = store.state.report;
    const told = [];
    if (!error && conjugate) {
      if (tie !== "base_radius") told.push(t("pair.told.radius", { value: format.quantity(conjugate.mechanism.base_radius, { trim: true, unit: design.length_unit }) }));
      if (tie === "base_radius" && angle !== null) told.push(t("pair.told.angle", { value: format.number(rounded(angle), { unit: "°" }) }));
      if (note) told.push(note);
    }
    write(hint, told.join(" "));
  }
  /** @type {Readonly<Design> | null} */
  let refusedFor = null;
  let asked = 0;

  /**
   * Where a second cam has its place, when the one asked for has none: looked for when the hand rests.
   * @param {boolean} wanted
   * @param {TieKey} key
   */
  function advise(wanted, key) {
    clearTimeout(asked);
    if (!wanted) {
      hide(advice, true);
      return;
    }
    asked = window.setTimeout(() => {
      const found = room(store.state.design, key);
      advised = found && { key, value: found.value };
      hide(advice, false);
      advice.disabled = found === null;
      const number = (/** @type {number} */ value) => format.quantity(value, { trim: true, unit: unitOf(key) });
      const range = found === null ? "" : found.most === null ? t("pair.from", { least: number(found.least) }) : t("pair.between", { least: number(found.least), most: number(found.most) });
      write(advice, found === null ? t("pair.impossible") : t("pair.advice", { range, value: format.number(found.value, { unit: unitOf(key) }) }));
    }, 250);
  }

  function speak() {
    write(title, t("pair.title"));
    write(remove, t(root.classList.contains("refused") ? "banner.close" : "pair.remove"));
    write(kindLabel, t("pair.tie"));
    for (const option of kind.options) option.textContent = t(`pair.by.${option.value}`);
    for (const { key, field } of shown) {
      field.speak();
      if (field.label) field.label.title = `${t(`pair.${key}`)}. ${t(`pair.${key}.hint`)}`;
    }
    picture.firstElementChild?.setAttribute("aria-label", t("pair.title"));
  }

  speak();
  update();
  store.subscribe(["report", "error"], update);
  return { root, update, speak: () => { speak(); update(); }, add };
}
