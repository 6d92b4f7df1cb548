/** What stands in the middle when there is nothing to draw: no recording, an unreadable one. The rows
 * of the timeline, which have no place yet, are not shown then. */

import { byId, el } from "../lib/dom.js";

/**
 * @param {import("../lib/store.js").Store} store
 * @param {any} actions
 * @param {{chooseFiles: () => void}} dialogs
 */
export function createEmpty(store, actions, dialogs) {
  const node = byId("empty");
  store.later(
    ["document", "recordings", "connected", "progress", "greeted", "record", "asked"],
    ({ document: doc, connected, record }) => {
      const content =
        doc || (record?.workcell && connected) ? null : contentFor(store.state, actions, dialogs);
      node.hidden = !content;
      byId("timeline").classList.toggle("vacant", !doc);
      document.documentElement.toggleAttribute("data-nothing-open", isVacant(store.state));
      node.classList.toggle("bad", Boolean(content?.bad));
      if (content) node.replaceChildren(...content.nodes);
    },
  );
}

/** Without any recording that can be read there is nothing to play, to plan or to read out. */
const isVacant = ({ document: doc, greeted, recordings, record, progress }) =>
  !doc &&
  greeted &&
  recordings.items.every(({ error }) => error) &&
  !record?.workcell &&
  (!progress || recordings.items.length > 0);

function contentFor(
  { recordings, connected, progress, greeted, lookingOnly, asked },
  actions,
  dialogs,
) {
  const { items } = recordings;
  if (!greeted) return connected ? null : notConnected();
  if (progress && !progress.done)
    return { nodes: [el("h2", { text: "Opening" }), el("p", { text: progress.name })] };
  if (!items.length) return noRecording(lookingOnly ? [] : firstSteps(actions, dialogs));
  const bad = items.filter(({ error }) => error);
  const broken = bad.find(({ id }) => id === asked) ?? bad[0];
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

/** What can be done without a recording, the likeliest first. */
function firstSteps(actions, { chooseFiles }) {
  const steps = [
    ["Open the demonstration", "primary", actions.openDemonstration],
    ["Choose files…", "", chooseFiles],
    ["Record one", "", actions.recordFirst],
  ];
  return steps.map(([text, look, run]) =>
    el("button", { type: "button", class: `button ${look}`, text, on: { click: run } }),
  );
}

function noRecording(buttons) {
  return {
    nodes: [
      el("h2", { text: "No recording is open" }),
      el("p", {
        text: "Drop recordings here: NPZ, CSV, bags, HDF5 and other files with time and position, and force, torque, orientation or joint angles where you have them. What a table does not say by itself, the page asks.",
      }),
      el(
        "p",
        {},
        "From a terminal: ",
        el("code", { text: "keyphase my_demonstration.npz" }),
        " or ",
        el("code", { text: "keyphase my_folder" }),
      ),
      el("div", { class: "buttons" }, ...buttons),
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
          text: "Say how it is read",
          on: { click: () => actions.describe(item.id) },
        }),
        el("button", {
          type: "button",
          class: "button",
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
