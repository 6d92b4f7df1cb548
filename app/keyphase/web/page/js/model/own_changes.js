/**
 * Keeps what this page's person did and holds drawn until the server has told it back: edits over
 * the document, values of parameters over those in force.
 */

import { stillPending, withPending } from "./pending.js";

/**
 * @param {import("../lib/store.js").Store} store
 */
export function createOwnChanges(store) {
  const { state } = store;
  /** @type {import("./types.js").Doc|null} as the server told it */
  let told = null;
  /** @type {Map<string, number>} the event with which a parameter was let go */
  let letGo = new Map();

  /** @type {(number|null)[]} what was selected here and not told back yet, the last one last */
  let selected = [];

  const show = (pending) => store.set({ pending, document: withPending(told, pending) });

  /** Parameters up to an event are the document's again. */
  function release(event) {
    const done = [...letGo].filter(([, at]) => at <= event).map(([name]) => name);
    if (!done.length) return;
    for (const name of done) letGo.delete(name);
    store.set({
      held: Object.fromEntries(Object.entries(state.held).filter(([name]) => !done.includes(name))),
    });
  }

  function forget() {
    letGo = new Map();
    selected = [];
    store.set({ held: {}, ghost: [] });
    show([]);
  }

  return {
    /** The person selected a segment, or none. @param {number|null} segment */
    selecting: (segment) => void selected.push(segment),
    /**
     * What to show as selected, of what the server told: not what was selected here before
     * something else was, which is on its way.
     * @param {number|null} segment
     */
    selectedNow(segment) {
      const at = selected.indexOf(segment);
      selected = at < 0 ? [] : selected.slice(at + 1);
      return selected.length ? state.selected : segment;
    },
    /** The person made an edit. @param {number} event @param {import("./types.js").Edit} edit */
    edited: (event, edit) => show([...state.pending, { event, edit }]),
    /** The person moved a parameter, and holds it still or has let it go. */
    moved(event, name, value, held) {
      if (held) letGo.delete(name);
      else letGo.set(name, event);
      store.set({ held: { ...state.held, [name]: value } });
    },
    /**
     * The server told a document that contains this page's events up to `event` (null: none new).
     * @param {import("./types.js").Doc} doc
     * @param {number|null} event
     */
    arrived(doc, event) {
      const other = told?.id !== doc.id;
      told = doc;
      if (other) return forget();
      if (event !== null) release(event);
      return show(event === null ? state.pending : stillPending(state.pending, event));
    },
    /** The server would not do it: that one event, or null for whatever is pending. */
    refused(event) {
      if (event === null) return forget();
      if ([...letGo.values()].includes(event)) release(event);
      return show(state.pending.filter((one) => one.event !== event));
    },
    /** No recording is open. */
    closed() {
      told = null;
      forget();
    },
    forget,
  };
}
