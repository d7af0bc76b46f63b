/**
 * The design panel: follower, geometry, program.
 *
 * @import { ShellContext } from "./types.d.ts"
 */
import { h } from "./dom.js";
import { createFollowerChoice } from "./follower-choice.js";
import { createGeometry } from "./geometry.js";
import { createKindChoice } from "./kind-choice.js";
import { createSegments } from "./segments.js";
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
  root.append(heading, kind.line, follower.root, geometry.root, kind.root, segments.root);

  function update() {
    follower.update();
    geometry.update();
    kind.update();
    segments.update();
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
