/** Files that are written of a recording, or of all. */

/**
 * @param {import("../lib/store.js").Store} store
 * @param {import("../model/types.js").Send} send
 */
export function createExportActions(store, send) {
  /** How the last one of each kind was asked for. @type {Map<string, Wish>} */
  const asked = new Map();
  return {
    /** What is in view as a recording of its own, which is opened; zoom to what is to stay. */
    cutToView() {
      const { view, lookingOnly } = store.state;
      if (view && !lookingOnly) send({ type: "cut", from_s: view.from, to_s: view.to });
    },
    /** Asks in which formats this recording can be written; the answer opens the choice. */
    chooseExport() {
      if (store.state.document && !store.state.lookingOnly) send({ type: "offers" });
    },
    /**
     * @typedef {{scope?: "this"|"picked"|"done"|"all", picked?: string[], trim_idle?: boolean}} Wish
     * @param {string} kind @param {Wish} [wish]
     */
    exportAs(kind, wish = {}) {
      if (!store.state.document) return;
      asked.set(kind, wish);
      if (send({ type: "export", kind, ...wish })) store.set({ saved: null, exporting: kind });
    },
    /**
     * Once more, after files were in the way.
     * @param {import("../messages/export_messages").InTheWayMessage} inTheWay
     * @param {"replace"|"keep both"} ifThere
     */
    exportAgain({ recording, kind }, ifThere) {
      const sent = send({ type: "export", ...asked.get(kind), recording, kind, if_there: ifThere });
      if (sent) store.set({ exporting: kind });
    },
  };
}
