// The page's one channel to the server, and stops, which take two ways at once: that channel and a port
// that does nothing else.
import { url } from "./server.js";
import { say } from "./words.js";

/** A stop that is not confirmed by then is an alarm; the server and the tool have the same limit. */
export const alarm_after_ms = 200;
const silence_ms = 4000, again_ms = 500;
let socket = null, heard_at = 0, stops = 0, stop_port = 0;
const waiting = new Map();

/** Calls `show` with each view, and `cut` when the server is not heard any more. */
export function listen(show, cut) {
  const own = new WebSocket(url(location.origin.replace(/^http/, "ws") + "/api/live"));
  socket = own;
  heard_at = Date.now();
  const watch = setInterval(() => {
    if (Date.now() - heard_at > silence_ms) own.close(), ended();
  }, 500);
  let is_over = false;
  function ended() {
    if (is_over) return;
    is_over = true;
    clearInterval(watch);
    cut();
    setTimeout(() => listen(show, cut), again_ms);
  }
  own.onmessage = (event) => {
    if (is_over) return;
    heard_at = Date.now();
    const said = JSON.parse(event.data);
    if (said.stop_answer) answered(said.stop_answer);
    if (said.view) {
      stop_port = said.view.stop_port;
      show(said.view);
    }
  };
  own.onclose = ended;
}

function answered({ id, why }) {
  const settle = waiting.get(id);
  waiting.delete(id);
  if (settle) settle(why);
}

function by_channel(run) {
  return new Promise((resolve, reject) => {
    if (!socket || socket.readyState !== WebSocket.OPEN) return reject(new Error("the server does not answer"));
    const id = ++stops;
    waiting.set(id, (why) => (why ? reject(new Error(why)) : resolve()));
    socket.send(JSON.stringify({ run, id }));
  });
}

async function by_own_port(run) {
  if (!stop_port) throw new Error("the server does not answer");
  const address = url("http://" + location.hostname + ":" + stop_port + "/api/stop");
  const answer = await fetch(address, { method: "POST", body: JSON.stringify({ run }), priority: "high" });
  if (!answer.ok) throw new Error(await answer.text());
}

/** Stops what was asked to at this time of the page's clock. `told` hears nothing once the calibrator has
 *  confirmed it, and why nobody knows that it is silent when that takes too long or fails; and how long it was. */
export function stop(run, asked_at, told) {
  const after_ms = () => performance.now() - asked_at;
  const late = setTimeout(() => told(say("no confirmation within {0} ms", alarm_after_ms), after_ms()),
    Math.max(0, alarm_after_ms - after_ms()));
  const settled = (why) => {
    clearTimeout(late);
    told(why, after_ms());
  };
  Promise.any([by_channel(run), by_own_port(run)]).then(() => settled(""),
    (all) => settled((all.errors.find((error) => /run/.test(error.message)) || all.errors[0]).message));
}
