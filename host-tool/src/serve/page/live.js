// The page's one channel to the server, and stops, which take two ways at once: that channel and a port
// that does nothing else.
import { url } from "./server.js";
import { say } from "./words.js";

const confirmed_within_ms = 500, silence_ms = 4000, again_ms = 500;
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

/** Stops; returns nothing once the calibrator has confirmed it, else why nobody knows that it is silent. */
export async function stop(run) {
  const late = new Promise((_, reject) =>
    setTimeout(() => reject(new Error(say("no confirmation within {0} ms", confirmed_within_ms))), confirmed_within_ms));
  const ways = Promise.any([by_channel(run), by_own_port(run)])
    .catch((all) => { throw all.errors.find((error) => /run/.test(error.message)) || all.errors[0]; });
  try {
    await Promise.race([ways, late]);
    return "";
  } catch (error) {
    return error.message;
  }
}
