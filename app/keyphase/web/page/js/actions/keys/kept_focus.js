/**
 * Whoever has the focus on something that is drawn anew keeps it: it goes to what has the same name
 * in the same region, or where that is gone to the timeline. Otherwise it would be on nothing, and a
 * reader of the screen at the top of the page.
 */

const REGIONS =
  "dialog[open], #why, #banners, #notices, #queue, #panel, #plan, #transport, #header";
const REACHED = 'button, input, select, summary, a[href], [tabindex]:not([tabindex="-1"])';

/** @param {HTMLElement} node */
const nameOf = (node) =>
  node.getAttribute("aria-label") ?? (node.textContent || node.title || node.id).trim();

/**
 * @param {import("../../lib/store.js").Store} store
 * @param {HTMLElement} fallback
 */
export function keepFocus(store, fallback) {
  /** @type {{node: HTMLElement, region: Element|null, name: string}|null} */
  let last = null;
  const isThere = (node) => node.isConnected && node.checkVisibility();
  addEventListener("focusin", ({ target }) => {
    const node = /** @type {HTMLElement} */ (target);
    last = { node, region: node.closest(REGIONS), name: nameOf(node) };
  });
  // Pressed on nothing, or let go by what had it and is still there, the focus was given up, not lost.
  addEventListener("pointerdown", () => (last = null));
  addEventListener("focusout", () =>
    queueMicrotask(() => {
      if (last && isThere(last.node) && document.activeElement === document.body) last = null;
    }),
  );

  function look() {
    if (!last || document.activeElement !== document.body) return;
    const { node, region, name } = last;
    if (isThere(node)) return;
    last = null;
    const found = /** @type {HTMLElement[]} */ ([...(region?.querySelectorAll(REACHED) ?? [])]);
    const same = found.find((one) => nameOf(one) === name && one.checkVisibility());
    const dialog = document.querySelector("dialog[open]");
    const inDialog = /** @type {HTMLElement|null|undefined} */ (dialog?.querySelector(REACHED));
    (same ?? inDialog ?? fallback).focus({ preventScroll: true });
  }
  store.later(Object.keys(store.state), look);
}
