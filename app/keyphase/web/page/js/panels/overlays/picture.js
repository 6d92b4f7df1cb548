/** The picture of trials or of a margin, over the page until it is closed. */

import { el, icon } from "../../lib/dom.js";

/**
 * @param {string} title
 * @param {string} source of the picture
 * @param {string} told what is seen on it
 */
export function showPicture(title, source, told) {
  document.querySelector("dialog.picture")?.remove();
  const close = () => dialog.remove();
  const dialog = /** @type {HTMLDialogElement} */ (
    el(
      "dialog",
      { class: "picture", "aria-label": title, on: { close } },
      el(
        "header",
        {},
        el("b", { text: title }),
        el("span", { class: "space" }),
        el(
          "button",
          {
            type: "button",
            class: "tool",
            title: "Close",
            "aria-label": "Close",
            on: { click: close },
          },
          icon("close"),
        ),
      ),
      el("img", { src: source, alt: told }),
    )
  );
  document.body.append(dialog);
  dialog.showModal();
}
