/** What a person has to decide about a recording, in lines below the header. */

import { byId, el } from "../lib/dom.js";

const MOST = 3;
/** A small window has no room for more. */
const MOST_IN_SMALL = 1;

/**
 * @param {import("../lib/store.js").Store} store
 * @param {any} actions
 */
export function createBanners(store, actions) {
  const node = byId("banners");
  store.later(["document", "lookingOnly", "small"], ({ document: doc, lookingOnly, small }) => {
    const most = small ? MOST_IN_SMALL : MOST;
    const lines = doc
      ? [...state(doc, lookingOnly, actions), ...inapplicable(doc, actions, most)]
      : [];
    const before = node.children.length;
    node.replaceChildren(...lines);
    // Lines come and go at the cost of the scene; the timeline keeps its height.
    if (before !== lines.length) dispatchEvent(new Event("resize"));
  });
}

function state(doc, lookingOnly, actions) {
  const lines = [];
  if (lookingOnly) lines.push(line("This link is for looking: nothing can be changed here."));
  else if (doc.locked) lines.push(line(`Read only: ${doc.locked}.`));
  if (doc.changed && !lookingOnly && !doc.locked) {
    lines.push(
      line(
        "The recording has changed since it was labeled. Its labels are still there; look whether " +
          "they fit.",
        button("Keep them", actions.keepLabels, "primary"),
        button("Start over", actions.startOver),
      ),
    );
  }
  return lines;
}

/** Edits whose place is gone under the present parameters. */
function inapplicable({ inapplicable: lost }, actions, most) {
  const more = lost.length - most;
  return lost.slice(0, most).map(({ edit, text }, k) =>
    line(
      `This edit no longer applies: ${text}`,
      button("Bring back", () => actions.bringBack(edit)),
      button("Forget", () => actions.forget(edit)),
      more > 0 && k === most - 1 && el("span", { class: "quiet", text: `and ${more} more` }),
    ),
  );
}

function line(text, ...buttons) {
  return el("div", { class: "banner" }, el("span", { text }), ...buttons);
}

function button(text, run, style = "") {
  return el("button", {
    type: "button",
    class: `button ${style}`,
    text,
    on: { click: run },
  });
}
