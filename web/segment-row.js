/**
 * One segment of the program on one line: its place, law, angle and rise.
 *
 * @import { Catalogue, LawEntry, ShellContext } from "./types.d.ts"
 * @import { FreeEditor } from "./free-parts.js"
 * @import { NumberField } from "./number-field.js"
 */
import { h, hide, symbol, write, writeAttribute } from "./dom.js";
import { mark } from "./help-mark.js";
import { createFreeEditor } from "./free-editor.js";
import { createThumbnail } from "./law-thumbnail.js";
import { createNumberField, heightStep, lengthStep } from "./number-field.js";
import { placeIn } from "./stage/place.js";

let rows = 0;

/**
 * @param {ShellContext} context
 * @param {object} actions
 * @param {(row: SegmentRow) => void} actions.menu
 * @param {(row: SegmentRow, by: number) => void} actions.move
 * @param {(row: SegmentRow, event: PointerEvent) => void} actions.grab
 * @param {(row: SegmentRow, through: boolean) => void} actions.select
 * @param {(row: SegmentRow) => void} actions.remove
 */
export function createSegmentRow(context, actions) {
  const { store, catalogue, t, format } = context;
  const id = `segment-${++rows}`;
  let index = 0;
  /** @type {LawEntry | undefined} */
  let law;
  /** @type {{ key: string, field: NumberField }[]} */
  let extras = [];
  /** @type {FreeEditor | null} */
  let editor = null;
  let shown = "";

  const number = () => ({ number: index + 1 });
  const grip = h("button", { type: "button", class: "grip" });
  const thumbnail = createThumbnail();
  const lawSelect = h("select", { class: "law", id: `${id}-law` });
  const more = h("button", { type: "button", class: "more", "aria-haspopup": "menu" }, "⋯");
  const problem = h("p", { class: "error", hidden: true, id: `${id}-problem` });
  const parameters = h("div", { class: "parameters" });

  const beta = createNumberField(context, {
    id: `${id}-beta`,
    name: () => t(strideUnit(store.state.design) === "°" ? "segments.beta.of" : "segments.stretch.of", number()),
    unit: () => strideUnit(store.state.design),
    read: (design) => design.segments[index]?.beta,
    write: (value) => [{ op: "beta", segment: index, value }],
    step: (design) => (design.cam.kind === "translating" ? lengthStep(design) : 1),
    path: () => `segments[${index}].beta`,
    highlight: () => ({ segment: index }),
    room: 6,
  });
  const rise = createNumberField(context, {
    id: `${id}-rise`,
    name: () => t("segments.rise.of", number()),
    unit: () => riseUnit(store.state.design),
    read: (design) => design.segments[index] && (design.segments[index].rise ?? store.state.outline.rises[index] ?? 0),
    write: (value) => [{ path: ["segments", index, "rise"], value }],
    step: heightStep,
    path: () => `segments[${index}].rise`,
    highlight: () => ({ segment: index }),
    room: 6,
    signed: true,
  });
  const line = h("div", { class: "line" }, grip, thumbnail.root, lawSelect, beta.input, rise.input, more);
  const root = h("li", { class: "segment" }, line, parameters, beta.error, rise.error, problem);

  lawSelect.addEventListener("change", () => {
    store.edit(t("edit.law", number()), [{ op: "law", segment: index, law: lawSelect.value }]);
  });
  more.addEventListener("click", () => actions.menu(row));
  grip.addEventListener("click", (event) => {
    if (event.shiftKey || event.ctrlKey || event.metaKey) return actions.select(row, event.shiftKey);
    const theta = store.state.report.borders[index];
    if (theta !== undefined) store.set({ cursor: placeIn(store.state.report, theta) });
  });
  grip.addEventListener("keydown", (event) => {
    if (event.key === "Delete") actions.remove(row);
  });
  grip.addEventListener("pointerdown", (event) => actions.grab(row, event));
  root.addEventListener("keydown", (event) => {
    if (!event.altKey || event.target instanceof HTMLInputElement) return;
    if (event.key !== "ArrowUp" && event.key !== "ArrowDown") return;
    event.preventDefault();
    actions.move(row, event.key === "ArrowUp" ? -1 : 1);
  });
  root.addEventListener("pointerenter", () => store.set({ highlight: { segment: index } }));
  root.addEventListener("pointerleave", () => store.set({ highlight: null }));
  root.addEventListener("focusin", () => store.set({ highlight: { segment: index } }));

  /** @param {LawEntry | undefined} next */
  function adoptLaw(next) {
    law = next;
    extras = (next?.parameters ?? []).map(({ key, symbol: sign, quantity }) => ({
      key,
      field: createNumberField(context, {
        id: `${id}-${key}`,
        label: symbol(sign),
        name: () => t("segments.parameter.of", { name: t(`parameter.${key}`), ...number() }),
        unit: () => (quantity === "span" ? "°" : quantity === "height" ? riseUnit(store.state.design) : ""),
        read: (design) => {
          const value = design.segments[index]?.[key];
          return typeof value === "number" ? value : undefined;
        },
        write: (value) => [{ path: ["segments", index, key], value }],
        step: (design) => (quantity === "height" ? lengthStep(design) / 100 : quantity === "span" || key === "degree" ? 1 : 0.05),
        path: () => `segments[${index}].${key}`,
        highlight: () => ({ segment: index }),
        room: 5,
      }),
    }));
    parameters.replaceChildren(
      ...extras.map(({ key, field }) => {
        field.speak();
        if (field.label) field.label.title = t(`parameter.${key}.hint`);
        return h("div", { class: "field" }, field.label, field.input, mark(key, field.label?.id ?? ""));
      }),
      ...extras.map(({ field }) => field.error),
    );
    root.classList.toggle("still", next !== undefined && !next.moves);
    editor = null;
    if (next?.free) openEditor(next);
  }

  /** @param {LawEntry} of */
  function openEditor(of) {
    editor = createFreeEditor(context, of, { id, index: () => index });
    parameters.append(editor.root);
    editor.update(store.state);
  }

  function speak() {
    lawSelect.replaceChildren(...lawGroups(catalogue, t));
    lawSelect.setAttribute("aria-label", t("segments.law.of", number()));
    more.setAttribute("aria-label", t("segments.actions", number()));
    more.title = more.ariaLabel ?? "";
    for (const field of [beta, rise, ...extras.map((extra) => extra.field)]) field.speak();
    editor?.speak();
    if (law) lawSelect.value = law.id;
  }

  /** @param {number} at */
  function update(at) {
    const renumbered = at !== index || grip.textContent === "";
    index = at;
    const { design, error, language } = store.state;
    const segment = design.segments[index];
    if (!segment) return;
    const from = design.segments.slice(0, index).reduce((sum, { beta: span }) => sum + span, 0);
    const wrong = error?.path.startsWith(`segments[${index}]`) ? error : null;
    const state = JSON.stringify([index, segment, store.state.outline.rises[index], from, riseUnit(design), strideUnit(design), wrong, language]);
    if (state === shown) return;
    shown = state;
    const entry = catalogue.laws.find(({ id: known }) => known === segment.law);
    if (entry !== law) adoptLaw(entry);
    if (renumbered) {
      write(grip, String(index + 1));
      speak();
    }
    rise.input.disabled = entry !== undefined && (!entry.moves || (entry.free !== null && segment.rise === undefined));
    if (lawSelect.value !== segment.law) lawSelect.value = segment.law;
    writeAttribute(lawSelect, "title", t(`law.${segment.law}`));
    thumbnail.draw(entry?.thumbnail ?? [], (segment.rise ?? 0) < 0);
    const name = t("segments.grip", { ...number(), from: format.number(from, { unit: strideUnit(design) }), to: format.number(from + segment.beta, { unit: strideUnit(design) }) });
    writeAttribute(grip, "aria-label", name);
    writeAttribute(grip, "title", name);
    for (const field of [beta, rise, ...extras.map((extra) => extra.field)]) field.update(store.state);
    editor?.update(store.state);
    tell(wrong && isOwn(wrong.path) ? wrong.message : null);
  }

  /** @param {string} path */
  function isOwn(path) {
    const own = `segments[${index}]`;
    if (path !== own && !path.startsWith(`${own}.`)) return false;
    return ![`${own}.beta`, `${own}.rise`, ...extras.map(({ key }) => `${own}.${key}`), ...(editor?.paths() ?? [])].includes(path);
  }

  /** @param {string | null} message */
  function tell(message) {
    hide(problem, message === null);
    write(problem, message ?? "");
    if (message === null) lawSelect.removeAttribute("aria-describedby");
    else lawSelect.setAttribute("aria-describedby", problem.id);
  }

  const row = {
    root,
    grip,
    more,
    lawSelect,
    get index() {
      return index;
    },
    update,
    speak,
    /** @param {boolean} is */
    select(is) {
      if (root.classList.contains("selected") === is) return;
      root.classList.toggle("selected", is);
      if (is) grip.setAttribute("aria-pressed", "true");
      else grip.removeAttribute("aria-pressed");
    },
    reset() {
      shown = "";
      for (const field of [beta, rise, ...extras.map((extra) => extra.field)]) field.reset();
      editor?.reset();
    },
  };
  return row;
}

/** @typedef {ReturnType<typeof createSegmentRow>} SegmentRow */

/**
 * What β's are measured in.
 * @param {Readonly<import("./types.d.ts").Design>} design
 */
export const strideUnit = ({ cam, length_unit }) => (cam.kind === "translating" ? length_unit : "°");

/** @param {{ follower: { motion: string }, length_unit: string }} design */
export function riseUnit({ follower, length_unit }) {
  return follower.motion === "oscillating" ? "°" : length_unit;
}

/**
 * @param {Catalogue} catalogue
 * @param {ShellContext["t"]} t
 */
function lawGroups(catalogue, t) {
  const groups = [...new Set(catalogue.laws.map(({ group }) => group))];
  return groups.map((group) =>
    h(
      "optgroup",
      { label: t(`group.${group}`) },
      ...catalogue.laws.filter((entry) => entry.group === group).map(({ id }) => h("option", { value: id }, t(`law.${id}`))),
    ),
  );
}

