/**
 * The verdict: a traffic light with shape and words, the key figures, and every finding with the changes that cure it. It keeps
 * its height whatever it says, so that nothing moves under the hand; more of it is shown on demand.
 *
 * @import { FindingItem } from "./finding-item.js"
 * @import { DesignError, Finding, Level, Report, ShellContext } from "./types.d.ts"
 */
import { h, hide, s, write } from "./dom.js";
import { createFigures } from "./figures.js";
import { createFindingItem } from "./finding-item.js";
import { createFindingsView } from "./findings-view.js";
import { icon } from "./icons.js";
import { atRest, inSlices } from "./rest.js";
import { createTexts } from "./texts.js";

/** Quiet milliseconds after which a changed verdict is said. */
const QUIET = 900;

/** @typedef {Level | "stopped" | "waiting"} Light */

/** Shapes that differ without their colour: disc with a tick, triangle, octagon with a bar, square with a cross; a clock. */
/** @type {Record<Light, string[]>} */
export const SHAPES = {
  acceptable: ["M12 2a10 10 0 1 0 0 20a10 10 0 1 0 0-20z", "M7.500 12.500l3 3l6-6.500"],
  "low-speed": ["M12 2.500L22.500 21h-21z", "M12 9v6M12 17.500v1"],
  unacceptable: ["M7.900 2h8.200l5.900 5.900v8.200l-5.900 5.900h-8.200l-5.900-5.900v-8.200z", "M7 12h10"],
  stopped: ["M3 3h18v18h-18z", "M8 8l8 8M16 8l-8 8"],
  waiting: ["M12 2a10 10 0 1 0 0 20a10 10 0 1 0 0-20z", "M12 6.500v5.500l4 2.500"],
};

/**
 * @param {HTMLElement} root
 * @param {ShellContext} context
 */
export function mount(root, context) {
  const { store, lab, t, announce, catalogue } = context;
  const parameters = [...catalogue.followers, ...catalogue.laws].flatMap((entry) => entry.parameters.map(({ key }) => key));
  /** Keys of the design that have a name in the strings. */
  const named = new Set(["base_radius", "beta", "rise", ...parameters]);
  const texts = createTexts(t);
  const sign = s("svg", { viewBox: "0 0 24 24", class: "light", "aria-hidden": "true" }, s("path", { class: "shape" }), s("path", { class: "mark" }));
  const word = h("strong", { class: "word" });
  const headline = h("span", { class: "headline" });
  const figures = createFigures(context);
  const note = h("p", { class: "verdict-note" });
  const list = h("ul");
  const all = h("span", { class: "all" });
  const unfold = h("button", { type: "button", class: "quiet unfold", "aria-expanded": "false" }, all, icon("unfold"));
  const view = createFindingsView(root, list, unfold);
  const heading = texts.text(h("h2", { class: "unseen", id: "verdict-heading" }), "app.verdict");
  /** @type {FindingItem[]} */
  const items = [];
  /** @type {Report | null} */
  let shown = null;
  let said = "";
  let timer = 0;

  root.setAttribute("aria-labelledby", heading.id);
  root.append(heading, h("div", { class: "verdict-line" }, sign, h("p", { class: "saying" }, word, " ", headline), unfold), figures.root, note, view);
  texts.attribute(list, "aria-label", "verdict.findings");

  function update() {
    const { report, error } = store.state;
    /** @type {Light} */
    const light = error ? "stopped" : report.verdict.level;
    if (root.dataset["level"] !== light) {
      root.dataset["level"] = light;
      sign.firstElementChild?.setAttribute("d", SHAPES[light][0] ?? "");
      sign.lastElementChild?.setAttribute("d", SHAPES[light][1] ?? "");
    }
    const [lead, rest] = error ? [t(`verdict.${light}`), obstacle(error)] : parted(report.verdict.headline, report.verdict.cam);
    write(word, lead);
    write(headline, rest);
    show(error ? [] : report.verdict.findings);
    if (report !== shown) awaitCures(report);
    write(note, t("verdict.stopped.kept"));
    hide(note, error === null);
    hide(view, items.length === 0);
    hide(unfold, error !== null);
    write(all, items.length > 0 ? t("verdict.all", { count: items.length }) : t("verdict.figures"));
    figures.update();
    say(`${lead} ${rest}`);
  }

  /** @param {Finding[]} findings */
  function show(findings) {
    while (items.length > findings.length) items.pop()?.root.remove();
    while (items.length < findings.length) {
      const item = createFindingItem(context, cured);
      items.push(item);
      list.append(item.root);
    }
    findings.forEach((finding, index) => items[index]?.update(finding));
  }

  /** Drops the search for cures that is under way. */
  let drop = () => {};

  /** Finding the cures takes many analyses, so it is done in slices; the next edit drops it. */
  const lookForCures = atRest(() => {
    if (items.length === 0) return;
    const { language } = store.state;
    drop = inSlices(
      (budget) => lab().step_cures(budget, language),
      (cures) => items.forEach((item, index) => item.prescribe(cures[index] ?? [])),
    );
  });

  /** @param {Report} report */
  function awaitCures(report) {
    shown = report;
    drop();
    for (const item of items) item.prescribe(null);
    lookForCures();
  }

  /** The finding is gone, and its button with it: the focus goes to the next one, or to the verdict. */
  function cured() {
    update();
    const next = list.querySelector("button:enabled");
    if (next instanceof HTMLElement) next.focus();
    else word.focus();
  }

  /** What is wrong, after the name of the number that is. @param {DesignError} error */
  function obstacle({ path, message }) {
    const [, place, key = ""] = /^(?:segments\[(\d+)\])?\.?(?:.*\.)?([a-z_]*)$/.exec(path) ?? [];
    const name = named.has(key) ? t(`parameter.${key}`) : "";
    const subject = place === undefined ? name : t("segments.parameter.of", { name: name || t("segments.law"), number: Number(place) + 1 });
    // After a colon a sentence goes on with a small letter.
    return subject ? `${subject}: ${/^\p{Lu}\p{Ll}/u.test(message) ? message.charAt(0).toLowerCase() + message.slice(1) : message}` : message;
  }

  /** Says a verdict that has changed, once the hands are still. @param {string} sentence */
  function say(sentence) {
    clearTimeout(timer);
    if (sentence === said) return;
    timer = window.setTimeout(() => {
      if (said !== "") announce(sentence);
      said = sentence;
    }, said === "" ? 0 : QUIET);
  }

  /**
   * A headline's judgement, up to its colon, and its reason, with the cam of a pair that it is about.
   * @param {string} headline
   * @param {number | undefined} cam
   * @returns {[string, string]}
   */
  function parted(headline, cam) {
    const end = headline.indexOf(":") + 1;
    if (end === 0) return [headline, ""];
    const reason = headline.slice(end).trim();
    return [cam === undefined ? headline.slice(0, end) : t("verdict.cam.headline", { number: cam, verdict: headline.slice(0, end - 1) }), reason];
  }

  word.tabIndex = -1;
  figures.speak();
  update();
  store.subscribe(["report", "error", "perSecond"], update);
  store.subscribe(["second"], figures.update);
  store.subscribe(["language"], () => {
    texts.refresh();
    figures.speak();
    update();
  });
}

