/** The picture of trials, over the page until it is closed. */

import { el, icon } from "../lib/dom.js";

/** @param {{title: string, outcome: string, svg: string}} message */
export function showTrials({ title, outcome, svg: picture }) {
  document.querySelector("dialog.trials")?.remove();
  const close = () => dialog.remove();
  // As the source of an image a picture can run nothing.
  const source = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(picture)}`;
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
      el("img", { src: source, alt: `${title}: ${outcome}` }),
    )
  );
  document.body.append(dialog);
  dialog.showModal();
}
