/** What the server says, put into the page's state. */

import { followed } from "./held.js";
import { withGrid } from "./recordings/grid.js";
import { takeWith } from "./recordings/take.js";

/**
 * @param {import("../lib/store.js").Store} store
 * @param {{latency: any, playback: any, notices: any, signals: any, replay: any, upload: () => any,
 *   own: ReturnType<typeof import("./own_changes.js").createOwnChanges>, describe: (id: string) => void}} parts
 * @returns {(message: import("./types.js").Message) => void}
 */
export function createReceiver(
  store,
  { latency, playback, notices, signals, replay, upload, own, describe },
) {
  const { state } = store;
  let client = "";
  /** @type {Map<number, import("../messages/list_messages").TaskMessage>} */
  const tasks = new Map();

  /** @type {{[M in import("./types.js").Message as M["type"]]?: (message: M) => void}} */
  const hear = {
    hello(message) {
      client = message.client;
      store.set({
        greeted: true,
        lookingOnly: message.read_only,
        // What is still shown from before can be changed once the server has it open again.
        readOnly: message.read_only || state.document !== null,
        defaults: message.defaults,
        command: message.command,
      });
      tasks.clear();
      store.set({ tables: [] });
    },
    recordings(message) {
      store.set({ recordings: message });
      if (!message.items.length) own.closed();
    },
    record: (message) => store.set({ record: message, take: takeWith(state.take, message) }),
    replay_settings: (message) => store.set({ replaySettings: message }),
    robot: (message) => store.set({ robot: message }),
    following: (message) => store.set({ following: message.page }),
    push: (message) => store.set({ pushOffered: message.offered }),
    shown: ({ parts: shown }) => store.set({ shown }),
    trials_run(message) {
      store.set({ trials: message });
      if (message.over && message.svg)
        notices.show({
          level: "info",
          text: message.outcome,
          act: { text: "Show", run: () => store.set({ tab: "replay", drawer: "panel" }) },
        });
    },
    margin_run(message) {
      store.set({ margin: message });
    },
    document(message) {
      const before = state.document;
      const other = before?.id !== message.id;
      const selected = other ? message.selected : own.selectedNow(message.selected);
      store.set({
        recording: message.id,
        method: message.parameters.variant,
        selected,
        saving: false,
        readOnly: state.lookingOnly || Boolean(message.locked),
        labels: message.labels,
        ...(selected === state.selected ? {} : { selectedTo: null }),
        ...(other ? { ...fresh(message), ...withoutResults(state) } : followed(state, message)),
      });
      own.arrived(message, message.cause?.client === client ? message.cause.event : null);
      if (other) signals.refresh();
      latency.arrived(message, (cause) => cause.client === client);
    },
    ghost: (message) => store.set({ ghost: message.boundaries }),
    playhead: (message) => playback.receive(message),
    selection({ segment: told }) {
      const segment = own.selectedNow(told);
      if (segment !== state.selected) store.set({ selected: segment, selectedTo: null });
    },
    others: ({ pages }) => store.set({ others: pages }),
    task(message) {
      if (message.done) tasks.delete(message.id);
      else tasks.set(message.id, message);
      store.set({ progress: [...tasks.values()].at(-1) ?? null });
    },
    nothing: () => own.closed(),
    cameras(message) {
      if (message.recording === state.recording) store.set({ cameras: message });
    },
    comparison(message) {
      if (message.recording === state.recording) store.set({ comparison: message });
    },
    lanes(message) {
      if (message.recording === state.recording) store.set({ lanes: message.lanes });
    },
    ...aboutFiles(store, upload, notices),
    grid: (message) => state.gridShown && store.set({ grid: withGrid(state.grid, message) }),
    spread: (message) => store.set({ spread: state.lookingOnly ? null : message }),
    replay: (message) => store.set({ replay: message }),
    replay_closed: () => store.set({ replay: null, samples: null, replayView: null }),
    replay_samples: (message) => replay.samples(message),
    refused(message) {
      store.set({ saving: false, exporting: null, refusals: state.refusals + 1 });
      own.refused(message.event);
      notices.show({ level: "warning", text: refusalText(state, message) });
    },
    notice(message) {
      store.set({ saving: false, exporting: null });
      if (message.level !== "info") own.refused(null);
      if (standsInTheMiddle(state, message)) return;
      notices.show({ ...message, act: wayOn(state, message, describe) });
    },
  };

  return (message) => /** @type {(message: any) => void} */ (hear[message.type])?.(message);
}

/**
 * What the server says of files that were sent or written, and of tables nobody has described yet.
 * @param {import("../lib/store.js").Store} store
 * @param {() => any} upload
 * @param {any} notices
 * @returns {{[M in import("./types.js").Message as M["type"]]?: (message: M) => void}}
 */
function aboutFiles(store, upload, notices) {
  const { state } = store;
  return {
    upload_ready: (message) => upload().heard(message),
    upload_refused: (message) => upload().heard(message),
    upload_cancelled: (message) => upload().heard(message),
    uploaded(message) {
      upload().heard(message);
      notices.show({ level: "info", text: `${message.name} has arrived.` });
    },
    table(message) {
      if (!state.tables.some(({ id }) => id === message.id)) upload().heard(message);
      store.set({ tables: withTable(state.tables, message) });
    },
    table_done({ id: done }) {
      store.set({ tables: state.tables.filter(({ id }) => id !== done) });
    },
    in_the_way: (message) => store.set({ inTheWay: message, exporting: null }),
    offers(message) {
      if (message.recording === state.recording) store.set({ offers: message });
    },
    saved({ path, reads_back: lines }) {
      store.set({ saved: { path, lines, recording: state.recording }, exporting: null });
      notices.show({ level: "info", text: `Written to ${path}` });
    },
  };
}

/**
 * What belongs to one recording only and begins anew with another.
 * @param {import("./types.js").Doc} doc
 */
function fresh(doc) {
  return {
    view: { from: doc.start_s, to: doc.end_s },
    whole: null,
    fine: null,
    viewBefore: null,
    hovered: null,
    candidate: null,
    current: null,
    explained: null,
    selectedTo: null,
    pointer: null,
    drag: null,
    range: null,
    planDrag: null,
    ghost: [],
    renaming: null,
    comparison: null,
    lanes: [],
    spread: null,
    offers: null,
    cameras: null,
  };
}

/** Whether the card of a recording that cannot be read says the same. */
const standsInTheMiddle = ({ document: doc, record, recordings }, { text }) =>
  !doc && !record?.workcell && recordings.items.some(({ error }) => error === text);

/** What can be done where the notice says that a recording cannot be read. */
function wayOn({ recordings, lookingOnly }, { text }, describe) {
  const broken = recordings.items.find(({ error }) => error === text);
  if (!broken || lookingOnly) return undefined;
  return { text: "Say how it is read", run: () => describe(broken.id) };
}

/** What came of trials ends with its recording; what is on its way goes on. */
const withoutResults = ({ trials, margin }) => ({
  trials: trials?.over ? null : trials,
  margin: margin?.over ? null : margin,
});

/**
 * Why something was not done; where that is not seen on the page, also with what recording.
 * @param {import("../lib/store.js").State} state
 * @param {import("../messages/list_messages").Refused} refused
 */
function refusalText({ recording, recordings }, { recording: about, text }) {
  if (about === null || about === recording) return text;
  const name = recordings.items.find(({ id }) => id === about)?.name;
  return name ? `${name}: ${text}` : text;
}

/**
 * The tables that are asked about, with one of them new or answered anew.
 * @template {{id: unknown}} T
 * @param {T[]} tables
 * @param {T} table
 */
function withTable(tables, table) {
  if (!tables.some(({ id }) => id === table.id)) return [...tables, table];
  return tables.map((one) => (one.id === table.id ? table : one));
}
