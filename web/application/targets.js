/**
 * The points to hit: typed or pasted as text, and a table of what is found at each.
 *
 * @import { ApplicationDesign, ShellContext } from "../types.d.ts"
 * @import { Work } from "./work.js"
 */
import { h, write } from "../dom.js";
import { fieldText } from "../numbers.js";
import { letterOf, placeIn, placeText, unitOfPlace } from "../stage/place.js";

/** @type {NonNullable<ApplicationDesign["by"]>[]} */
const PLACES = ["theta", "time"];

let sessions = 0;

/**
 * @param {ShellContext} context
 * @param {Work} work
 */
export function createTargets({ store, t, format, module }, work) {
  const output = h("select");
  const outputName = h("span");
  const by = h("select");
  const byName = h("span");
  const field = h("textarea", { id: "application-targets", spellcheck: "false", autocomplete: "off", rows: "6" });
  const hint = h("p", { class: "hint", id: "application-targets-hint" });
  const error = h("p", { class: "error", id: "application-targets-error", hidden: true });
  const worst = h("p", { class: "application-worst" });
  const body = h("tbody");
  const head = h("tr");
  const table = h("table", { class: "application-errors" }, h("thead", {}, head), body);
  const scroll = h("div", { class: "application-scroll", tabindex: "0", role: "group" }, table);
  const legend = h("legend");
  const ofOutput = h("label", {}, outputName, output);
  const root = h("fieldset", { class: "application-targets" }, legend, h("div", { class: "application-of" }, ofOutput, h("label", {}, byName, by)), hint, field, scroll, error, worst);
  /** @type {string | null} */
  let problem = null;
  let shown = "";
  let session = "";

  output.addEventListener("change", () => {
    store.edit(t("edit.targets"), [{ path: ["application", "output"], value: output.value }]);
  });
  by.addEventListener("change", () => {
    store.edit(t("edit.targets"), [{ op: "targets-by", by: by.value === "time" ? "time" : "theta" }]);
    update();
  });
  field.addEventListener("focus", () => (session = `targets:${++sessions}`));
  field.addEventListener("blur", () => {
    store.endGesture();
    update();
  });
  field.addEventListener("input", () => {
    const { points, line } = module().pairs(field.value);
    problem = points ? null : t("application.targets.unreadable", { line });
    if (points) {
      shown = text(points);
      problem = store.edit(t("edit.targets"), [{ path: ["application", "targets"], value: points }], { gesture: session, told: true })?.message ?? null;
    }
    update();
  });

  /** @param {[number, number][]} points */
  const text = (points) => points.map((point) => point.map((value) => fieldText(value, store.state.language)).join("\t")).join("\n");

  function update() {
    const { design, error: wrong, report: cam } = store.state;
    const { report } = work;
    const main = report?.outputs[report.main];
    if (!report || !main || !design.application) return;
    word(main);
    const written = text(design.application.targets ?? []);
    if (written !== shown || (document.activeElement !== field && problem === null)) {
      if (written !== shown) problem = null;
      shown = written;
      if (field.value !== written) field.value = written;
    }
    const message = problem ?? (wrong?.path.startsWith("application.targets") ? wrong.message : "");
    error.hidden = message === "";
    write(error, message);
    if (message) field.setAttribute("aria-invalid", "true");
    else field.removeAttribute("aria-invalid");
    field.setAttribute("aria-describedby", message ? `${error.id} ${hint.id}` : hint.id);

    const { targets } = report;
    scroll.hidden = targets.length === 0;
    const columns = [letterOf(cam), "t", ...["wanted", "found", "error"].map((key) => t(`application.targets.${key}`))];
    // The three values share the unit, which is told once: the panel is narrow.
    const units = [unitOfPlace(cam), "s", "", "", main.unit];
    head.replaceChildren(...columns.map((name, k) => h("th", { scope: "col" }, units[k] ? `${name} (${units[k]})` : name)));
    body.replaceChildren(...targets.map((target) => row(target)));
    const most = targets.reduce((most, target) => (Math.abs(target.error) > Math.abs(most?.error ?? 0) ? target : most), targets[0]);
    worst.hidden = !most;
    if (most) write(worst, t("application.worst", { error: signed(most.error, main.unit), place: placeText(format, cam, most.theta, 2) }));
  }

  /** @param {import("../types.d.ts").ApplicationTarget} target */
  function row({ theta, time, value, found, error: miss }) {
    const { report: cam } = store.state;
    const go = h("button", { type: "button" }, format.number(Number(theta.toPrecision(7))));
    const name = t("application.targets.go", { place: format.number(Number(theta.toPrecision(7)), { unit: unitOfPlace(cam) }) });
    go.title = name;
    go.setAttribute("aria-label", name);
    go.addEventListener("click", () => store.set({ cursor: placeIn(cam, theta), playing: false }));
    const told = [format.quantity(time), format.number(Number(value.toPrecision(7))), format.number(Number(found.toPrecision(6))), signed(miss)];
    return h("tr", {}, h("th", { scope: "row" }, go), ...told.map((cell) => h("td", {}, cell)));
  }

  /** An error says on which side it is. @param {number} value @param {string} [unit] */
  function signed(value, unit) {
    const told = format.quantity(value, { trim: true, ...(unit ? { unit } : {}) });
    return value > 0 ? `+${told}` : told;
  }

  /** @param {import("../types.d.ts").ApplicationOutput} main */
  function word(main) {
    const { report: cam, design } = store.state;
    const outputs = work.report?.outputs ?? [];
    write(legend, t("application.targets"));
    write(outputName, t("application.targets.of"));
    write(byName, t("application.targets.by"));
    ofOutput.hidden = outputs.length < 2;
    output.replaceChildren(...outputs.map(({ id, name, symbol }) => h("option", { value: id }, `${name} ${symbol}`)));
    output.value = main.id;
    const names = { theta: cam.travels ? t("application.targets.by.travel", { unit: cam.units.length }) : t("application.targets.by.theta"), time: t("application.targets.by.time") };
    by.replaceChildren(...PLACES.map((value) => h("option", { value }, names[value])));
    by.value = design.application?.by ?? "theta";
    field.setAttribute("aria-label", t("application.targets.field"));
    scroll.setAttribute("aria-label", t("application.targets.table"));
    write(hint, t("application.targets.hint", { name: main.name, unit: main.unit }));
  }

  return { root, update };
}
