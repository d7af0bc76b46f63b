/**
 * Puts the page together: engine, first design, modules, keys.
 *
 * @import { Design, Edit, ShellContext } from "./types.d.ts"
 */
import { begin } from "./afterwards.js";
import * as appearance from "./appearance.js";
import { createBanner } from "./banner.js";
import * as designPanel from "./design-panel.js";
import * as diagrams from "./diagrams.js";
import { startEngine } from "./engine.js";
import * as header from "./header.js";
import { answer } from "./help-mark.js";
import * as keys from "./keys.js";
import { firstDesign, keepLink } from "./link.js";
import * as mechanism from "./mechanism.js";
import { connectNumbers, createFormat } from "./numbers.js";
import { yieldPoster } from "./poster.js";
import * as readouts from "./readouts.js";
import { whenIdle } from "./rest.js";
import { isBrought, retitled, shelve } from "./shelf.js";
import { say, speakIn } from "./signs.js";
import { store } from "./store.js";
import { createTranslate, learn, learned } from "./strings/index.js";
import * as transport from "./transport.js";
import * as verdict from "./verdict.js";
import { whyNotStarted } from "./start-failure.js";
import { workshop } from "./workshop.js";
import { CATALOGUE as catalogue } from "./pkg/catalogue.js";

const language = () => store.state.language;
const t = createTranslate(language);
const format = createFormat(language);
const banner = createBanner(element("banner"), t);

store.set(appearance.rememberedView(store.state));
appearance.follow(store);

// Not waited for: what it imports on the way may import from this module when they are packed into one file.
start().catch((error) => {
  console.error(error);
  // The words may be what did not arrive: then the sentence in the page has to do.
  if (!learned(language())) return document.getElementById("late")?.classList.add("now");
  element("late").remove();
  banner.show(...whyNotStarted(error, t));
});

async function start() {
  const starting = startEngine({ language, restarted });
  // The words come first, since a failure needs them too.
  starting.catch(() => {});
  await learn(language());
  const engine = await starting;
  connectNumbers(engine.module);
  const example = shelve(catalogue.first, t);

  store.connect({
    analyse(design) {
      const opened = engine.analyse(design, () => t("banner.panic"));
      if (opened.error) opened.error.message = say(opened.error.message);
      else if (speakIn(opened.report?.notation)) store.touch("language");
      return opened;
    },
    apply(design, edits) {
      const read = engine.apply(design, [...edits, ...ownTitle(design, edits)], t("banner.panic"));
      if (read.error) read.error.message = say(read.error.message);
      return read;
    },
    refused(error, design, edits) {
      // A panic is told already.
      if (error.message === t("banner.panic")) return;
      const reason = () => engine.apply(design, edits, t("banner.panic")).error?.message ?? "";
      banner.show("banner.edit", () => ({ reason: say(reason()) }));
    },
    failed(error) {
      if (!engine.failed(error)) throw error;
    },
  });
  // The engine tells of its own failures.
  addEventListener("error", (event) => {
    if (engine.failed(event.error)) event.preventDefault();
  });
  addEventListener("unhandledrejection", (event) => {
    if (engine.failed(event.reason)) event.preventDefault();
  });
  const first = firstDesign(engine, example);
  if (!store.start(first.design)) store.start(example);

  /** @type {ShellContext} */
  const context = { store, lab: engine.lab, t, format, catalogue, banner, announce, room: engine.room, module: engine.module, workshop };
  yieldPoster();
  // What is drawn on canvases comes first in each frame: their text asks for the styles of the page, which costs least while
  // nothing has been written into it.
  mechanism.mount(element("mechanism"), context);
  diagrams.mount(element("diagrams"), context);
  header.mount(element("header"), context, engine);
  designPanel.mount(element("design"), context);
  transport.mount(element("transport"), context);
  readouts.mount(element("readouts"), context);
  verdict.mount(element("verdict"), context);
  keys.listen(context);
  answer(context);
  keepLink(context, engine, first);
  const { damaged, arrived } = first;
  if (damaged) banner.show("banner.link", () => ({ reason: engine.openLink(`#${damaged}`).error?.message ?? "" }), damaged);
  else if (arrived) banner.show("banner.query", () => ({ note: engine.openLink(arrived).note ?? "" }));

  store.set({ playing: !matchMedia("(prefers-reduced-motion: reduce)").matches });
  store.subscribe(["language"], () => {
    banner.refresh();
    store.reanalyse(retitled(store.state.design, t));
  });
  store.drawNow();
  performance.mark("levalab:drawn");
  element("late").remove();
  whenIdle(() => begin(context, engine));
}

/**
 * What was brought along goes by its name until it is changed: then it is another design, without a title.
 * @param {Design} design
 * @param {Edit[]} edits
 * @returns {Edit[]}
 */
function ownTitle(design, edits) {
  const titled = edits.some((edit) => "path" in edit && edit.path[0] === "title");
  return !titled && isBrought(design) ? [{ path: ["title"], value: "" }] : [];
}

/** @param {boolean} hopeless */
function restarted(hopeless) {
  banner.show(hopeless ? "banner.broken" : "banner.panic");
  store.touch("report");
}

/** @param {string} sentence */
function announce(sentence) {
  element("announcer").textContent = sentence;
}

/**
 * @param {string} id
 * @returns {HTMLElement}
 */
function element(id) {
  const found = document.getElementById(id);
  if (!found) throw new Error(`#${id} is missing`);
  return found;
}
