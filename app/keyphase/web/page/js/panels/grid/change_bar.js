/** What a change of a phase would do to all recordings, before it is made. */

import { el } from "../../lib/dom.js";
import { plural } from "../../lib/format.js";
import { effectOf } from "../../model/recordings/grid.js";

/**
 * @param {import("../../lib/store.js").Store} store
 * @param {any} actions
 * @param {() => void} changed told when the box was ticked or not
 */
export function createChangeBar(store, actions, changed) {
  const told = el("p", { role: "status" });
  const box = /** @type {HTMLInputElement} */ (
    el("input", { type: "checkbox", on: { change: changed } })
  );
  const boxText = el("span", {});
  const withDone = el("label", {}, box, boxText);
  const apply = /** @type {HTMLButtonElement} */ (
    el("button", {
      type: "button",
      class: "button primary",
      text: "Apply to all",
      on: { click: () => actions.applyInAll(box.checked) },
    })
  );
  const cancel = el("button", {
    type: "button",
    class: "button",
    text: "Cancel",
    on: { click: () => actions.considerInAll(null) },
  });
  const node = el(
    "div",
    { class: "grid-change", hidden: true },
    told,
    withDone,
    el("div", { class: "buttons" }, apply, cancel),
  );

  /** @param {import("../../lib/store.js").State} state */
  function draw({ grid, gridChange: change }) {
    const begins = node.hidden && change;
    node.hidden = !change || !grid;
    if (!change || !grid) return;
    if (begins) box.checked = false;
    const { changing, done, following } = effectOf(grid, change, box.checked);
    withDone.hidden = !done.length;
    boxText.textContent = `Also the ${done.length} that ${done.length === 1 ? "is" : "are"} done; ${done.length === 1 ? "it stays" : "they stay"} done`;
    const waiting = grid.rows.filter(({ standing }) => standing === "waiting").length;
    told.textContent = [
      change.to === null
        ? `Drop “${change.label}”:`
        : `Rename “${change.label}” to “${change.to}”:`,
      `${plural(changing.length, "recording")} of ${grid.rows.length} would change.`,
      following
        ? `${following} only proposed: ${following === 1 ? "it follows" : "they follow"} those that are done.`
        : "",
      waiting ? `${waiting} not looked at yet; wait.` : "",
    ].join(" ");
    apply.disabled = waiting > 0 || !changing.length;
    if (begins) (apply.disabled ? cancel : apply).focus();
  }
  store.on(["grid", "gridChange"], draw);
  return { node, includeDone: () => box.checked, draw };
}
