// The page shows what the server says and keeps nothing: every message is the whole view.
import * as live from "./live.js";
import * as measurement from "./measurement.js";
import { show_records } from "./records.js";
import { load, post, save } from "./server.js";
import * as waveforms from "./waveforms.js";

const $ = (id) => document.getElementById(id);
let last = null, ended = "", refusal = "", answers = true;

function say() {
  const lost = !answers ? "the server does not answer; it is being tried again. STOP cannot reach it: use the button on the instrument"
    : last && last.link === "lost" ? "STOP reaches the calibrator when the link is back: until then use the button on the instrument" : "";
  const problem = [refusal, last && last.trouble, lost].filter(Boolean).join(". ");
  $("trouble").textContent = problem;
  $("trouble").hidden = !problem;
}

async function ask(path, body) {
  refusal = await post(path, body);
  say();
}

/** Silence was asked for and nobody can say that it is there: nothing else matters on the screen. */
function alarm(why) {
  $("alarm-why").textContent = why;
  $("alarm").hidden = !why;
  if (why) $("alarm-stop").focus();
}

// The number of the run tells a stop that is late from one that is meant for what goes on now.
async function stop() {
  $("stop").classList.add("sent");
  const why = await live.stop(last ? (last.run ? last.run.number : 0) : null);
  $("stop").classList.remove("sent");
  const nothing_there = answers && last && last.link === "none" && !(last.run && last.run.running);
  alarm(nothing_there ? "" : why);
}

$("alarm-stop").addEventListener("click", stop);
$("alarm-close").addEventListener("click", () => alarm(""));
$("stop").addEventListener("click", stop);
document.addEventListener("keydown", (event) => {
  if (event.key === "Escape") stop();
});
// A certificate that cannot be had is said here, not on an empty page.
document.addEventListener("click", async (event) => {
  const link = event.target.closest("a[download]");
  if (!link || !link.href.startsWith(location.origin)) return;
  event.preventDefault();
  refusal = await save(link);
  say();
});
$("connect").addEventListener("submit", (event) => {
  event.preventDefault();
  ask("api/connect", { device: $("device").value.trim() });
});

function frequencies() {
  const chosen = $("list").value === "typed" ? $("frequencies").value : $("list").value;
  return chosen.split(/[\s;,]+/).filter(Boolean).map(Number);
}

/** Measures these frequencies; the rest as the form says. */
function measure(frequencies_hz) {
  const typed = (id) => $(id).value.trim();
  ask("api/run", {
    sensor: $("sensor").value,
    dut_model: typed("model"),
    dut_serial: typed("serial"),
    operator: typed("operator"),
    mounting: typed("mounting"),
    set_acceleration_rms_ms2: Number($("level").value),
    temperature_c: $("temperature").value === "" ? null : Number($("temperature").value),
    frequencies_hz,
  });
}

$("run").addEventListener("submit", (event) => {
  event.preventDefault();
  measure(frequencies());
});
$("retry").addEventListener("click", () => measure(measurement.refused(last.run)));
$("sensor").addEventListener("change", () => {
  for (const field of document.querySelectorAll(".typed")) field.hidden = $("sensor").value !== "";
});
$("list").addEventListener("change", () => {
  $("typed-points").hidden = $("list").value !== "typed";
  $("frequencies").required = $("list").value === "typed";
});
for (const stated of ["issued", "approved_by"]) {
  $(stated).addEventListener("change", () => {
    if (last) measurement.show(last.run);
    show_records();
  });
}
const redraw = () => {
  if (last) measurement.draw(last.run);
  waveforms.draw();
};
addEventListener("resize", redraw);

function show(view) {
  const links = { none: view.device ? "no link to " + view.device : "not connected",
    connected: "connected to " + view.device, lost: "link lost to " + view.device };
  $("link").textContent = links[view.link];
  $("link").dataset.link = view.link;
  $("info").textContent = view.info
    ? "calibrator " + view.info.instrument_serial + ", firmware " + view.info.firmware_version : "";
  const defects = view.info ? view.info.defect_texts : [];
  $("degraded").textContent = defects.length ? "Degraded, measures nothing: " + defects.join("; ") : "";
  $("degraded").hidden = !defects.length;
  if (!$("device").value) $("device").value = view.device;
  const running = Boolean(view.run && view.run.running);
  $("start").disabled = running || view.link !== "connected" || defects.length > 0;
  for (const control of $("connect").elements) control.disabled = running;
  measurement.show(view.run);
  waveforms.show(view.waveforms);
  say();
}

/** The verdict is made in one place, by the server, once the record is there. */
async function judge(number) {
  const judged = await load("api/judged");
  if (last && last.run && last.run.number === number) measurement.judge(number, judged, last.run);
}

async function fill() {
  measurement.know(await load("api/refusals"));
  for (const port of (await load("api/devices")) || []) {
    $("devices").appendChild(document.createElement("option")).value = port.name;
  }
  for (const sensor of (await load("api/sensors")) || []) {
    $("sensor").add(new Option([sensor.serial, sensor.manufacturer, sensor.model].filter(Boolean).join(" "), sensor.serial));
  }
  show_records();
}

live.listen((view) => {
  last = view;
  answers = true;
  // A confirmation that came late ends the alarm.
  if (view.stop && view.stop.state === "confirmed" && !$("alarm").hidden && !(view.run && view.run.running)) alarm("");
  show(view);
  const run = view.run, kept = run && !run.running ? run.number + " " + run.logbook_record : "";
  if (kept && kept !== ended) {
    ended = kept;
    show_records();
    judge(run.number);
  }
}, () => {
  answers = false;
  $("link").textContent = "the server does not answer";
  $("link").dataset.link = "lost";
  say();
});
fill();
