/** What stands in the middle when there is nothing to draw: no recording, an unreadable one. The rows
 * of the timeline, which have no place yet, are not shown then. */

import { byId, el } from "../lib/dom.js";

/**
 * @param {import("../lib/store.js").Store} store
 * @param {any} actions
 */
export function createEmpty(store, actions) {
  const node = byId("empty");
  store.later(
    ["document", "recordings", "connected", "progress", "greeted", "workcell"],
    ({ document: doc, recordings, connected, progress, greeted, workcell }) => {
      const content =
        doc || (workcell && connected)
          ? null
          : contentFor(recordings, connected, progress, greeted, actions);
      node.hidden = !content;
      byId("timeline").classList.toggle("vacant", !doc);
      node.classList.toggle("bad", Boolean(content?.bad));
      if (content) node.replaceChildren(...content.nodes);
    },
  );
}

function contentFor({ items }, connected, progress, greeted, actions) {
  if (!greeted) return connected ? null : notConnected();
  if (progress && !progress.done)
    return { nodes: [el("h2", { text: "Opening" }), el("p", { text: progress.what })] };
  if (!items.length) return noRecording();
  const broken = items.find(({ error }) => error);
  if (broken) return unreadable(broken, items, actions);
  return { nodes: [el("h2", { text: "Opening" }), el("p", { text: items[0].name })] };
}

function notConnected() {
  return {
    bad: true,
    nodes: [
      el("h2", { text: "Not connected" }),
      el("p", {
        text: "The server does not answer. The page tries again by itself; nothing that was confirmed is lost.",
      }),
    ],
  };
}

function noRecording() {
  return {
    nodes: [
      el("h2", { text: "No recording is open" }),
      el(
        "p",
        {},
        "Open one from a terminal: ",
        el("code", { text: "keyphase my_demonstration.npz" }),
        " or ",
        el("code", { text: "keyphase my_folder" }),
        ", or drop a file here.",
      ),
      el("p", {
        text: "A recording is an NPZ or CSV file with time and position, and force, torque, orientation or joint angles where you have them. Other tables open with a recipe beside them.",
      }),
    ],
  };
}

function unreadable(item, items, actions) {
  const other = items.find(({ error }) => !error);
  return {
    bad: true,
    nodes: [
      el("h2", { text: `${item.name} cannot be read` }),
      el("p", { text: item.error }),
      el(
        "div",
        { class: "buttons" },
        el("button", {
          type: "button",
          class: "button primary",
          text: "Try again",
          on: { click: () => actions.open(item.id) },
        }),
        other
          ? el("button", {
              type: "button",
              class: "button",
              text: `Open ${other.name}`,
              on: { click: () => actions.open(other.id) },
            })
          : "",
      ),
    ],
  };
}
