/** Everything that can be written, the file each writes, and how the last one is read again. */

import { el, icon } from "../../lib/dom.js";
import { group } from "./fields.js";

/** Kind, what it is, the file's ending after the recording's name, what is in it. */
const SEGMENTS = [
  ["json", "Segment file", ".segments.json", "Boundaries, segments, end conditions and plan."],
  ["csv", "Table", ".segments.csv", "One line for each segment."],
  ["all", "All recordings", "", "A segment file beside each recording of the list."],
];
const SKILLS = [
  ["skills", "Skills", ".skills.json", "The skills as data."],
  [
    "behavior tree",
    "Behaviour tree",
    ".tree.xml",
    "For BehaviorTree.CPP, with its skills beside it.",
  ],
  ["program", "Program listing", ".program.txt", "The plan as text that people read."],
  ["urscript", "URScript", ".script", "Moves and contact moves for Universal Robots."],
  ["rapid", "RAPID", ".mod", "Moves and contact moves for ABB robots."],
];
const REPLAY = [
  ["page", "Shareable replay", ".replay.html", "One page that opens without a server."],
];

/**
 * @param {import("../../lib/store.js").Store} store
 * @param {any} actions
 */
export function createExportTab(store, actions) {
  const all = [...SEGMENTS, ...SKILLS, ...REPLAY].map((one) => exportButton(one, actions));
  const of = (kinds) =>
    all.filter(({ kind }) => kinds.some(([own]) => own === kind)).map(({ node }) => node);
  const replayed = el("p", {
    class: "hint",
    text: "Run the replay first; what it did is what is shared.",
  });
  store.later(["document", "replay", "lookingOnly"], ({ document: doc, replay, lookingOnly }) => {
    const over = replay?.phase === "over";
    replayed.hidden = over;
    for (const one of all) {
      one.node.disabled = lookingOnly || !doc || (one.kind === "page" && !over);
      one.file.textContent =
        doc && one.ending ? `${stem(doc.name)}${one.ending}` : one.file.dataset.text;
    }
  });
  return el(
    "div",
    { class: "panel-body" },
    createSavedCard(store, actions),
    group("Segments", {}, ...of(SEGMENTS)),
    group("Skills", {}, ...of(SKILLS)),
    group("Replay", {}, ...of(REPLAY), replayed),
  );
}

const stem = (name) => name.replace(/\.[^.]+$/, "");

/** @param {string[]} one kind, title, ending, hint */
function exportButton([kind, title, ending, hint], actions) {
  const text = ending ? `*${ending}` : "one beside each recording";
  const file = el("small", { data: { text }, text });
  const node = /** @type {HTMLButtonElement} */ (
    el(
      "button",
      {
        type: "button",
        class: "export",
        title: hint,
        data: { export: kind },
        on: { click: () => actions.exportAs(kind) },
      },
      icon("file"),
      el("span", {}, el("b", { text: title }), file),
    )
  );
  return { kind, ending, node, file };
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
    lines.textContent = readingLines(saved.path);
    lines.hidden = copyLines.hidden = lines.textContent === "";
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

/** Python that reads a file that was written; "" where there is nothing to say. @param {string} path */
export function readingLines(path) {
  const quoted = JSON.stringify(path);
  if (path.endsWith(".segments.json"))
    return `import keyphase\nfile = keyphase.read_segment_file(${quoted})\nprint([(s.start_s, s.end_s, s.label) for s in file.segments])`;
  if (path.endsWith(".csv"))
    return `import csv\nwith open(${quoted}, newline="") as file:\n    segments = list(csv.DictReader(file))`;
  if (path.endsWith(".json"))
    return `import json\nwith open(${quoted}) as file:\n    skills = json.load(file)`;
  return "";
}
