/** Files dropped on the page are sent to the server in pieces, one file at a time. */

import { byId } from "./dom.js";

const PIECE_BYTES = 256 * 1024;
/** No more than this waits in the browser, so that a large file does not fill its memory. */
const WAITING_BYTES = 4 * PIECE_BYTES;

/**
 * @param {import("./store.js").Store} store
 * @param {import("./socket.js").Socket} socket
 */
export function createUpload(store, socket) {
  const target = byId("drop-target");
  /** @type {File[]} */
  let waiting = [];
  let sending = false;
  let answered = () => {};

  function drops(event) {
    return !store.state.lookingOnly && event.dataTransfer?.types.includes("Files");
  }

  /** Files may be dropped on our page and on the scene's frame alike. */
  function watch(page) {
    page.addEventListener("dragover", (event) => {
      if (!drops(event)) return;
      event.preventDefault();
      target.hidden = false;
    });
    page.addEventListener("dragleave", (event) => {
      if (!event.relatedTarget) target.hidden = true;
    });
    page.addEventListener("drop", (event) => {
      target.hidden = true;
      if (!drops(event)) return;
      event.preventDefault();
      waiting.push(...event.dataTransfer.files);
      sendNext();
    });
  }
  watch(window);

  async function sendNext() {
    const file = waiting.shift();
    if (sending || !file) return;
    sending = true;
    const done = new Promise((resolve) => (answered = resolve));
    const whole = await send(file);
    if (whole) await done;
    store.set({ progress: null });
    sending = false;
    sendNext();
  }

  /** @returns {Promise<boolean>} whether all of it was sent */
  async function send(file) {
    if (!socket.send({ type: "upload", name: file.name, size: file.size })) return false;
    for (let at = 0; at < file.size; at += PIECE_BYTES) {
      const piece = await file.slice(at, at + PIECE_BYTES).arrayBuffer();
      await socket.roomFor(WAITING_BYTES);
      if (!sending || !socket.sendPiece(piece)) return false;
      store.set({ progress: { what: `Sending ${file.name}`, fraction: at / file.size, done: false } });
    }
    return true;
  }

  return {
    watch,
    /** The server has the file, or refused it. */
    ended() {
      answered();
    },
    refused() {
      if (sending) answered();
      sending = false;
      waiting = [];
    },
  };
}
