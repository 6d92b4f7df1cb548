/** When what was drawn has been seen. */

/** Calls back once the frame at hand is painted. @param {() => void} done */
export function afterFrame(done) {
  const { port1, port2 } = new MessageChannel();
  port1.onmessage = () => {
    port1.close();
    done();
  };
  port2.postMessage(null);
}
