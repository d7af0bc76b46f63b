/**
 * The diagrams: s, v, a, j on one axis, φ and ρ on their own, with the cursor that they share.
 *
 * @import { Diagram, ShellContext, State, Tab } from "./types.d.ts"
 * @import { Row } from "./stage/overlay.js"
 */
import { createMarks } from "./diagram-marks.js";
import { h, write } from "./dom.js";
import { createExplanation } from "./parameters.js";
import { atRest } from "./rest.js";
import { choice } from "./stage/choice.js";
import { cycleOf, decimalsOf } from "./stage/clock.js";
import { moveCursor, placeUnder, wheelCursor } from "./stage/cursor-hand.js";
import { figure } from "./stage/figure.js";
import { diagramInWords } from "./stage/in-words.js";
import { instant } from "./stage/instant.js";
import { metered } from "./stage/meter.js";
import { FLAG, LABELS, atTheta, drawOverlay } from "./stage/overlay.js";
import { onAppearance, paperPalette, readPalette } from "./stage/palette.js";
import { onPixelRatio, pixelRatio, sizeCanvas } from "./stage/pixel-ratio.js";
import { inSight, letterOf, placeText, seesSecond } from "./stage/place.js";
import { PLOTS, TABS, styleOf, tabOf, unitOf } from "./stage/plots.js";
import { vectorDrawings } from "./stage/print.js";
import { watchVisibility } from "./stage/visibility.js";
import { plain } from "./signs.js";

/** What the tabs are called on their buttons. @type {Readonly<Record<Tab, string>>} */
const SHORT = { svaj: "SVAJ", pressure_angle: "φ", rho: "ρ", contact: "q" };

/**
 * @param {HTMLElement} root
 * @param {ShellContext} context
 */
export function mount(root, context) {
  const { store, lab, t, format } = context;
  const figures = /** @type {Record<Diagram, ReturnType<typeof figure>>} */ (Object.fromEntries(Object.values(PLOTS).map((plot) => [plot.diagram, figure(plot)])));
  const overlay = h("canvas", {
    class: "diagram-overlay", tabindex: "0", role: "slider", "aria-valuemin": "0", "aria-valuemax": "360", "aria-orientation": "horizontal",
  });
  const legend = h("div", { id: "legend", hidden: true });
  const note = h("div", { class: "diagram-note", hidden: true });
  const plots = h("div", { class: "diagram-plots" }, ...Object.values(figures).map(({ element }) => element), overlay);
  const tabs = choice("diagram-tab", ["svaj", "pressure_angle", "rho", "contact"], (value) => store.set({ tab: /** @type {Tab} */ (value) }));
  const timing = choice("diagram-timing", ["radian", "second"], (value) => store.set({ perSecond: value === "second" }));
  const cams = choice("diagram-cam", ["first", "second"], (value) => store.set({ second: value === "second" }));
  cams.element.hidden = true;
  root.append(plots, legend, note, h("div", { class: "diagram-bar" }, cams.element, tabs.element, timing.element));

  const surface = /** @type {CanvasRenderingContext2D} */ (overlay.getContext("2d"));
  let palette = readPalette();
  let ratio = pixelRatio();
  let width = 0;
  let height = 0;
  /** @type {{ diagram: Diagram, left: number, top: number, wide: number, tall: number, labels: boolean }[]} */
  let slots = [];
  /** @type {Row[]} */
  let rows = [];
  let hover = NaN;
  /** @type {Tab | null} */
  let arranged = null;
  /** @type {ReturnType<typeof createExplanation> | null} */
  let explanation = null;
  /** @type {ReturnType<typeof createMarks> | null} */
  let marks = null;
  let drawing = false;
  const { inView } = watchVisibility(plots);
  const drawAll = inView(paintAll);
  const moved = inView(metered(drawCursor));

  new ResizeObserver(fit).observe(plots);
  onPixelRatio(fit);
  onAppearance(() => {
    palette = readPalette();
    schedule();
  });
  store.subscribe(["report", "perSecond", "language", "tab", "margins", "beside", "second"], (_, changed) => {
    const { report } = store.state;
    const dressed = (report.conjugate === null) === cams.element.hidden && overlay.getAttribute("aria-valuemax") === String(report.span);
    const other = tabOf(store.state) !== arranged;
    if (other || !dressed || changed.has("language") || changed.has("perSecond") || changed.has("second")) word();
    if (other) {
      arrange();
      measure();
    }
    tabs.offer("contact", store.state.report.summary.contact !== undefined);
    drawAll();
    caption();
  });
  const tell = atRest(() => {
    explain();
    for (const { plot, canvas } of Object.values(figures)) canvas.setAttribute("aria-label", diagramInWords(context, plot));
  });

  store.subscribe(["cursor", "highlight"], (_, changed) => {
    if (!changed.has("report") && !changed.has("tab") && !changed.has("perSecond") && !changed.has("language") && !changed.has("second")) moved();
  });
  store.subscribe(["cursor", "playing", "language"], tellCursor);
  arrange();
  if (ready()) {
    word();
    caption();
    tellCursor();
  }

  /** False until the first design has been opened. */
  function ready() {
    return /** @type {State["report"] | undefined} */ (store.state.report) !== undefined;
  }

  function arrange() {
    arranged = tabOf(store.state);
    const shown = TABS[arranged];
    for (const { plot, element } of Object.values(figures)) element.hidden = !shown.includes(plot.diagram);
  }

  /** Another size, or another screen. */
  function fit() {
    palette = readPalette();
    measure();
    drawAll();
  }

  function schedule() {
    if (drawing) return;
    drawing = true;
    requestAnimationFrame(() => {
      drawing = false;
      measure();
      drawAll();
    });
  }

  /** Shares the room out among the diagrams: once a size, tab or theme, so that an edit asks the page for no layout. */
  function measure() {
    width = plots.clientWidth;
    height = plots.clientHeight;
    ratio = pixelRatio();
    const shown = TABS[tabOf(store.state)];
    const foot = Math.round(palette.chartSize * LABELS);
    const each = Math.floor((height - foot - Math.round(palette.chartSize * FLAG)) / shown.length);
    const { element, canvas } = figures[/** @type {Diagram} */ (shown[0])];
    // The caption stands above.
    const head = canvas.offsetTop - element.offsetTop;
    const [left, wide] = [canvas.offsetLeft, element.clientWidth];
    slots = shown.map((diagram, i) => ({ diagram, left, top: i * each + head, wide, tall: each - head + (i === shown.length - 1 ? foot : 0), labels: i === shown.length - 1 }));
    for (const slot of slots) {
      const figure = figures[slot.diagram];
      figure.element.style.height = `${slot.tall + head}px`;
      sizeCanvas(figure.canvas, wide, slot.tall, ratio);
    }
    sizeCanvas(overlay, width, height, ratio);
  }

  /** Draws the curves of the chosen tab: once a design, size, theme or language. */
  function paintAll() {
    if (!ready()) return;
    if (width === 0 || height === 0) measure();
    if (width === 0 || height === 0) return;
    const { perSecond } = store.state;
    rows = slots.map(({ diagram, left, top, wide, tall, labels }) => {
      const { plot, canvas } = figures[diagram];
      const area = lab().draw(canvas, diagram, styleOf(plot, palette, store.state, { width: wide, height: tall, ratio, labels }), seesSecond(store.state));
      return { diagram, area, x: left, y: top, place: perSecond ? plot.timed : plot.place, colour: palette[plot.token] };
    });
    drawCursor();
    mark();
  }

  /** The data of curves made from data, over the diagram of s. */
  function mark() {
    if (!marks && !store.state.design.segments.some(({ points, ordinates }) => points ?? ordinates)) return;
    marks ??= createMarks(plots, context);
    marks(seesSecond(store.state) ? undefined : rows.find(({ diagram }) => diagram === "s"));
  }

  function drawCursor() {
    if (rows.length === 0 || !ready()) return;
    const { cursor, highlight, report } = store.state;
    const label = `${letterOf(report)} ${placeText(format, report, cursor, decimalsOf({ cursor, playing: true }, cycleOf(report)))}`;
    drawOverlay(surface, { rows, width, height, ratio, cursor, hover, label, highlight, report, at: instant(context, seesSecond(store.state)), palette });
  }

  /** For a reader of the screen; not sixty times a second. */
  function tellCursor() {
    const { playing, cursor, report } = store.state;
    if (playing && overlay.hasAttribute("aria-valuenow")) return;
    overlay.setAttribute("aria-valuenow", cursor.toFixed(report.travels ? 3 : 1));
    overlay.setAttribute("aria-valuetext", `${letterOf(report)} ${placeText(format, report, cursor)}`);
  }

  function word() {
    const { perSecond, report } = store.state;
    const { travels } = report;
    const tab = tabOf(store.state);
    root.setAttribute("aria-label", t("diagram.title"));
    overlay.setAttribute("aria-label", t(travels ? "diagram.cursor.travel" : "diagram.cursor"));
    overlay.setAttribute("aria-valuemax", String(report.span));
    cams.element.hidden = report.conjugate === null;
    cams.word(t("diagram.cams"), (value) => t(`diagram.cam.${value}`), (value) => t(`diagram.cam.${value}.long`), seesSecond(store.state) ? "second" : "first");
    tabs.word(t("diagram.choose"), (value) => plain(SHORT[/** @type {Tab} */ (value)]), (value) => t(`diagram.tab.${value}`), tab);
    timing.word(t("diagram.timing"), (value) => (travels && value === "radian" ? t("diagram.per.length.short", { unit: report.units.length }) : t(`diagram.per.${value}.short`)), (value) => (travels && value === "radian" ? t("diagram.per.length") : t(`diagram.per.${value}`)), perSecond ? "second" : "radian");
  }

  /** Letters, names and units; the sentences for those who cannot see the curves follow when the hand rests. */
  function caption() {
    const { perSecond } = store.state;
    const report = inSight(store.state);
    for (const { plot, letter, name, unit } of Object.values(figures)) {
      write(letter, plain(perSecond ? plot.perSecond : plot.letter));
      write(name, t(`diagram.name.${plot.diagram}`));
      write(unit, unitOf(plot, report, perSecond));
    }
    tell();
  }

  /** The explanation under the diagram of a parameter. */
  function explain() {
    const tab = tabOf(store.state);
    note.hidden = tab === "svaj";
    if (note.hidden) return;
    explanation ??= createExplanation(note, context);
    explanation.update();
  }

  moveCursor(overlay, store, () => rows[0], (event) => {
    const [first] = rows;
    if (!first || event.pointerType === "touch") return;
    const { report } = store.state;
    const within = event.offsetX >= atTheta(first, 0) && event.offsetX <= atTheta(first, report.span);
    hover = within ? placeUnder(first, event, report) : NaN;
    lightSegment(within ? report.borders.findIndex((border) => border > hover) - 1 : -1);
    drawCursor();
  });
  wheelCursor(overlay, store, () => t("diagram.hint.wheel"));
  overlay.addEventListener("pointerleave", () => {
    hover = NaN;
    lightSegment(-1);
    drawCursor();
  });

  /** @param {number} segment */
  function lightSegment(segment) {
    const lit = store.state.highlight?.segment ?? -1;
    if (lit !== segment) store.set({ highlight: segment < 0 ? null : { segment } });
  }

  vectorDrawings(() =>
    TABS[tabOf(store.state)].map((diagram) => {
      const { plot, canvas } = figures[diagram];
      const given = { width: canvas.clientWidth, height: canvas.clientHeight, ratio: 1, labels: true };
      return { canvas, svg: lab().svg(diagram, styleOf(plot, paperPalette(), store.state, given), seesSecond(store.state)) };
    }),
  );
}
