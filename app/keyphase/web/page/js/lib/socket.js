/**
 * The page's websocket: JSON both ways, signals as binary frames, and a connection that comes
 * back by itself after it broke.
 *
 * @typedef {import("../model/types.js").Message} Message
 * @typedef {import("../model/types.js").Request} Request
 * @typedef {{send: (message: Request) => boolean, sendPiece: (piece: ArrayBuffer) => boolean,
 *   roomFor: (most: number) => Promise<void>, drop: () => void}} Socket
 */

const FIRST_RETRY_MS = 250;
const LAST_RETRY_MS = 5000;
/** The server closes with this code where a defect has broken the conversation. */
const DEFECT = 1011;

/**
 * @param {string} page what this page calls itself
 * @param {{onMessage: (message: Message) => void, onSignals: (frame: ArrayBuffer) => void,
 *   onState: (connected: boolean, retryInMs: number) => void,
 *   onBroken: (why: string) => void}} handlers
 * @returns {Socket}
 */
export function openSocket(page, { onMessage, onSignals, onState, onBroken }) {
  const scheme = location.protocol === "https:" ? "wss" : "ws";
  const address = `${scheme}://${location.host}/app/ws?page=${page}`;
  /** @type {WebSocket} */
  let socket;
  let retryMs = FIRST_RETRY_MS;

  function connect() {
    socket = new WebSocket(address);
    socket.binaryType = "arraybuffer";
    socket.onopen = () => {
      retryMs = FIRST_RETRY_MS;
      onState(true, 0);
    };
    socket.onmessage = ({ data }) => {
      if (typeof data === "string") onMessage(JSON.parse(data));
      else onSignals(data);
    };
    socket.onclose = ({ code, reason }) => {
      if (code === DEFECT) onBroken(reason);
      onState(false, retryMs);
      setTimeout(connect, retryMs);
      retryMs = Math.min(2 * retryMs, LAST_RETRY_MS);
    };
  }

  connect();
  return {
    /** One piece of a file. @param {ArrayBuffer} piece */
    sendPiece(piece) {
      if (socket.readyState !== WebSocket.OPEN) return false;
      socket.send(piece);
      return true;
    },
    /** Waits until no more than `most` bytes are still to be sent. */
    async roomFor(most) {
      while (socket.readyState === WebSocket.OPEN && socket.bufferedAmount > most) {
        await new Promise((next) => setTimeout(next, 15));
      }
    },
    /** Breaks the connection, which then comes back by itself. */
    drop: () => socket.close(),
    send(message) {
      if (socket.readyState !== WebSocket.OPEN) return false;
      socket.send(JSON.stringify(message));
      return true;
    },
  };
}
