/** A row of radio buttons that looks like one switch. */
import { h, hide } from "../dom.js";

/**
 * @param {string} name
 * @param {string[]} values
 * @param {(value: string) => void} onchange
 */
export function choice(name, values, onchange) {
  const legend = h("legend", { class: "unseen" });
  const options = values.map((value) => {
    const input = h("input", { type: "radio", name, value, class: "unseen", onchange: () => onchange(value) });
    const text = h("span");
    return { value, input, text, label: h("label", {}, input, text) };
  });
  const element = h("fieldset", { class: "diagram-choice" }, legend, ...options.map(({ label }) => label));
  return {
    element,
    /**
     * @param {string} value
     * @param {boolean} offered
     */
    offer(value, offered) {
      for (const option of options) if (option.value === value) hide(option.label, !offered);
    },
    /**
     * @param {string} title
     * @param {(value: string) => string} short
     * @param {(value: string) => string} long
     * @param {string} chosen
     */
    word(title, short, long, chosen) {
      legend.textContent = title;
      for (const { value, input, text, label } of options) {
        text.textContent = short(value);
        label.title = long(value);
        input.setAttribute("aria-label", `${short(value)} (${long(value)})`);
        input.checked = value === chosen;
      }
    },
  };
}
