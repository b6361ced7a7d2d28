// The page shows what the server says and keeps nothing: every message is the whole view.
import { show_logbook } from "./checks.js";
import { show_amendment, show_issued } from "./issued.js";
import * as live from "./live.js";
import * as measurement from "./measurement.js";
import { show_sensors, take_sensors } from "./sensors.js";
import { certificate, load, load_at, post, save, stated } from "./server.js";
import * as waveforms from "./waveforms.js";
import { choose, current, say as word, tell, translate } from "./words.js";

const $ = (id) => document.getElementById(id);
let last = null, ended = "", refusal = "", answers = true;

function say() {
  const lost = !answers ? "the server does not answer; it is being tried again. STOP cannot reach it: use the button on the instrument"
    : last && last.link === "lost" ? "STOP reaches the calibrator when the link is back: until then use the button on the instrument" : "";
  const problem = [refusal, last && last.trouble, lost].filter(Boolean).map((text) => tell(text)).join(". ");
  $("trouble").textContent = problem;
  $("trouble").hidden = !problem;
}

function refuse(why) {
  refusal = why;
  say();
}

async function ask(path, body) {
  refuse(await post(path, body));
}

/** Begins a run; what becomes of it stands above what was asked for. */
async function begin(body) {
  $("late").hidden = true;
  await ask("api/run", body);
  if (!refusal) $("now").scrollIntoView({ block: "nearest" });
}

/** Silence was asked for and nobody can say that it is there: nothing else matters on the screen. */
function alarm(why) {
  $("alarm-why").textContent = tell(why);
  $("alarm").hidden = !why;
  if (why) $("alarm-stop").focus();
}

/** The exciter is silent, and was not in time: said though it is over. */
function stopped_late(after_s) {
  alarm("");
  $("late").hidden = false;
  $("late").textContent = word("stopped late, after {0} s", after_s.toFixed(2));
}

// The number of the run tells a stop that is late from one that is meant for what goes on now; the browser's own
// time of the click or key is when it was asked for.
let stops = 0;
function stop(event) {
  const own = ++stops;
  $("stop").classList.add("sent");
  $("late").hidden = true;
  live.stop(last ? (last.run ? last.run.number : 0) : null, event.timeStamp, (why, after_ms) => {
    if (own !== stops) return;
    $("stop").classList.remove("sent");
    const nothing_there = answers && last && last.link === "none" && !(last.run && last.run.running);
    if (!why && after_ms > live.alarm_after_ms) stopped_late(after_ms / 1000);
    else alarm(nothing_there ? "" : why);
  });
}

$("alarm-stop").addEventListener("click", stop);
$("alarm-close").addEventListener("click", () => alarm(""));
$("stop").addEventListener("click", stop);
document.addEventListener("keydown", (event) => {
  if (event.key === "Escape") stop(event);
});
// A certificate that cannot be had is said here, not on an empty page.
document.addEventListener("click", async (event) => {
  const link = event.target.closest("a[download]");
  if (!link || !link.href.startsWith(location.origin)) return;
  event.preventDefault();
  refuse(await save(link));
  show_issued();
});
$("connect").addEventListener("submit", (event) => {
  event.preventDefault();
  ask("api/connect", { device: $("device").value.trim() });
});

function frequencies() {
  const chosen = $("list").value === "typed" ? $("frequencies").value : $("list").value;
  const plain = current() === "de" ? chosen.replaceAll(",", ".") : chosen;
  return plain.split(/[\s;,]+/).filter(Boolean).map(Number);
}

/** Measures these frequencies; the rest as the form says. */
function measure(frequencies_hz) {
  const typed = (id) => $(id).value.trim();
  begin({
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
$("retry").addEventListener("click", () => begin({ retry: true }));
$("sensor").addEventListener("change", () => {
  for (const field of document.querySelectorAll(".typed")) field.hidden = $("sensor").value !== "";
});
$("list").addEventListener("change", () => {
  $("typed-points").hidden = $("list").value !== "typed";
  $("frequencies").required = $("list").value === "typed";
});
$("adjustment").addEventListener("change", () => {
  $("found-before").hidden = $("adjustment").value !== "as_left";
  if ($("found-before").hidden) $("as_found").value = "";
});
// What is stated on certificates is part of their addresses.
for (const id of stated) {
  $(id).addEventListener("change", () => {
    if (last) measurement.show(last.run);
    show_logbook();
    show_amendment();
  });
}
$("enlarge").addEventListener("click", () => {
  const large = document.body.classList.toggle("large");
  $("enlarge").setAttribute("aria-pressed", large);
  redraw();
});
$("language").addEventListener("change", async () => {
  choose($("language").value);
  await show_lists();
  if (!last) return;
  show(last);
  if (last.run && !last.run.running) judge(last.run.number);
});
const redraw = () => {
  if (last) measurement.draw(last.run);
  waveforms.draw();
};
addEventListener("resize", redraw);

// The lists of the calibrator, and what a tap of its button measures.
function kept(lists) {
  if (!lists.length) return "";
  const chosen = lists.find((list) => list.chosen);
  return "; " + word("lists kept: {0}; a tap of its button measures {1}", lists.map((list) => list.name).join(", "),
    chosen ? chosen.name : word("the default list"));
}

function show(view) {
  const links = { none: view.device ? "no link to {0}" : "not connected", connected: "connected to {0}", lost: "link lost to {0}" };
  $("link").textContent = word(links[view.link], view.device);
  $("link").dataset.link = view.link;
  $("info").textContent = view.info
    ? word("calibrator {0}, firmware {1}", view.info.instrument_serial, view.info.firmware_version) + ", "
      + (view.key ? word("key {0}", view.key) : word("no key: its records are not signed"))
      + kept(view.lists) : "";
  const defects = view.info ? view.info.defect_texts : [];
  $("degraded").textContent = defects.length ? word("Degraded, measures nothing: {0}", defects.map((text) => word(text)).join("; ")) : "";
  $("degraded").hidden = !defects.length;
  if (!$("device").value) $("device").value = view.device;
  const running = Boolean(view.run && view.run.running);
  $("start").disabled = running || view.link !== "connected" || defects.length > 0;
  for (const control of $("connect").elements) control.disabled = running;
  measurement.show(view.run);
  measurement.signer(view);
  waveforms.show(view.waveforms);
  say();
}

/** Conformity is stated in one place, by the server, once the record is there. */
async function judge(number) {
  const judged = await load_at(certificate("api/judged"));
  if (last && last.run && last.run.number === number) measurement.judge(number, judged, last.run);
}

/** What the server has in words of the page's language, and lists with words of the page. */
async function show_lists() {
  measurement.know(await load_at(certificate("api/refusals")));
  show_sensors();
  show_logbook();
  show_issued();
}

async function fill() {
  const ports = (await load("api/devices")) || [];
  for (const port of ports) {
    const option = $("devices").appendChild(document.createElement("option"));
    option.value = port.name;
    option.label = port.description;
  }
  // The likely ones come first.
  if (ports.length && ports[0].likely && !$("device").value) $("device").value = ports[0].name;
  show_lists();
}

translate();
$("language").value = current();
take_sensors(refuse);
live.listen((view) => {
  last = view;
  answers = true;
  // A confirmation that came late ends the alarm.
  if (view.stop && view.stop.state === "confirmed" && !$("alarm").hidden && !(view.run && view.run.running)) stopped_late(view.stop.after_s);
  show(view);
  const run = view.run, kept = run && !run.running ? run.number + " " + run.logbook_record : "";
  if (kept && kept !== ended) {
    ended = kept;
    show_logbook();
    judge(run.number);
  }
}, () => {
  answers = false;
  $("link").textContent = word("the server does not answer");
  $("link").dataset.link = "lost";
  say();
});
fill();
