/** What one recording's parameters would change in the others of its folder, before it is done. */

import { byId, el } from "../../lib/dom.js";
import { plural, time as timeText } from "../../lib/format.js";

/**
 * @param {import("../../lib/store.js").Store} store
 * @param {any} actions
 */
export function createSpread(store, actions) {
  const dialog = /** @type {HTMLDialogElement} */ (byId("spread"));
  const summary = el("p", { role: "status" });
  const bar = el("i");
  const rows = el("div", { class: "spread-rows", tabindex: "0" });
  const withDone = /** @type {HTMLInputElement} */ (
    el("input", {
      type: "checkbox",
      on: { change: () => actions.spread("look", withDone.checked) },
    })
  );
  const doneText = el("span", {});
  const doneBox = el("label", { class: "spread-done" }, withDone, doneText);
  const apply = /** @type {HTMLButtonElement} */ (
    el("button", { type: "button", class: "button primary", text: "Apply to all" })
  );
  const cancel = el("button", {
    type: "button",
    class: "button",
    text: "Cancel",
    on: { click: () => dialog.close() },
  });
  dialog.append(
    el("h2", { text: "Apply these parameters to all recordings" }),
    summary,
    el("div", { class: "spread-progress" }, bar),
    rows,
    doneBox,
    el("div", { class: "buttons" }, apply, cancel),
  );
  dialog.addEventListener("click", ({ target }) => target === dialog && dialog.close());
  // What was under way when a person left is still told afterwards.
  let left = 0;
  let look = 0;
  dialog.addEventListener("close", () => {
    if (store.state.spread) {
      left = store.state.spread.look;
      actions.spread("leave");
    }
    store.set({ spread: null });
  });
  apply.addEventListener("click", () => {
    left = store.state.spread?.look ?? left;
    store.set({ spread: null });
    dialog.close();
    actions.spread("apply", withDone.checked);
  });

  store.on(["spread"], ({ spread, recordings: { current }, lookingOnly }) => {
    if (!spread || spread.look <= left || lookingOnly) return void (dialog.open && dialog.close());
    const { items, total } = spread;
    if (!dialog.open) withDone.checked = false;
    if (look !== spread.look) rows.replaceChildren();
    look = spread.look;
    const finished = items.filter(({ id, done }) => done && id !== current).length;
    doneBox.hidden = !finished;
    doneText.textContent = `Also the ${finished} that ${finished === 1 ? "is" : "are"} done; opened again, to be looked at`;
    const isWhole = items.length === total;
    summary.textContent = isWhole
      ? outcome(items)
      : `Trying them on ${plural(total, "recording")}: ${items.length} done.`;
    bar.style.setProperty("width", `${(100 * items.length) / Math.max(total, 1)}%`);
    bar.classList.toggle("whole", isWhole);
    for (const item of items.slice(rows.children.length)) rows.append(drawItem(item, current));
    apply.disabled = !isWhole;
    if (!dialog.open) {
      rows.replaceChildren(...items.map((item) => drawItem(item, current)));
      dialog.showModal();
    }
    if (isWhole) apply.focus();
  });
}

/** @typedef {import("../../messages/list_messages").SpreadLine} Line */

/** @param {Line} item */
const changes = (item) =>
  !item.error &&
  item.comes_s.length + item.goes_s.length + item.moves_s.length + item.newly_inapplicable.length >
    0;

function outcome(items) {
  const changing = items.filter(changes).length;
  return changing
    ? `${plural(changing, "recording")} of ${items.length} would change. Edits stay.`
    : "No boundary would change.";
}

/** @param {Line} item @param {string|null} current */
function drawItem(item, current) {
  return el(
    "div",
    { class: `spread-row ${changes(item) ? "" : "same"}`, data: { recording: item.id } },
    el("b", { text: item.name, title: item.name }),
    el(
      "div",
      {},
      ...(item.id === current
        ? [
            el("span", {
              class: "quiet",
              text: `gives them: ${item.own?.join(", ") || "as its folder has them"}`,
            }),
          ]
        : item.error
          ? [el("span", { class: "lost", text: `cannot be read: ${item.error}` })]
          : [
              item.done ? el("span", { class: "quiet", text: "done" }) : null,
              ...lines(item),
            ].filter(Boolean)),
    ),
  );
}

/** What comes, goes and moves, what edits lose their place, and what is this recording's own. @param {Line} item */
function lines({ comes_s: comes, goes_s: goes, moves_s: moves, newly_inapplicable: lost, own }) {
  const count = ({ length }) => (length === 1 ? "1 boundary" : `${length} boundaries`);
  const times = (list) => list.map((time) => timeText(time)).join(", ");
  const said = [
    comes.length ? ["comes", `+ ${count(comes)} at ${times(comes)} s`] : null,
    goes.length ? ["goes", `− ${count(goes)} at ${times(goes)} s`] : null,
    moves.length
      ? [
          "moves",
          `moves ${moves.map(([from, to]) => `${timeText(from)} → ${timeText(to)} s`).join(", ")}`,
        ]
      : null,
    ...lost.map((text) => ["lost", `no longer applies: ${text}`]),
    own.length ? ["quiet", `keeps its own ${own.join(", ")}`] : null,
  ].filter(Boolean);
  return (said.length ? said : [["quiet", "stays as it is"]]).map(([name, text]) =>
    el("span", { class: name, text }),
  );
}
