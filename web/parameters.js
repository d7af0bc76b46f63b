/**
 * What the diagram of a parameter says of this very cam: pressure angle, radius of curvature, length of the face.
 *
 * @import { Context, Range, Report } from "./types.d.ts"
 */
import { h, write } from "./dom.js";
import { fieldText, parseNumber } from "./numbers.js";
import { inSight, seesSecond } from "./stage/place.js";
import { tabOf } from "./stage/plots.js";

/**
 * @param {HTMLElement} root
 * @param {Context} context
 */
export function createExplanation(root, { store, lab, t, format }) {
  const meaning = h("p");
  const finding = h("p", { class: "diagram-finding" });
  const label = h("label", { for: "face-margin" });
  const margin = h("input", { id: "face-margin", type: "text", inputmode: "decimal", size: "6", autocomplete: "off", "aria-describedby": "face-margin-error" });
  const unit = h("span", { class: "unit" });
  const error = h("span", { id: "face-margin-error", class: "error", role: "status" });
  const face = h("output", { class: "face-length", for: "face-margin" });
  const field = h("p", { class: "face-field" }, label, margin, unit, error);
  root.append(meaning, finding, field, face);

  margin.addEventListener("change", () => {
    const read = parseNumber(margin.value, unit.textContent ?? "", store.state.language);
    const value = read.value ?? -1;
    margin.setAttribute("aria-invalid", String(value < 0));
    if (read.problem) error.textContent = read.problem;
    else error.textContent = value < 0 ? t("parameters.margin.negative") : "";
    if (value >= 0) store.set({ margins: { ...store.state.margins, [store.state.report.units.length]: value } });
  });
  margin.addEventListener("keydown", (event) => {
    if (event.key !== "Escape") return;
    const typed = margin.value;
    show(true);
    if (margin.value !== typed) event.preventDefault();
  });

  /** @param {number} value */
  const angle = (value) => format.angle(value);
  /** @param {number | null | undefined} value */
  const length = (value) => format.quantity(value, { trim: true, unit: store.state.report.units.length });

  /** The margin that is kept for this unit of length. @param {boolean} anyway  even while it is being typed */
  function show(anyway) {
    const { language, margins, report } = store.state;
    if (!anyway && (document.activeElement === margin || margin.getAttribute("aria-invalid") === "true")) return;
    margin.value = fieldText(margins[report.units.length] ?? 0, language);
    margin.setAttribute("aria-invalid", "false");
    error.textContent = "";
  }

  return {
    update() {
      const { margins } = store.state;
      const report = inSight(store.state);
      const tab = tabOf(store.state);
      if (tab === "svaj") return;
      const contact = tab === "contact";
      write(meaning, t(`parameters.${tab}${contact && report.mechanism.pivot ? ".swing" : ""}`));
      write(finding, { pressure_angle: slope, rho: curvature, contact: walk }[tab](report));
      field.hidden = face.hidden = !contact;
      if (!contact) return;
      const [left = 0, right = 0, least = 0] = lab().face(margins[report.units.length] ?? 0, seesSecond(store.state));
      write(label, t("parameters.margin"));
      write(unit, report.units.length);
      write(
        face,
        report.mechanism.pivot
          ? t("parameters.face.swing", { least: length(least), near: length(left), far: length(right) })
          : t("parameters.face", { least: length(least), left: length(-left), right: length(right) }),
      );
      show(false);
    },
  };

  /** @param {Report} report */
  function slope({ summary, mechanism, pressure_angle_limit }) {
    const phi = /** @type {Range} */ (summary.pressure_angle);
    const [min, max] = [phi.min ?? 0, phi.max ?? 0];
    const limit = format.number(pressure_angle_limit, { unit: "°" });
    if (mechanism.contact === "flat") return t("parameters.pressure_angle.flat", { value: angle(max), limit });
    const [steepest, at] = max >= -min ? [max, phi.max_at] : [min, phi.min_at];
    const key = Math.abs(steepest) > pressure_angle_limit ? "parameters.pressure_angle.beyond" : "parameters.pressure_angle.within";
    return t(key, { min: angle(min), max: angle(max), minAt: angle(phi.min_at), maxAt: angle(phi.max_at), steepest: angle(steepest), at: angle(at), limit });
  }

  /** @param {Report} report */
  function curvature({ summary, mechanism, least_convex: convex, tightest_hollow: hollow, inflections }) {
    const roller = length(mechanism.roller_radius);
    const values = { value: length(convex?.value), at: angle(convex?.at ?? 0), roller, hollow: length(-(hollow?.value ?? 0)), hollowAt: angle(hollow?.at ?? 0), inflections: inflections.map(angle).join(", ") };
    const flat = mechanism.contact === "flat";
    if (!convex) return t("parameters.rho.hollow", values);
    if (convex.value <= 0) return t(flat ? "parameters.rho.flat.undercut" : "parameters.rho.undercut", values);
    if (flat) return t("parameters.rho.flat", values);
    const { max, max_at = 0 } = summary.rho ?? {};
    if (!hollow) return t("parameters.rho.convex", { ...values, max: length(max), maxAt: angle(max_at) });
    return t("parameters.rho.both", values);
  }

  /** @param {Report} report */
  function walk({ summary, mechanism }) {
    const q = /** @type {Range} */ (summary.contact);
    const values = { min: length(q.min), max: length(q.max), minAt: angle(q.min_at), maxAt: angle(q.max_at) };
    if (mechanism.pivot) return t("parameters.contact.walk.swing", values);
    return t(mechanism.face_angle === 0 ? "parameters.contact.walk" : "parameters.contact.walk.inclined", values);
  }
}
