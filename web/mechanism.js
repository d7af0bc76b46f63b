/**
 * The mechanism: cam and follower to scale, turning; its layers, its window, what the pointer is on.
 *
 * @import { Context, State } from "./types.d.ts"
 */
import { h, write } from "./dom.js";
import { atRest } from "./rest.js";
import { STEP, handle } from "./stage/handling.js";
import { mechanismInWords } from "./stage/in-words.js";
import { instant } from "./stage/instant.js";
import * as kinds from "./stage/kinds.js";
import { layersMenu } from "./stage/layers-menu.js";
import { metered } from "./stage/meter.js";
import { onAppearance, paperPalette, readPalette } from "./stage/palette.js";
import { Pen } from "./stage/pen.js";
import { onPixelRatio, pixelRatio, sizeCanvas } from "./stage/pixel-ratio.js";
import { Scene } from "./stage/scene.js";
import { createSight } from "./stage/sight.js";
import { fitView } from "./stage/view.js";
import { watchVisibility } from "./stage/visibility.js";

/** Free room around the picture, CSS pixels. */
const MARGIN = 14;
/** Below a yoke, a pair or a wedge, which fill the corners, room for the scale bar and its label. */
const SCALE_ROOM = 20;

/**
 * @param {HTMLElement} root
 * @param {Context} context
 */
export function mount(root, context) {
  const { store, lab, t, format } = context;
  const canvas = h("canvas", { class: "stage-canvas", tabindex: "0", role: "img", "aria-describedby": "stage-keys" });
  const keys = h("p", { id: "stage-keys", class: "unseen" });
  const coordinates = h("output", { class: "stage-coordinates", "aria-live": "off" });
  const menu = layersMenu(context);
  const buttons = /** @type {const} */ ({
    out: h("button", { type: "button", class: "stage-zoom", onclick: () => sight.zoom(1 / STEP, width / 2, height / 2) }, "−"),
    in: h("button", { type: "button", class: "stage-zoom", onclick: () => sight.zoom(STEP, width / 2, height / 2) }, "+"),
    fit: h("button", { type: "button", onclick: () => sight.fit() }),
  });
  const frame = h("div", { class: "stage-frame" }, canvas);
  root.append(frame, keys, h("div", { class: "stage-bar" }, menu.root, coordinates, h("div", { class: "stage-zooms", role: "group" }, buttons.out, buttons.in, buttons.fit)));

  const surface = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d"));
  const pen = new Pen(surface, readPalette());
  let width = 0;
  let height = 0;
  /** @type {Scene | null} */
  let scene = null;
  let kind = "";
  /** @type {{ x: number, y: number } | null} */
  let pointer = null;

  /** The text alternative. */
  const describe = atRest(() => canvas.setAttribute("aria-label", mechanismInWords(context)));

  const paint = metered(() => {
    if (!scene || width === 0) return;
    scene.draw(pen, store.state, instant(context), format, width, height);
  });
  const draw = watchVisibility(frame).inView(paint);
  const sight = createSight(pen.view, fitted, () => store.touch("window"));

  function measure() {
    pen.palette = readPalette();
    width = frame.clientWidth;
    height = frame.clientHeight;
    pen.ratio = pixelRatio();
    sizeCanvas(canvas, width, height, pen.ratio);
    if (scene && !(sight.chosen() && sight.found())) sight.look(true);
    draw();
  }

  new ResizeObserver(measure).observe(frame);
  onPixelRatio(measure);

  onAppearance(() => {
    pen.palette = readPalette();
    store.touch("window");
  });

  addEventListener("beforeprint", () => {
    pen.palette = paperPalette();
    paint();
  });
  addEventListener("afterprint", () => {
    pen.palette = readPalette();
    paint();
  });

  store.subscribe(["report"], () => {
    rebuild();
    draw();
  });
  store.subscribe(["cursor", "layers", "highlight", "beside", "window"], (_, changed) => {
    if ((changed.has("layers") || changed.has("beside")) && scene && !sight.chosen()) sight.look(false);
    if (!changed.has("report")) draw();
  });
  store.subscribe(["layers"], () => menu.update());
  store.subscribe(["report"], () => describe());
  store.subscribe(["language"], word);

  handle({
    canvas,
    store,
    view: () => pen.view,
    sense: () => store.state.report.mechanism.sense,
    onCam(x, y) {
      if (!scene) return false;
      const angle = -scene.camAngle(store.state.cursor);
      const [c, n] = [Math.cos(angle), Math.sin(angle)];
      surface.setTransform(1, 0, 0, 1, 0, 0);
      return surface.isPointInPath(scene.cam.profile, x * c - y * n + scene.camShift(store.state.cursor), x * n + y * c);
    },
    zoom: sight.zoom,
    pan: sight.pan,
    fit: sight.fit,
    hover(point) {
      pointer = point;
      tellPointer();
    },
    hints: () => ({ wheel: t("stage.hint.wheel"), finger: t("stage.hint.finger") }),
  });
  if (/** @type {State["report"] | undefined} */ (store.state.report)) rebuild();
  menu.update();
  word();

  function rebuild() {
    const { report } = store.state;
    const other = `${report.mechanism.motion} ${report.mechanism.contact} ${report.units.length} ${report.kind} ${report.conjugate !== null} ${report.travels ? report.span : ""}`;
    scene = new Scene(report, lab(), scene, filled() ? kinds : null);
    if (other !== kind) {
      sight.forget();
      menu.update();
    }
    if (!sight.chosen()) sight.look(kind === "");
    kind = other;
  }

  function fitted() {
    if (width === 0) return null;
    return fitView(/** @type {Scene} */ (scene).box(store.state), width, height - (filled() ? SCALE_ROOM : 0), MARGIN);
  }

  /** True when what is drawn is more than a round cam and its follower. */
  function filled() {
    const { report } = store.state;
    return report.kind !== "rotating" || report.conjugate !== null;
  }

  function tellPointer() {
    if (!pointer || !scene) {
      write(coordinates, "");
      return;
    }
    const { x, y } = pointer;
    const { sense } = scene.report.mechanism;
    const digitsOf = Math.max(0, Math.ceil(Math.log10(pen.view.scale)));
    if (scene.report.travels) {
      const told = (/** @type {number} */ value) => format.number(value, { digits: digitsOf });
      write(coordinates, t("stage.pointer.travel", { x: told(x), y: told(y), place: told(x + store.state.cursor), unit: scene.report.units.length }));
      return;
    }
    const around = 90 - (Math.atan2(y, x) * 180) / Math.PI;
    // The cam angle at which this place of the cam stands upright.
    const place = (((sense * around + store.state.cursor) % 360) + 360) % 360;
    const length = (/** @type {number} */ value) => format.number(value, { digits: digitsOf });
    write(coordinates, t("stage.pointer", {
      x: length(x), y: length(y), r: length(Math.hypot(x, y)), angle: format.angle(place), unit: scene.report.units.length,
    }));
  }

  /** Names. */
  function word() {
    keys.textContent = t("stage.keys");
    buttons.out.setAttribute("aria-label", t("stage.zoomOut"));
    buttons.in.setAttribute("aria-label", t("stage.zoomIn"));
    buttons.fit.textContent = t("stage.fit");
    buttons.fit.parentElement?.setAttribute("aria-label", t("stage.window"));
    root.setAttribute("aria-label", t("stage.title"));
    menu.word();
    describe();
  }
}
