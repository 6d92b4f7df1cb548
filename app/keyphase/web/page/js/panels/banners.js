/** What a person has to decide about a recording, in lines below the header. */

import { byId, el } from "../lib/dom.js";
import { plural } from "../lib/format.js";

const MOST = 3;
/** A small window has no room for more. */
const MOST_IN_SMALL = 1;

/**
 * @param {import("../lib/store.js").Store} store
 * @param {any} actions
 */
export function createBanners(store, actions) {
  const node = byId("banners");
  store.later(["document", "lookingOnly", "small", "connected", "following"], (state) => {
    const { document: doc, lookingOnly, small, connected } = state;
    const most = small ? MOST_IN_SMALL : MOST;
    const gone = doc !== null && connected === false;
    document.documentElement.toggleAttribute("data-gone", gone);
    const lines = gone
      ? [serverGone(state, actions)]
      : doc
        ? [
            ...followed(state, actions),
            ...toDecide(doc, lookingOnly, actions),
            ...inapplicable(doc, actions, most),
          ]
        : [];
    const before = node.children.length;
    node.replaceChildren(...lines);
    // Lines come and go at the cost of the scene; the timeline keeps its height.
    if (before !== lines.length) dispatchEvent(new Event("resize"));
  });
}

/**
 * The server has stopped, or cannot be reached; the page comes back by itself.
 * @param {import("../lib/store.js").State} state
 * @param {any} actions
 */
function serverGone({ document: doc, lostAt, command }, actions) {
  const until = doc.saved_at ?? lostAt?.toTimeString().slice(0, 8);
  const text = `keyphase stopped. Everything up to ${until} is saved. Waiting for it to come back.`;
  const lost = line(text, command && button("Copy the command", () => actions.copy(command)));
  lost.classList.add("gone");
  lost.setAttribute("role", "alert");
  return lost;
}

/** Whose page this one goes with. @param {import("../lib/store.js").State} state @param {any} actions */
function followed({ following, recordings }, actions) {
  if (!following) return [];
  const pages = recordings.items.flatMap((item) => item.pages);
  const name = pages.find(({ id }) => id === following)?.name ?? "another page";
  return [
    line(
      `Following ${name}.`,
      button("Stop following", () => actions.follow(null)),
    ),
  ];
}

/** @param {import("../model/types.js").Doc} doc @param {boolean} lookingOnly @param {any} actions */
function toDecide(doc, lookingOnly, actions) {
  const lines = [];
  if (lookingOnly) lines.push(line("This link is for looking: nothing can be changed here."));
  else if (doc.locked) lines.push(line(`Read only: ${doc.locked}.`));
  if (doc.elsewhere && !lookingOnly && !doc.locked) {
    const { name, steps, done } = doc.elsewhere;
    lines.push(
      line(
        `The same recording was labeled as ${name} (${plural(steps, "edit")}${done ? ", done" : ""}). ` +
          "Was it renamed or moved?",
        button("Take the edits over", actions.takeJournal, "primary"),
      ),
    );
  }
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

/**
 * Edits whose place is gone under the present parameters.
 * @param {import("../model/types.js").Doc} doc
 * @param {any} actions
 * @param {number} most
 */
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
