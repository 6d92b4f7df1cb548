/** What one recording's parameters would change in the others of its folder, before it is done. */

import { byId, el } from "./dom.js";
import { plural, time as timeText } from "./format.js";

/**
 * @param {import("./store.js").Store} store
 * @param {any} actions
 */
export function createSpread(store, actions) {
  const dialog = /** @type {HTMLDialogElement} */ (byId("spread"));
  const close = () => dialog.close();
  dialog.addEventListener("click", ({ target }) => target === dialog && close());
  dialog.addEventListener("close", () => store.set({ spread: null }));

  store.on(["spread"], ({ spread, readOnly }) => {
    if (!spread) return;
    const apply = () => {
      close();
      actions.spread(true);
    };
    const changing = spread.items.filter(changes).length;
    dialog.replaceChildren(
      el("h2", { text: "These parameters for all recordings" }),
      el("p", { text: changing ? `${plural(changing, "recording")} would change. Edits stay; parameters set on one recording alone go on holding.` : "No recording would change." }),
      el("div", { class: "spread-rows" }, ...spread.items.map(drawItem)),
      el("div", { class: "buttons" },
        readOnly ? "" : el("button", { type: "button", class: "button primary", text: "Apply to all", on: { click: apply } }),
        el("button", { type: "button", class: "button", text: "Cancel", on: { click: close } })));
    if (!dialog.open) dialog.showModal();
  });
}

const changes = (item) => item.comes_s.length + item.goes_s.length + item.moves_s.length + item.newly_inapplicable.length > 0;

function drawItem(item) {
  const said = [
    ...item.comes_s.map((time) => `+ ${timeText(time)} s`),
    ...item.goes_s.map((time) => `− ${timeText(time)} s`),
    ...item.moves_s.map(([from, to]) => `${timeText(from)} → ${timeText(to)} s`),
    ...item.newly_inapplicable.map((text) => `no longer applies: ${text}`),
    ...item.own.map((text) => `keeps its own ${text}`),
  ];
  return el("div", { class: "spread-row" }, el("b", { text: item.name }),
    el("span", { class: changes(item) ? "" : "quiet", text: said.length ? said.join(", ") : "stays as it is" }));
}
