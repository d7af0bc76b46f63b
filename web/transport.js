/**
 * The transport: play, direction, steps, the angle and its scrubber, the hand wheel for the speed.
 *
 * @import { Context, State } from "./types.d.ts"
 */
import { h, write, writeAttribute } from "./dom.js";
import { parseNumber } from "./numbers.js";
import { WHEEL, bounced, cycleOf, decimalsOf, inside, positionOf, rateAt, stepped, stride, turned } from "./stage/clock.js";
import { closeFrame, metered } from "./stage/meter.js";
import { letterOf, placeText, unitOfPlace } from "./stage/place.js";
import { watchVisibility } from "./stage/visibility.js";

/** Turns per second when nothing else is known. */
const CALM = 0.25;

/**
 * @param {HTMLElement} root
 * @param {Context} context
 */
export function mount(root, { store, t, format }) {
  const play = h("button", { type: "button", class: "transport-play", onclick: toggle });
  const reverse = h("button", { type: "button", class: "transport-reverse", onclick: () => turnAt(-(store.state.rate || lastRate)) }, "⇄");
  const back = h("button", { type: "button", class: "transport-step", onclick: (/** @type {MouseEvent} */ event) => step(-stride(event, cycle)) });
  const forth = h("button", { type: "button", class: "transport-step", onclick: (/** @type {MouseEvent} */ event) => step(stride(event, cycle)) });
  const scrub = h("input", { type: "range", id: "transport-scrub", class: "transport-scrub", min: "0", max: "360", step: "0.1" });
  const ticks = h("div", { class: "transport-ticks", "aria-hidden": "true" });
  const angle = h("input", { type: "text", id: "transport-angle", class: "transport-angle", inputmode: "decimal", autocomplete: "off", spellcheck: "false" });
  const angleLabel = h("label", { for: "transport-angle", class: "transport-theta" });
  const wheel = h("input", { type: "range", id: "transport-wheel", class: "transport-wheel", min: String(-WHEEL), max: String(WHEEL), step: "1" });
  const wheelLabel = h("label", { for: "transport-wheel", class: "transport-speed" });
  const pace = h("output", { for: "transport-wheel", class: "transport-pace", "aria-live": "off" });
  root.append(
    h("div", { class: "transport-row transport-place" }, play, back, forth, h("div", { class: "transport-track" }, scrub, ticks), h("span", { class: "transport-field" }, angleLabel, angle)),
    h("div", { class: "transport-row transport-rate" }, reverse, wheelLabel, h("span", { class: "transport-wheel-track" }, wheel), pace),
  );

  let cycle = cycleOf({ span: 360, travels: false });
  /** Which way a cam that travels goes. */
  let way = 1;
  let lastRate = CALM;
  let ticked = "";
  let before = NaN;
  let running = false;
  /** One object for every frame: the animation allocates nothing. */
  const patch = { cursor: 0 };

  const advance = metered((/** @type {number} */ now) => {
    if (!Number.isNaN(before)) {
      const { cursor, rate } = store.state;
      const seconds = (now - before) / 1000;
      if (cycle.travels) {
        const next = bounced(cycle, cursor, way * rate, seconds);
        if (next.back) way = -way;
        patch.cursor = next.cursor;
      } else patch.cursor = turned(cursor, rate, seconds);
      store.set(patch);
    }
    before = now;
  });

  /** @param {number} now */
  function tick(now) {
    closeFrame();
    if (!moves()) {
      running = false;
      run();
      return;
    }
    advance(now);
    requestAnimationFrame(tick);
  }

  // Out of sight the cam stands still, and goes on from there. A page that is in view goes on whatever part of it is scrolled away.
  const page = watchVisibility(document.body);
  const moves = () => store.state.playing && store.state.rate !== 0 && !document.hidden && page.visible();

  /** Waits for the page to be in view. */
  const run = page.inView(() => {
    if (running || !moves()) return;
    running = true;
    before = NaN;
    requestAnimationFrame(tick);
  });

  document.addEventListener("visibilitychange", run);
  if (matchMedia("(prefers-reduced-motion: reduce)").matches) store.set({ playing: false });

  function toggle() {
    const { playing, rate } = store.state;
    store.set({ playing: !playing, rate: rate || lastRate });
  }

  /** @param {number} rate */
  function turnAt(rate) {
    if (rate !== 0) lastRate = rate;
    store.set({ rate, playing: rate !== 0 });
  }

  /** @param {number} by */
  function step(by) {
    store.set({ cursor: stepped(store.state.cursor, by, cycle), playing: false });
  }

  scrub.addEventListener("input", () => store.set({ cursor: inside(cycle, Number(scrub.value)), playing: false }));
  scrub.addEventListener("keydown", (event) => {
    const by = { ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1 }[event.key];
    if (by === undefined || event.ctrlKey || event.metaKey) return;
    step(by * stride(event, cycle));
    event.preventDefault();
  });
  wheel.addEventListener("input", () => turnAt(rateAt(Number(wheel.value))));
  wheel.addEventListener("dblclick", () => turnAt(0));

  angle.addEventListener("focus", () => {
    store.set({ playing: false });
    angle.select();
  });
  angle.addEventListener("change", () => {
    const { value } = parseNumber(angle.value, unitOfPlace(store.state.report));
    if (value !== undefined) store.set({ cursor: inside(cycle, value), playing: false });
    showAngle(true);
  });
  angle.addEventListener("keydown", (event) => {
    const by = { ArrowDown: -1, ArrowUp: 1 }[event.key];
    if (event.key === "Escape") {
      const typed = angle.value;
      showAngle(true);
      // With nothing to take back, Escape is for the page.
      if (angle.value === typed) return;
    } else if (by !== undefined) {
      step(by * stride(event, cycle));
      showAngle(true);
    } else return;
    event.preventDefault();
  });

  /** @param {boolean} [always]  also while the field is being typed in */
  function showAngle(always = false) {
    if (!always && document.activeElement === angle) return;
    const text = placeText(format, store.state.report, store.state.cursor, decimalsOf(store.state, cycle));
    if (angle.value !== text) angle.value = text;
  }

  const show = metered(() => {
    const { cursor } = store.state;
    scrub.value = String(cursor);
    showAngle();
    if (!store.state.playing) scrub.setAttribute("aria-valuetext", placeText(format, store.state.report, cursor, decimalsOf(store.state, cycle)));
  });

  store.subscribe(["cursor", "language"], show);
  store.subscribe(["playing", "language"], ({ playing }) => {
    write(play, t(playing ? "transport.pause" : "transport.play"));
    play.dataset["state"] = playing ? "playing" : "paused";
    showAngle();
    run();
  });
  store.subscribe(["rate", "language", "report"], showPace);
  store.subscribe(["report"], () => {
    adoptCycle();
    showTicks();
  });
  store.subscribe(["highlight"], lightTicks);
  store.subscribe(["language"], word);
  word();
  write(play, t(store.state.playing ? "transport.pause" : "transport.play"));
  play.dataset["state"] = store.state.playing ? "playing" : "paused";
  if (/** @type {State["report"] | undefined} */ (store.state.report)) {
    adoptCycle();
    showPace();
    showTicks();
    show();
  }
  run();

  /** Another kind of cam: what the cursor runs through changes, and the cursor keeps its place in it. */
  function adoptCycle() {
    const { report, cursor } = store.state;
    if (report.span === cycle.span && report.travels === cycle.travels) return;
    const next = cycleOf(report);
    const place = inside(next, report.travels === cycle.travels ? cursor : (cursor / cycle.span) * next.span);
    cycle = next;
    scrub.max = String(cycle.span);
    scrub.step = String(cycle.unit / 10);
    root.classList.toggle("travels", cycle.travels);
    if (place !== cursor) store.set({ cursor: place });
    word();
    show();
  }

  function showPace() {
    const { rate, report } = store.state;
    if (Number(wheel.value) === 0 || rateAt(Number(wheel.value)) !== rate) wheel.value = String(positionOf(rate));
    if (rate !== 0) lastRate = rate;
    const real = format.quantity(report.period, { trim: true, unit: "s" });
    const shown = rate === 0 ? t(report.travels ? "transport.stopped.travel" : "transport.stopped", { real }) : t(report.travels ? "transport.pace.travel" : "transport.pace", { shown: format.quantity(1 / Math.abs(rate), { trim: true, unit: "s" }), real });
    write(pace, shown);
    writeAttribute(wheel, "aria-valuetext", rate < 0 ? `${shown}, ${t("transport.backwards")}` : shown);
    writeAttribute(reverse, "aria-pressed", String(rate < 0));
  }

  function showTicks() {
    const { borders, span } = store.state.report;
    if (ticked === borders.join()) return;
    ticked = borders.join();
    ticks.replaceChildren(
      ...borders.slice(1).map((to, i) => {
        const from = borders[i] ?? 0;
        const bar = h("span", { class: "transport-stretch" });
        bar.style.left = `${(from / span) * 100}%`;
        bar.style.width = `${((to - from) / span) * 100}%`;
        return bar;
      }),
    );
    lightTicks();
  }

  function lightTicks() {
    const lit = store.state.highlight?.segment;
    [...ticks.children].forEach((bar, i) => bar.toggleAttribute("data-lit", i === lit));
  }

  function word() {
    root.setAttribute("aria-label", t("transport.title"));
    const report = /** @type {State["report"] | undefined} */ (store.state.report);
    const unit = report ? `${format.number(cycle.unit)}${cycle.travels ? `\u00a0${report.units.length}` : "°"}` : "1°";
    write(back, `−${unit}`);
    write(forth, `+${unit}`);
    back.setAttribute("aria-label", cycle.travels ? t("transport.back.travel", { unit }) : t("transport.back"));
    forth.setAttribute("aria-label", cycle.travels ? t("transport.forth.travel", { unit }) : t("transport.forth"));
    reverse.setAttribute("aria-label", t("transport.reverse"));
    reverse.title = t("transport.reverse");
    scrub.setAttribute("aria-label", t(cycle.travels ? "transport.scrub.travel" : "transport.scrub"));
    angleLabel.replaceChildren(h("i", { class: "symbol" }, report ? letterOf(report) : "θ"), h("span", { class: "unseen" }, ` ${t(cycle.travels ? "transport.place" : "transport.angle")}`));
    write(wheelLabel, t("transport.speed"));
  }
}
