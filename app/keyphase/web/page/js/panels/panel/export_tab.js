/** What is written most often, the way to all other formats, and how the last one is read again. */

import { el, icon } from "../../lib/dom.js";
import { group } from "./fields.js";

/**
 * @param {import("../../lib/store.js").Store} store
 * @param {any} actions
 */
export function createExportTab(store, actions) {
  const own = exportButton("json", "Segment file", "Ctrl S", () => actions.exportAs("json"));
  const all = exportButton("all", "All recordings", "a segment file beside each", () =>
    actions.exportAs("json", { scope: "all" }),
  );
  const other = exportButton(
    "formats",
    "Other formats…",
    "tables, programs, datasets…",
    actions.chooseExport,
  );
  const page = exportButton("page", "Shareable replay", "*.replay.html", () =>
    actions.exportAs("page"),
  );
  const replayed = el("p", {
    class: "hint",
    text: "Run the replay first; what it did is what is shared.",
  });
  store.later(
    ["document", "replay", "lookingOnly", "greeted"],
    ({ document: doc, replay, lookingOnly }) => {
      const over = replay?.phase === "over";
      replayed.hidden = over;
      for (const { node } of [own, all, other, page]) node.disabled = lookingOnly || !doc;
      if (!over) page.node.disabled = true;
      if (doc) own.file.textContent = `${doc.name}.segments.json`;
      if (doc) page.file.textContent = `${doc.name}.replay.html`;
    },
  );
  return el(
    "div",
    { class: "panel-body" },
    createSavedCard(store, actions),
    group("Segments", {}, own.node, all.node, other.node),
    group("Replay", {}, page.node, replayed),
  );
}

/** @param {string} kind @param {string} title @param {string} text @param {() => void} run */
function exportButton(kind, title, text, run) {
  const file = el("small", { text });
  const node = /** @type {HTMLButtonElement} */ (
    el(
      "button",
      { type: "button", class: "export", data: { export: kind }, on: { click: run } },
      icon("file"),
      el("span", {}, el("b", { text: title }), file),
    )
  );
  return { node, file };
}

/**
 * Where the last one was written, and three lines that read it.
 * @param {import("../../lib/store.js").Store} store
 */
function createSavedCard(store, actions) {
  const path = el("code", { class: "path" });
  const lines = el("pre", { class: "lines" });
  const copyLines = copier("Copy these lines", () => lines.textContent, actions);
  const card = el(
    "section",
    { class: "saved-card", "aria-label": "Written", hidden: true },
    el(
      "header",
      {},
      icon("check"),
      el("b", { text: "Written" }),
      el("span", { class: "space" }),
      copier("Copy path", () => path.textContent, actions),
    ),
    path,
    lines,
    copyLines,
  );
  store.later(["saved", "document"], ({ saved, document: doc }) => {
    card.hidden = !saved || saved.recording !== doc?.id;
    if (card.hidden) return;
    path.textContent = saved.path;
    lines.textContent = saved.lines;
    lines.hidden = copyLines.hidden = !saved.lines;
  });
  return card;
}

function copier(text, what, actions) {
  return el("button", {
    type: "button",
    class: "link",
    text,
    on: { click: () => actions.copy(what()) },
  });
}
