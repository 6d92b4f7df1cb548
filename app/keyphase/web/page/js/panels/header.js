/** The header: where am I, is it saved, what would undo undo. */

import { byId, icon } from "../lib/dom.js";
import { plural, time as timeText } from "../lib/format.js";
import { stateOf } from "../model/recordings/recording_list.js";

/**
 * @param {import("../lib/store.js").Store} store
 * @param {any} actions
 * @param {{openPalette: (query?: string, kind?: string) => void, openKeys: () => void}} dialogs
 */
export function createHeader(store, actions, dialogs) {
  const undo = /** @type {HTMLButtonElement} */ (byId("undo"));
  const redo = /** @type {HTMLButtonElement} */ (byId("redo"));
  byId("crumb").addEventListener("click", () => dialogs.openPalette("", "Recording"));
  byId("command-field").addEventListener("click", () => dialogs.openPalette());
  byId("help").addEventListener("click", dialogs.openKeys);
  byId("theme").addEventListener("click", actions.toggleTheme);
  undo.addEventListener("click", actions.undo);
  redo.addEventListener("click", actions.redo);

  store.later(["document"], ({ document: doc, readOnly }) => {
    document.title = doc ? `${doc.name} – keyphase` : "keyphase";
    byId("folder").textContent = doc?.folder ?? "";
    byId("folder").hidden = byId("folder-slash").hidden = !doc?.folder;
    byId("name").textContent = doc?.name ?? "no recording";
    byId("facts").textContent = doc ? facts(doc) : "";
    setUndo(undo, doc?.undo, "Undo", "Ctrl Z", readOnly);
    setUndo(redo, doc?.redo, "Redo", "Ctrl Shift Z", readOnly);
    byId("undo-name").textContent = doc?.undo ?? "";
  });
  byId("badge").addEventListener("click", actions.toggleDone);
  store.later(["document"], ({ document: doc }) => {
    const badge = byId("badge");
    badge.hidden = !doc;
    if (!doc) return;
    const state = stateOf(doc);
    badge.className = `badge ${{ done: "done", automatic: "plain" }[state] ?? ""}`;
    badge.textContent = doc.edits ? `${state} · ${plural(doc.edits, "edit")}` : state;
    badge.title = state === "done" ? "Not done after all" : "Done with it as it is now (K)";
  });
  store.later(["document", "connected", "saving", "readOnly"], drawSaved);
  store.later(["dark"], ({ dark }) => byId("theme").replaceChildren(icon(dark ? "moon" : "sun")));
}

function setUndo(button, name, verb, key, readOnly) {
  button.disabled = !name || readOnly;
  const what = name ? `${verb} “${name}” (${key})` : `Nothing to ${verb.toLowerCase()}`;
  button.title = what;
  button.setAttribute("aria-label", what);
}

/** @param {import("../model/types.js").Doc} doc */
function facts({
  start_s: start,
  end_s: end,
  rate_hz: rate,
  channels,
  wrench_estimated: estimated,
}) {
  const hertz =
    rate >= 1000 && rate % 1000 === 0 ? `${rate / 1000} kHz` : `${Number(rate.toPrecision(4))} Hz`;
  const long = end - start;
  const lasts = long >= 600 ? timeText(long, 0) : `${long.toFixed(2)} s`;
  const own = channels.filter((name) => !name.startsWith("channel/"));
  const more = channels.length - own.length;
  const shown = own.map((name) => (estimated && name === "force" ? "estimated force" : name));
  return `${lasts} · ${hertz} · ${[...shown, ...(more ? [`${more} more`] : [])].join(", ")}`;
}

/**
 * What became of the last edit; never "saved" before the server has said so.
 * @param {import("../lib/store.js").State} state
 */
function drawSaved({ document: doc, connected, saving, readOnly }) {
  const node = byId("saved");
  node.className = `saved ${connected ? (saving ? "waiting" : "") : "lost"}`;
  const text = !connected
    ? "Not connected"
    : readOnly
      ? "Read only"
      : saving
        ? "Saving"
        : doc?.saved_at || doc?.edits
          ? "Saved"
          : "No edits";
  byId("saved-text").textContent = text;
  byId("saved-at").textContent = connected && !saving && !readOnly ? (doc?.saved_at ?? "") : "";
}
