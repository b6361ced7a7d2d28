// Devices under test: the list to choose from, one more of them, and when they are due.
import { load, post } from "./server.js";
import { say } from "./words.js";

const $ = (id) => document.getElementById(id);
let known = [];

const name = (sensor) => [sensor.serial, sensor.manufacturer, sensor.model].filter(Boolean).join(" ");

/** Lists the sensors of the logbook; chooses the one that is named. */
export async function show_sensors(serial) {
  known = (await load("api/sensors")) || [];
  const list = $("sensor"), chosen = serial || list.value;
  list.replaceChildren(new Option(say("not in the logbook: typed"), ""), ...known.map((sensor) => new Option(name(sensor), sensor.serial)));
  list.value = known.some((sensor) => sensor.serial === chosen) ? chosen : "";
  list.dispatchEvent(new Event("change"));
  show_due();
}

/** Sensors that are due within a month, or were. */
function show_due() {
  const day = (days) => new Date(Date.now() + 86400000 * days).toISOString().slice(0, 10);
  const due = known.filter((sensor) => sensor.due_day && sensor.due_day <= day(31));
  due.sort((a, b) => a.due_day.localeCompare(b.due_day));
  $("due-list").replaceChildren(...due.map((sensor) => {
    const line = document.createElement("li"), choose = line.appendChild(document.createElement("button"));
    choose.type = "button";
    choose.textContent = name(sensor);
    choose.addEventListener("click", () => show_sensors(sensor.serial));
    const overdue = sensor.due_day < day(0);
    line.append(" " + say(overdue ? "overdue since {0}" : "due on {0}", sensor.due_day));
    line.className = overdue ? "exceeds" : "";
    return line;
  }));
  $("due").hidden = !due.length;
}

/** What stands between a charge or a current and the input. */
function show_between() {
  const between = $("new-unit").selectedOptions[0].dataset.between;
  $("between").hidden = !between;
  for (const field of [$("between-value"), $("between-u")]) field.required = Boolean(between);
  $("between-what").textContent = say(between === "ohm" ? "Burden, ohm" : "Charge amplifier, mV/pC");
}

async function register(sensor, say_why) {
  const why = await post("api/sensors", sensor);
  say_why(why);
  if (why) return;
  $("register").reset();
  $("teds").value = "";
  $("registration").open = false;
  show_sensors(sensor.serial);
}

const hexadecimal = (bytes) => [...new Uint8Array(bytes)].map((byte) => byte.toString(16).padStart(2, "0")).join("");

/** Lets sensors be registered; what is wrong with one goes to `say_why`. */
export function take_sensors(say_why) {
  $("register").addEventListener("submit", (event) => {
    event.preventDefault();
    const stated = [...new FormData($("register"))].map(([key, value]) => [key, value.trim()]).filter(([, value]) => value);
    const sensor = Object.fromEntries(stated), between = $("new-unit").selectedOptions[0].dataset.between;
    if (between) sensor.unit += " at " + $("between-value").value + " " + between + " +-" + $("between-u").value + "%";
    if (sensor.sensitivity) sensor.sensitivity = Number(sensor.sensitivity);
    if (sensor.resonance) sensor.resonance = 1000 * Number(sensor.resonance);
    // One number with a decimal comma, and not two tolerances.
    if (/^\d+,\d+$/.test(sensor.tolerance)) sensor.tolerance = sensor.tolerance.replace(",", ".");
    register(sensor, say_why);
  });
  $("new-unit").addEventListener("change", show_between);
  $("register").addEventListener("reset", () => setTimeout(show_between));
  $("teds").addEventListener("change", async () => {
    const [file] = $("teds").files;
    if (file) register({ teds: hexadecimal(await file.arrayBuffer()) }, say_why);
  });
}
