/**
 * The window before the browser's own: which table goes into the report.
 *
 * @import { ShellContext } from "../types.d.ts"
 */
import { h } from "../dom.js";
import { pressOnEnter } from "../enter.js";
import { createTexts } from "../texts.js";
import { sayWhatLeaves } from "../unfinished.js";
import { reportOnPaper } from "./report.js";
import { dressed } from "./words.js";

/** Degrees between rows; 0 is no table. With 5° it fills a page. */
const STEPS = [0, 5, 10, 15, 30];

/** @param {ShellContext} context */
export function createPrintDialog(context) {
  const { store, t, format } = context;
  const texts = createTexts(t);
  const report = reportOnPaper(context);
  const heading = texts.text(h("h2", { id: "print-heading" }), "print.title");
  const table = h("select", { id: "print-table" }, ...STEPS.map((value) => h("option", { value })));
  const close = texts.text(h("button", { type: "button" }), "export.close");
  const go = texts.text(h("button", { type: "button", class: "primary" }), "print.go");
  const label = texts.text(h("label", { for: table.id }), "print.table");
  const fields = h("div", { class: "fields" }, h("div", { class: "field" }, label, table));
  const dialog = h(
    "dialog",
    { class: "export-dialog", "aria-labelledby": heading.id },
    heading,
    fields,
    texts.text(h("p"), "print.about"),
    h("div", { class: "row" }, close, go),
  );
  texts.also(() => {
    for (const option of table.options) {
      const step = Number(option.value);
      option.textContent = step === 0 ? t("print.table.none") : t("print.table.each", { step: format.number(step, { unit: "°" }) });
    }
  });
  table.value = "10";

  pressOnEnter(fields, go);
  go.addEventListener("click", async () => {
    dialog.close();
    sayWhatLeaves(context);
    await report.ready(Number(table.value));
    print();
  });
  table.addEventListener("change", () => report.ready(Number(table.value)));
  close.addEventListener("click", () => dialog.close());
  dialog.addEventListener("click", (event) => {
    if (event.target === dialog) dialog.close();
  });
  store.subscribe(["language"], () => texts.refresh());
  document.body.append(dialog);

  return async function show() {
    await dressed;
    dialog.showModal();
    table.focus();
    // From here on the browser's own print has the report as well.
    await report.ready(Number(table.value));
  };
}
