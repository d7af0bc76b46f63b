/**
 * The choice of follower: a radio group of small drawings.
 *
 * @import { FollowerEntry, ShellContext } from "./types.d.ts"
 * @import { Texts } from "./texts.js"
 */
import { h, write } from "./dom.js";
import { followerDrawing } from "./follower-drawings.js";
import { mark } from "./help-mark.js";

/**
 * @param {ShellContext} context
 * @param {Texts} texts
 */
export function createFollowerChoice({ store, catalogue, t }, texts) {
  const chosen = h("span", { class: "aside" });
  const radios = catalogue.followers.map((entry) => {
    const input = h("input", { type: "radio", name: "follower", value: entry.id, class: "unseen" });
    input.addEventListener("change", () => {
      store.edit(t("edit.follower"), [{ op: "follower", follower: entry.id }]);
      update();
    });
    const label = h("label", { class: "follower" }, input, followerDrawing(entry.id));
    texts.also(() => {
      label.title = t(`follower.${entry.id}`);
      input.setAttribute("aria-label", label.title);
    });
    return { entry, input };
  });

  const root = h(
    "fieldset",
    { class: "followers" },
    h("legend", {}, texts.text(h("span", { id: "head-follower" }), "design.follower"), chosen, mark("follower", "head-follower")),
    h("div", { class: "choices" }, ...radios.map(({ input }) => input.parentElement)),
  );

  function update() {
    const current = followerEntry(catalogue.followers, store.state.design.follower);
    const suited = catalogue.kinds.find(({ id }) => id === store.state.design.cam.kind)?.followers ?? [];
    for (const { entry, input } of radios) input.parentElement?.toggleAttribute("hidden", !suited.includes(entry.id));
    for (const { entry, input } of radios) if (input.checked !== (entry === current)) input.checked = entry === current;
    const name = current ? t(`follower.${current.id}`) : "";
    write(chosen, name);
  }

  return { root, update };
}

/**
 * @param {FollowerEntry[]} followers
 * @param {{ motion: string, contact: string }} follower
 */
export function followerEntry(followers, { motion, contact }) {
  return followers.find((entry) => entry.motion === motion && entry.contact === contact);
}
