/** Keys, in our page and in the scene's frame alike. */

import { keyOf } from "./commands.js";

/**
 * @param {import("../../lib/store.js").Store} store
 * @param {any} actions
 * @param {import("./commands.js").Command[]} commands
 * @param {ReturnType<typeof import("./held_label.js").createHeldLabel>} heldLabel
 * @param {() => boolean} escape gives up whatever is open; false if nothing was
 * @returns {(event: KeyboardEvent) => void}
 */
export function createKeys(store, actions, commands, heldLabel, escape) {
  const byKey = new Map(commands.flatMap((command) => command.keys.map((key) => [key, command])));

  return function onKey(event) {
    if (event.defaultPrevented || event.isComposing) return;
    if (event.altKey && (event.ctrlKey || event.shiftKey || store.state.replay)) return;
    if (isTyping(event) || document.querySelector("dialog[open]")) return;
    if (event.key === "Escape") {
      if (escape()) event.preventDefault();
      return;
    }
    if (isPressable(event) || isSliding(event)) return;
    const key = keyOf(event);
    const { document: doc } = store.state;
    if (/^[1-9]$/.test(key)) {
      if (doc && !heldLabel.press(event, Number(key))) actions.labelByNumber(Number(key));
      return;
    }
    const command = byKey.get(key);
    if (!command || (!doc && !command.always)) return;
    event.preventDefault();
    command.run();
  };
}

/**
 * A button or a row of the list that was clicked gives the focus back, so that Space plays and Enter
 * accepts as the keys say, and do not press it again. One that was pressed by a key keeps it.
 * @param {MouseEvent} event
 * @param {HTMLElement} to
 */
export function letGoOfButton({ detail, target }, to) {
  const button = /** @type {HTMLElement|null} */ (
    /** @type {HTMLElement} */ (target)?.closest?.("button, summary, input[type=checkbox]")
  );
  const isButton = button && button === document.activeElement && !button.closest("dialog, form");
  const row = /** @type {HTMLElement} */ (target)?.closest?.("#queue-rows [role=option]");
  if (!detail || !(isButton || row)) return;
  to.focus({ preventScroll: true });
  // While a replay is shown the timeline is not.
  if (document.activeElement === button) button?.blur();
}

const TEXT_FIELDS =
  'input:not([type="range"], [type="checkbox"]), textarea, select, [contenteditable]';

/** Whether the key belongs to a field that takes text or a choice; one just closed has it no more. */
function isTyping({ target }) {
  const field = /** @type {HTMLElement} */ (target)?.closest?.(TEXT_FIELDS);
  return Boolean(field && !field.closest("dialog:not([open]), [hidden]"));
}

const SLIDES = ["Home", "End", "PageUp", "PageDown"];

/** A slider that has the focus moves by these keys. */
function isSliding({ key, target }) {
  return SLIDES.includes(key) && target instanceof HTMLInputElement && target.type === "range";
}

/** Space and Enter press the button that has the focus. */
function isPressable({ key, target }) {
  const node = /** @type {HTMLElement} */ (target);
  return (
    (key === " " || key === "Enter") &&
    Boolean(node?.closest?.('button, [role=tab], summary, a, input[type="checkbox"]'))
  );
}
