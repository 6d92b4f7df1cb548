/** The picture of trials, over the page until it is closed. */

import { el, icon } from "../../lib/dom.js";

/**
 * @param {string} source of the picture
 * @param {string} told what is seen on it
 */
export function showTrialsPicture(source, told) {
  document.querySelector("dialog.trials")?.remove();
  const close = () => dialog.remove();
  const dialog = /** @type {HTMLDialogElement} */ (
    el(
      "dialog",
      { class: "trials", "aria-label": "Trials", on: { close } },
      el(
        "header",
        {},
        el("b", { text: "Trials" }),
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
