/** Files dropped on the page or chosen are sent to the server in pieces, one file at a time. */

import { byId, el, icon } from "../lib/dom.js";
import { droppedFiles } from "./dropped.js";

/**
 * What the server says of a file.
 * @typedef {Extract<import("../model/types.js").Message, {type: "uploaded"|`upload_${string}`}>} UploadMessage
 */

const PIECE_BYTES = 256 * 1024;
/** No more than this waits in the browser, so that a large file does not fill its memory. */
const WAITING_BYTES = 4 * PIECE_BYTES;
const KINDS =
  ".npz,.csv,.tsv,.txt,.dat,.log,.asc,.hdf5,.h5,.zip,.bag,.mcap,.mat,.npy,.parquet,.json,.toml";

/** Notes and settings lie beside recordings, too. */
const BESIDE = [".json", ".toml", ".txt", ".log"];
const RECORDINGS = KINDS.split(",").filter((kind) => !BESIDE.includes(kind));

/** Whether a file of a folder that was dropped is a recording. @param {string} name */
const isRecording = (name) =>
  !name.startsWith(".") && RECORDINGS.some((kind) => name.toLowerCase().endsWith(kind));

/**
 * @param {import("../lib/store.js").Store} store
 * @param {import("../lib/socket.js").Socket} socket
 * @param {any} actions
 */
export function createUpload(store, socket, actions) {
  const target = byId("drop-target");
  const input = createInput();
  /** @type {File[]} */
  const waiting = [];
  let sending = false;
  let cancelled = false;
  /** @type {(message: UploadMessage) => void} */
  let hear = () => {};
  /** @returns {Promise<UploadMessage>} */
  const answer = () => new Promise((resolve) => (hear = resolve));

  input.addEventListener("change", () => {
    add(input.files ?? []);
    input.value = "";
  });
  byId("add-recording").addEventListener("click", () => input.click());
  store.later(["lookingOnly"], ({ lookingOnly }) => (byId("add-recording").hidden = lookingOnly));

  watchDrops(store, target, async (transfer) => {
    const { files, refused } = await droppedFiles(transfer, isRecording);
    if (refused.length) store.set({ notice: { level: "warning", text: refused.join(" ") } });
    add(files);
  });

  function add(files) {
    waiting.push(...files);
    if (!sending) sendAll();
  }

  async function sendAll() {
    sending = true;
    for (let file = waiting.shift(); file; file = waiting.shift()) {
      store.set({ sending: { name: file.name, fraction: 0, more: waiting.length } });
      tell(store, actions, file, await send(file));
    }
    sending = cancelled = false;
    store.set({ sending: null });
  }

  /** Sends one file and waits for what the server says to it. @param {File} file @returns {Promise<UploadMessage>} */
  async function send(file) {
    const lost = /** @type {const} */ ({
      type: "upload_refused",
      text: `The connection broke while ${file.name} was sent; drop it again.`,
    });
    const first = answer();
    if (!socket.send({ type: "upload", name: file.name, size: file.size })) return lost;
    const greeting = await first;
    if (greeting.type !== "upload_ready") return greeting;
    let isOver = false;
    const last = answer().finally(() => (isOver = true));
    for (let at = 0; at < file.size && !isOver && !cancelled; at += PIECE_BYTES) {
      const piece = await file.slice(at, at + PIECE_BYTES).arrayBuffer();
      await socket.roomFor(WAITING_BYTES);
      if (isOver || cancelled) break;
      if (!socket.sendPiece(piece)) return lost;
      store.set({
        sending: { name: greeting.name, fraction: at / file.size, more: waiting.length },
      });
    }
    return last;
  }

  /** Gives up the file on its way and those that wait. @returns {boolean} whether there were any */
  function cancel() {
    if (!sending || cancelled) return false;
    cancelled = true;
    waiting.length = 0;
    socket.send({ type: "upload_cancel" });
    return true;
  }
  createSending(store, cancel);

  return {
    choose: () => input.click(),
    cancel,
    /** What the server says to a file: ready, refused, or uploaded. */
    heard: (message) => hear(message),
    /** The connection is gone, and with it what was on its way. */
    broke: () =>
      hear({
        type: "upload_refused",
        text: "The connection broke while a file was sent; drop it again.",
      }),
  };
}

/**
 * What is being sent, how far it is, and how to stop that; below the list of recordings.
 * @param {import("../lib/store.js").Store} store
 */
function createSending(store, cancel) {
  const name = el("span", { class: "queue-name" });
  const share = el("span", { class: "quiet" });
  const bar = el("i");
  const stop = el(
    "button",
    {
      type: "button",
      class: "tool",
      title: "Do not send it (Esc)",
      "aria-label": "Do not send it",
      on: { click: cancel },
    },
    icon("close", "small"),
  );
  const node = byId("sending");
  node.append(name, share, stop, el("div", { class: "progress" }, bar));
  store.on(["sending"], ({ sending }) => {
    node.hidden = !sending;
    if (!sending) return;
    name.textContent = `Sending ${sending.name}`;
    name.title = sending.name;
    const percent = `${Math.floor(100 * sending.fraction)} %`;
    share.textContent = sending.more ? `${percent}, ${sending.more} more` : percent;
    bar.style.setProperty("width", percent.replace(" ", ""));
  });
}

/**
 * Takes files that are dropped on the page or on the scene.
 * @param {import("../lib/store.js").Store} store
 * @param {HTMLElement} target what shows that they can be
 * @param {(transfer: DataTransfer) => void} add
 */
function watchDrops(store, target, add) {
  /** Lets files be dropped on a window: ours, and that of the scene's frame. */
  function watch(where) {
    const drops = (event) =>
      !store.state.lookingOnly && event.dataTransfer?.types.includes("Files");
    where.addEventListener("dragover", (event) => {
      if (!drops(event)) return;
      event.preventDefault();
      target.hidden = false;
    });
    where.addEventListener("dragleave", (event) => {
      if (!event.relatedTarget) target.hidden = true;
    });
    where.addEventListener("drop", (event) => {
      target.hidden = true;
      if (!drops(event)) return;
      event.preventDefault();
      add(event.dataTransfer);
    });
  }
  watch(window);
  const frame = /** @type {HTMLIFrameElement} */ (byId("viser"));
  frame.addEventListener("load", () => frame.contentWindow && watch(frame.contentWindow));
}

/**
 * What became of a file.
 * @param {import("../lib/store.js").Store} store
 * @param {any} actions
 * @param {File} file
 * @param {UploadMessage} answer
 */
function tell(store, actions, file, answer) {
  if (answer.type === "upload_refused")
    store.set({ notice: { level: "warning", text: answer.text } });
  if (answer.type === "upload_cancelled")
    store.set({ notice: { level: "info", text: `${answer.name} was not added.` } });
  if (answer.type === "uploaded" && answer.compares) actions.compare(answer.name);
}

/** What asks for files. */
function createInput() {
  const input = /** @type {HTMLInputElement} */ (
    el("input", {
      type: "file",
      multiple: true,
      accept: KINDS,
      hidden: true,
      "aria-label": "Files to add",
    })
  );
  document.body.append(input);
  return input;
}
