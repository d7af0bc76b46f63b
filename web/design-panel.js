/**
 * The design panel: follower, geometry, program.
 *
 * @import { ShellContext } from "./types.d.ts"
 */
import { h } from "./dom.js";
import { createFollowerChoice } from "./follower-choice.js";
import { createGeometry } from "./geometry.js";
import { createKindChoice } from "./kind-choice.js";
import { markPending } from "./pending.js";
import { createSegments } from "./segments.js";
import { onDemand } from "./on-demand.js";
import { createTexts } from "./texts.js";

/**
 * @param {HTMLElement} root
 * @param {ShellContext} context
 */
export function mount(root, context) {
  const { store, t } = context;
  const texts = createTexts(t);
  const heading = texts.text(h("h2", { class: "unseen", id: "design-heading" }), "app.design");
  const follower = createFollowerChoice(context, texts);
  const geometry = createGeometry(context, texts);
  const kind = createKindChoice(context, texts);
  const segments = createSegments(context, texts);
  root.setAttribute("aria-labelledby", heading.id);
  const application = texts.text(h("button", { type: "button", class: "quiet", id: "application-button", "aria-expanded": "false" }), "design.application");
  onDemand(context, application, () => import("./application/index.js"), (panel) => panel.open(context, application));
  root.append(heading, kind.line, follower.root, geometry.root, kind.root, segments.root, application);

  function update() {
    follower.update();
    geometry.update();
    kind.update();
    segments.update();
    markPending();
  }

  update();
  store.subscribe(["design", "error"], update);
  store.subscribe(["highlight"], () => {
    geometry.light();
    segments.light();
  });
  store.subscribe(["language"], () => {
    texts.refresh();
    update();
  });
}
