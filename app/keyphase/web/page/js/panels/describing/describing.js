/**
 * How a recording is read that nobody has described yet, a table or a binary format: a person says
 * what each column is, sees the recording it makes, and reads it.
 *
 * @typedef {import("../../messages/import_messages").TableProposal} Proposal
 * @typedef {import("../../messages/import_requests").TableAnswers} Answers
 * @typedef {(patch: Partial<Answers>) => void} Change
 */

import { byId, el } from "../../lib/dom.js";
import { drawChannels } from "./channels.js";
import { drawColumns } from "./columns.js";
import { drawLayout } from "./layout.js";
import { drawLook } from "./look.js";
import { drawRecipe } from "./recipe.js";
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
    answers = { ...(answers ?? table.answers), text: "", ...patch };
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
    const before = dialog.querySelector(".describing-table");
    const [left, top] = [before?.scrollLeft ?? 0, before?.scrollTop ?? 0];
    const isOpen = dialog.querySelector("details")?.open ?? false;
    dialog.replaceChildren(...drawTable(table, change, confirm, leave));
    dialog.querySelector(".describing-table")?.scrollTo(left, top);
    dialog.querySelector("details")?.toggleAttribute("open", isOpen);
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
  const isWhole = table.looks.length > 0;
  const { preset } = table.answers;
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
    el("p", { class: "quiet", text: introduction(table) }),
    table.is_text && !preset && drawLayout(table, change),
    !preset && (table.is_text ? drawColumns(table, change) : drawChannels(table, change)),
    el(
      "div",
      { class: "describing-answers" },
      drawUnits(table, change),
      drawWrench(table, change),
      drawLook(table),
    ),
    drawRecipe(table, change),
    el(
      "div",
      { class: "buttons" },
      el("p", { class: "missing", role: "status", text: table.missing.join(" ") }),
      button("Cancel", false, leave),
      table.others > 0 &&
        button(
          `Read all ${table.others + 1} ${table.is_text ? "tables" : "files"} here so`,
          true,
          () => confirm("folder"),
          !isWhole,
        ),
      button("Read this one so", table.others === 0, () => confirm("file"), !isWhole),
    ),
  ];
  return nodes.filter((node) => node instanceof HTMLElement);
}

/** @param {Proposal} table */
function introduction({ answers: { preset }, others_inside: more }) {
  const several =
    more === 1
      ? " One more recording in the same file is read alike."
      : more > 1
        ? ` ${more} more recordings in the same file are read alike.`
        : "";
  if (preset)
    return (
      `All columns of ${preset} are there, which keyphase knows; only what that format does ` +
      `not say is asked.${several}`
    );
  return (
    "Nobody has said yet what its columns are. What is proposed comes from names and " +
    `numbers; nothing of it counts before you read the recording so.${several}`
  );
}
