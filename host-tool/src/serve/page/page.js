"use strict";
// The page shows what the server says and keeps nothing: every event is the whole view.
const token = new URLSearchParams(location.search).get("token");
const url = (path) => path + (token ? "?token=" + encodeURIComponent(token) : "");
const $ = (id) => document.getElementById(id);

function say(problem) {
  $("trouble").textContent = problem || "";
  $("trouble").hidden = !problem;
}

async function post(path, body) {
  try {
    const answer = await fetch(url(path), {
      method: "POST",
      headers: { "Content-Type": "application/json" },
      body: JSON.stringify(body || {}),
    });
    if (!answer.ok) say(await answer.text());
    return answer.ok;
  } catch (error) {
    say("the server does not answer: " + error.message);
    return false;
  }
}

$("stop").addEventListener("click", () => post("api/stop"));
document.addEventListener("keydown", (event) => {
  if (event.key === "Escape") post("api/stop");
});
$("connect").addEventListener("submit", (event) => {
  event.preventDefault();
  post("api/connect", { device: $("device").value.trim() });
});
$("run").addEventListener("submit", (event) => {
  event.preventDefault();
  const typed = $("frequencies").value.split(/[\s;,]+/).filter(Boolean).map(Number);
  post("api/run", {
    sensor: $("sensor").value,
    model: $("model").value,
    serial: $("serial").value,
    operator: $("operator").value,
    level_ms2: Number($("level").value),
    frequencies_hz: typed,
  });
});
$("sensor").addEventListener("change", () => {
  for (const label of document.querySelectorAll(".typed")) label.hidden = $("sensor").value !== "";
});
$("tolerance").addEventListener("input", () => last && draw(last.run));

function row(cells, refused) {
  const line = document.createElement("tr");
  for (const cell of cells) line.appendChild(document.createElement("td")).textContent = cell;
  if (refused) line.className = "refused";
  return line;
}

function show(view) {
  const links = { none: "not connected", connected: "connected to " + view.device,
    lost: "LINK LOST to " + view.device + ", trying again" };
  $("link").textContent = links[view.link];
  say(view.trouble);
  $("info").textContent = view.info
    ? "serial number " + view.info.serial + ", firmware " + view.info.firmware_version : "";
  const run = view.run, running = Boolean(run && run.running);
  $("start").disabled = running || view.link !== "connected";
  $("progress").value = run ? run.fraction : 0;
  const status = run && run.status;
  $("state").textContent = run ? (running ? (status ? status.state : "starting") : run.ended) : "idle";
  $("frequency").textContent = running && status ? status.frequency_hz.toPrecision(5) + " Hz" : "–";
  $("acceleration").textContent = running && status
    ? status.acceleration_rms_ms2.toFixed(3) + " of " + status.target_rms_ms2.toFixed(3) + " m/s²" : "–";
  $("drive").textContent = running && status ? status.drive_peak_v.toFixed(3) + " V peak" : "–";
  $("points").replaceChildren(...(run ? run.points : []).map((p) => p.passed
    ? row([p.frequency_hz, p.acceleration_ms2.toFixed(3), (1000 * p.sensitivity_v_per_ms2).toFixed(5),
        (100 * p.expanded_uncertainty_rel).toFixed(2), p.phase_deg.toFixed(2), p.settling_s.toFixed(2), p.verdict])
    : row([p.frequency_hz, "", "", "", "", "", p.verdict], true)));
  $("certificates").hidden = !run || running || run.record === null || !run.points.length;
  for (const link of document.querySelectorAll("#certificates a")) {
    link.href = url("api/certificate/" + link.dataset.format);
  }
  draw(run);
}

// Deviation from 160 Hz (else from the first point) in percent, over log f.
function draw(run) {
  const points = (run ? run.points : []).filter((p) => p.passed);
  const svg = $("plot");
  svg.replaceChildren();
  if (!points.length) return;
  const add = (name, attributes, text) => {
    const node = document.createElementNS("http://www.w3.org/2000/svg", name);
    for (const [key, value] of Object.entries(attributes)) node.setAttribute(key, value);
    if (text !== undefined) node.textContent = text;
    svg.appendChild(node);
  };
  const reference = points.find((p) => p.frequency_hz === 160) || points[0];
  const marks = points.map((p) => {
    const ratio = p.sensitivity_v_per_ms2 / reference.sensitivity_v_per_ms2;
    return { f: p.frequency_hz, d: 100 * (ratio - 1), u: 100 * ratio * p.expanded_uncertainty_rel };
  });
  const tolerance = Math.max(0, Number($("tolerance").value) || 0);
  const top = Math.max(tolerance, ...marks.map((m) => Math.abs(m.d) + m.u)) * 1.1 || 1;
  const all = run.list.map((p) => Math.log10(p.frequency_hz));
  const low = Math.min(...all), span = Math.max(...all) - low || 1;
  const x = (f) => 50 + 570 * (Math.log10(f) - low) / span;
  const y = (d) => 120 - 105 * d / top;
  add("rect", { x: 50, y: y(tolerance), width: 570, height: y(-tolerance) - y(tolerance), fill: "#18794e22" });
  for (const d of [-top, 0, top]) {
    add("line", { x1: 50, x2: 620, y1: y(d), y2: y(d), stroke: "#8888" });
    add("text", { x: 45, y: y(d) + 4, "text-anchor": "end" }, d.toFixed(top < 1 ? 2 : 1));
  }
  for (let decade = 0; decade < 5; decade++) for (const n of [1, 2, 5]) {
    const f = n * 10 ** decade;
    if (Math.log10(f) < low - 1e-9 || Math.log10(f) > low + span + 1e-9) continue;
    add("text", { x: x(f), y: 248, "text-anchor": "middle" }, f >= 1000 ? f / 1000 + "k" : f);
  }
  add("text", { x: 50, y: 12 }, "deviation in %, bars are U");
  for (const m of marks) {
    add("line", { x1: x(m.f), x2: x(m.f), y1: y(m.d - m.u), y2: y(m.d + m.u), stroke: "#0b68cb" });
    add("circle", { cx: x(m.f), cy: y(m.d), r: 3, fill: "#0b68cb", class: "point" });
  }
}

async function load(path) {
  const answer = await fetch(url(path));
  return answer.ok ? answer.json() : [];
}

async function fill() {
  for (const port of await load("api/devices")) {
    $("devices").appendChild(document.createElement("option")).value = port.name;
  }
  const chosen = $("sensor").value;
  $("sensor").length = 1;
  for (const sensor of await load("api/sensors")) {
    const name = sensor.serial + "  " + sensor.manufacturer + " " + sensor.model;
    $("sensor").add(new Option(name, sensor.serial));
  }
  $("sensor").value = chosen;
  records();
}

async function records() {
  $("records").replaceChildren(...(await load("api/records")).slice(0, 50).map((r) => {
    const line = row([new Date(1000 * r.unix_time_s).toISOString().slice(0, 16).replace("T", " ") + "Z",
      r.sensor_serial, r.sensitivity_v_per_ms2 === null ? "" : (1000 * r.sensitivity_v_per_ms2).toFixed(4),
      r.expanded_uncertainty_rel === null ? "" : (100 * r.expanded_uncertainty_rel).toFixed(2), r.refused]);
    line.addEventListener("click", () => history_of(r.sensor_serial));
    return line;
  }));
}

async function history_of(serial) {
  const history = await load("api/history/" + encodeURIComponent(serial));
  const changes = (history.results || []).filter((r) => r.drift_rel !== null).map((r) =>
    (100 * r.drift_rel).toFixed(2) + " %" + (r.drift_exceeds_uncertainty ? " (more than U)" : ""));
  $("history").textContent = serial + " at 160 Hz, change from one calibration to the next: "
    + (changes.join(", ") || "calibrated once");
}

let last = null, ended = 0;
const events = new EventSource(url("api/events"));
events.onmessage = (event) => {
  last = JSON.parse(event.data);
  show(last);
  const run = last.run;
  if (run && !run.running && run.number !== ended) {
    ended = run.number;
    records();
  }
};
events.onerror = () => {
  $("link").textContent = "the server does not answer, trying again";
};
fill();
