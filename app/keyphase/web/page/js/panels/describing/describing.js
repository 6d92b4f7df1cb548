/**
 * How a table is read that nobody has described yet: a person says what each column is, sees the
 * recording it makes, and reads it.
 *
 * @typedef {import("../../messages/import_messages").TableProposal} Proposal
 * @typedef {import("../../messages/import_requests").TableAnswers} Answers
 * @typedef {(patch: Partial<Answers>) => void} Change
 */

import { byId, el } from "../../lib/dom.js";
import { drawColumns } from "./columns.js";
import { drawLayout } from "./layout.js";
import { drawLook } from "./look.js";
import { drawUnits } from "./units.js";
import { drawWrench } from "./wrench.js";

/**
 * @param {import("../../lib/store.js").Store} store
 * @param {import("../../model/types.js").Send} send
 */
export function createDescribing(store, send) {
  const dialog = /** @type {HTMLDialogElement} */ (byId("describing"));
  /** @type {Answers|null} what was chosen, ahead of what the server has tried */
  let answers = null;
  let shown = "";

  /** @type {Change} */
  function change(patch) {
    const [table] = store.state.tables;
    if (!table) return;
    answers = { ...(answers ?? table.answers), ...patch };
    send({ type: "describe_try", id: table.id, answers });
  }

  /** @param {"file"|"folder"} scope */
  function confirm(scope) {
    const [table] = store.state.tables;
    if (table)
      send({ type: "describe_confirm", id: table.id, answers: answers ?? table.answers, scope });
  }

  function leave() {
    const [table] = store.state.tables;
    if (table) send({ type: "describe_leave", id: table.id });
  }

  dialog.addEventListener("cancel", (event) => {
    event.preventDefault();
    leave();
  });

  store.on(["tables"], ({ tables: [table] }) => {
    if (!table) return dialog.open && dialog.close();
    if (table.id !== shown) answers = null;
    shown = table.id;
    const focused = /** @type {HTMLElement|null} */ (document.activeElement)?.dataset.field;
    const left = dialog.querySelector(".describing-table")?.scrollLeft ?? 0;
    dialog.replaceChildren(...drawTable(table, change, confirm, leave));
    const scrolled = dialog.querySelector(".describing-table");
    if (scrolled) scrolled.scrollLeft = left;
    if (!dialog.open) dialog.showModal();
    const again = focused && dialog.querySelector(`[data-field="${CSS.escape(focused)}"]`);
    if (again) /** @type {HTMLElement} */ (again).focus();
    return undefined;
  });
}

/**
 * @param {Proposal} table
 * @param {Change} change
 * @param {(scope: "file"|"folder") => void} confirm
 * @param {() => void} leave
 * @returns {HTMLElement[]}
 */
function drawTable(table, change, confirm, leave) {
  const isWhole = table.look !== null;
  const button = (text, primary, onClick, disabled = false) =>
    el("button", {
      type: "button",
      class: primary ? "button primary" : "button",
      text,
      disabled,
      data: { field: text },
      on: { click: onClick },
    });
  const nodes = [
    el("h2", { text: `How is ${table.name} read?` }),
    el("p", {
      class: "quiet",
      text:
        "Nobody has said yet what its columns are. What is proposed comes from names and " +
        "numbers; nothing of it counts before you read the recording so.",
    }),
    drawLayout(table, change),
    drawColumns(table, change),
    el(
      "div",
      { class: "describing-answers" },
      drawUnits(table, change),
      drawWrench(table, change),
      drawLook(table),
    ),
    table.recipe &&
      el(
        "details",
        {},
        el("summary", { text: "The recipe that is written beside it" }),
        el("pre", { text: table.recipe }),
      ),
    el(
      "div",
      { class: "buttons" },
      el("p", { class: "missing", role: "status", text: table.missing.join(" ") }),
      button("Cancel", false, leave),
      table.others > 0 &&
        button(
          `Read all ${table.others + 1} tables here so`,
          true,
          () => confirm("folder"),
          !isWhole,
        ),
      button("Read this one so", table.others === 0, () => confirm("file"), !isWhole),
    ),
  ];
  return nodes.filter((node) => node instanceof HTMLElement);
}
