// The logbook: what was measured before, and how sensors drift.
import { around, chart } from "./chart.js";
import { row } from "./measurement.js";
import { certificate, load } from "./server.js";

const $ = (id) => document.getElementById(id);
const fixed = (value, digits) => value === null ? "" : value.toFixed(digits);

function links(record) {
  const place = document.createElement("span");
  for (const format of ["html", "pdf", "dcc"]) {
    const link = place.appendChild(document.createElement("a"));
    link.textContent = { html: "view", pdf: "PDF", dcc: "DCC" }[format];
    link.href = certificate("api/records/" + record.logbook_record + "/certificate/" + format);
    if (format === "html") link.target = "_blank";
    else link.download = "";
    place.append(" ");
  }
  return place;
}

function line(record) {
  const sensor = document.createElement("button");
  sensor.textContent = record.dut_serial || "not stated";
  sensor.addEventListener("click", () => show_history(record.dut_serial));
  const day = record.unix_time_s ? new Date(1000 * record.unix_time_s).toISOString().slice(0, 16).replace("T", " ") + "Z" : "not stated";
  const cells = row([day, sensor, fixed(record.sensitivity_v_per_ms2 && 1000 * record.sensitivity_v_per_ms2, 4),
    fixed(record.expanded_uncertainty_rel && 100 * record.expanded_uncertainty_rel, 2), record.refused, links(record)]);
  for (const place of [0, 1]) cells.children[place].className = "text";
  return cells;
}

export async function show_records() {
  const wanted = $("search").value.trim().toLowerCase();
  const records = (await load("api/records")) || [];
  const found = records.filter((r) => (r.dut_serial + " " + r.dut_model).toLowerCase().includes(wanted));
  $("records").replaceChildren(...found.slice(0, 50).map(line));
}

async function show_history(serial) {
  const history = await load("api/history/" + encodeURIComponent(serial));
  const results = history ? history.results : [];
  $("history").hidden = !results.length;
  if (!results.length) return;
  const last = results.at(-1), year = (r) => 1970 + r.unix_time_s / 31557600;
  const words = last.drift_rel === null ? "calibrated once"
    : "last change " + (100 * last.drift_rel).toFixed(2) + " %" + " (U " + (100 * last.expanded_uncertainty_drift_rel).toFixed(2) + " %)"
      + (last.e_n === null ? "" : ", E_n " + last.e_n.toFixed(2)) + (last.drift_exceeds_uncertainty ? ": changed" : "");
  $("drift").textContent = serial + " at " + history.frequency_hz + " Hz: " + words;
  $("drift").className = last.drift_exceeds_uncertainty ? "exceeds" : "";
  const points = results.map((r) => ({ x: year(r), y: 1000 * r.sensitivity_v_per_ms2,
    u: 1000 * r.sensitivity_v_per_ms2 * r.expanded_uncertainty_rel, class: r.drift_exceeds_uncertainty ? "outside" : "",
    title: new Date(1000 * r.unix_time_s).toISOString().slice(0, 10) + ": " + (1000 * r.sensitivity_v_per_ms2).toFixed(4) + " mV/(m/s²)" }));
  const x = { ...around(points.map((p) => p.x), 0.2), label: "year; S in mV/(m/s²) with U", spacing: 60,
    text: (value) => value.toFixed(points.at(-1).x - points[0].x > 3 ? 0 : 2) };
  chart($("history-plot"), x, around(points.flatMap((p) => [p.y - p.u, p.y + p.u]), 0), [{ kind: "marks", points }]);
}

$("search").addEventListener("input", show_records);
