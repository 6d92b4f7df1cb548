/**
 * What the server wants to have said, over the scene, where nothing is pressed. Errors stay until
 * closed, the others as long as somebody is at them; what belongs to a recording ends with it. What
 * was only told gives way to the next that is.
 */

import { byId, el, icon } from "../../lib/dom.js";

const STAYS_MS = 7000;
const MOST = 3;
/** What asks for nothing: the newest says how things are now. */
const TOLD = ".info:not(:has(.link))";

/** @param {import("../../lib/store.js").Store} store */
export function createNotices(store) {
  const node = byId("notices");

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
    if (notice.matches(TOLD))
      node.querySelectorAll(`:scope > ${TOLD}`).forEach((one) => one.remove());
    node.append(notice);
    while (node.children.length > MOST) node.firstChild.remove();
    if (level !== "error") leaveLater(notice);
  }

  /** Gone after a while, but not under the pointer or from under the focus. @param {HTMLElement} notice */
  function leaveLater(notice) {
    setTimeout(() => {
      if (notice.matches(":hover, :focus-within")) leaveLater(notice);
      else notice.remove();
    }, STAYS_MS);
  }

  store.on(["recording"], ({ recording }) => {
    for (const notice of /** @type {HTMLElement[]} */ ([...node.children]))
      if (!notice.matches(".error") && notice.dataset.of !== recording) notice.remove();
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
