/**
 * What the server wants to have said, over the scene, where nothing is pressed. Errors stay until
 * closed, the others as long as somebody is at them; what belongs to a recording ends with it. What
 * was only told gives way to the next that is.
 */

import { byId, el, icon } from "../../lib/dom.js";

const STAYS_MS = 7000;
/** Somebody who reads it for the first time takes so long for a letter. */
const READ_MS = 70;
/** What can be pressed is not gone before it is understood. */
const PRESSED_MS = 20_000;
const MOST = 3;
/** What asks for nothing: the newest says how things are now. */
const TOLD = ".info:not(:has(.link))";

/** @param {import("../../lib/store.js").Store} store */
export function createNotices(store) {
  const node = byId("notices");

  /** @param {string} which @returns {HTMLElement[]} */
  const all = (which) =>
    /** @type {HTMLElement[]} */ ([...node.querySelectorAll(`:scope > ${which}`)]);

  /**
   * @param {{level: string, text: string, act?: {text: string, run: () => void}, of?: string}} notice
   *   `of`: the recording it is for, where that is still on its way
   */
  function show({ level, text, act, of = "" }) {
    const same = [...node.children].find((notice) => notice.firstElementChild.textContent === text);
    same?.remove();
    const notice = el("div", { class: `notice ${level}`, data: { of } }, el("span", { text }));
    const close = el(
      "button",
      {
        type: "button",
        title: "Close",
        "aria-label": "Close",
        on: { click: () => notice.remove() },
      },
      icon("close", "small"),
    );
    if (act) {
      const run = () => {
        notice.remove();
        act.run();
      };
      notice.append(
        el("button", { type: "button", class: "link", text: act.text, on: { click: run } }),
      );
    }
    notice.append(close);
    if (notice.matches(TOLD)) for (const one of all(TOLD)) one.remove();
    node.append(notice);
    while (node.children.length > MOST) node.firstChild.remove();
    const stays = Math.max(STAYS_MS, READ_MS * text.length, act ? PRESSED_MS : 0);
    if (level !== "error") leaveLater(notice, stays);
  }

  /** Gone after a while, but not under the pointer or from under the focus. @param {HTMLElement} notice @param {number} stays [ms] */
  function leaveLater(notice, stays) {
    setTimeout(() => {
      if (notice.matches(":hover, :focus-within")) leaveLater(notice, STAYS_MS);
      else notice.remove();
    }, stays);
  }

  store.on(["recording"], ({ recording }) => {
    for (const notice of all(":not(.error)")) if (notice.dataset.of !== recording) notice.remove();
  });
  let led = /** @type {string|null} */ (null);
  store.on(["record"], ({ record }) => {
    const workcell = record?.workcell ?? null;
    // What is led by hand stands where notices are.
    if (workcell && workcell !== led) for (const one of all(":not(.error)")) one.remove();
    led = workcell;
  });
  store.on(["notice"], ({ notice }) => {
    if (notice) show(notice);
  });
  /** The newest one is closed. @returns {boolean} whether there was any */
  function close() {
    const newest = node.lastElementChild;
    newest?.remove();
    return Boolean(newest);
  }
  return { show, close };
}
