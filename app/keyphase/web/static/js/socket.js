/**
 * The page's websocket: JSON both ways, signals as binary frames, and a connection that comes
 * back by itself after it broke.
 *
 * @typedef {import("./types.js").Message} Message
 * @typedef {{send: (message: Message) => boolean, drop: () => void}} Socket
 */

const FIRST_RETRY_MS = 250;
const LAST_RETRY_MS = 5000;

/**
 * @param {{onMessage: (message: Message) => void, onSignals: (frame: ArrayBuffer) => void,
 *   onState: (connected: boolean, retryInMs: number) => void}} handlers
 * @returns {Socket}
 */
export function openSocket({ onMessage, onSignals, onState }) {
  const address = `${location.protocol === "https:" ? "wss" : "ws"}://${location.host}/app/ws`;
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
    socket.onclose = () => {
      onState(false, retryMs);
      setTimeout(connect, retryMs);
      retryMs = Math.min(2 * retryMs, LAST_RETRY_MS);
    };
  }

  connect();
  return {
    /** Breaks the connection, which then comes back by itself. */
    drop: () => socket.close(),
    send(message) {
      if (socket.readyState !== WebSocket.OPEN) return false;
      socket.send(JSON.stringify(message));
      return true;
    },
  };
}
