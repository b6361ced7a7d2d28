// The logbook: what was measured before, and how sensors drift.
import { around, chart } from "./chart.js";
import { printed, row } from "./measurement.js";
import { certificate, load } from "./server.js";
import { decimals, figures, say, sensitivity } from "./words.js";

const $ = (id) => document.getElementById(id);
const fixed = (value, digits) => value === null ? "" : decimals(value, digits);

function links(record) {
  const place = document.createElement("span");
  for (const format of ["html", "pdf", "dcc"]) {
    const link = place.appendChild(document.createElement("a"));
    link.textContent = { html: say("view"), pdf: "PDF", dcc: "DCC" }[format];
    link.href = certificate("api/records/" + record.logbook_record + "/certificate/" + format);
    if (format === "html") link.target = "_blank";
    else link.download = "";
    place.append(" ");
  }
  return place;
}

const day = (record) => record.unix_time_s
  ? new Date(1000 * record.unix_time_s).toISOString().slice(0, 16).replace("T", " ") + "Z" : say("not stated");

function line(record) {
  const sensor = document.createElement("button");
  sensor.textContent = record.dut_serial || say("not stated");
  sensor.addEventListener("click", () => show_history(record.dut_serial));
  const found = record.sensitivity === null ? "" : sensitivity(record.sensitivity) + " " + printed(record.unit);
  const cells = row([record.record_id, day(record), sensor, found,
    fixed(record.expanded_uncertainty_rel && 100 * record.expanded_uncertainty_rel, 2), record.refused, links(record)], "",
  [say("record"), say("measured"), say("sensor"), "S", say("U of the instrument, %"), say("refused"), say("certificate")]);
  for (const place of [0, 1, 2]) cells.children[place].className = "text";
  return cells;
}

/** Lets one of these records be chosen, or none; what was chosen stays if it is there. */
function offer(id, records, words) {
  const kept = $(id).value;
  $(id).replaceChildren(new Option(say("not stated"), ""), ...records.map((r) => new Option(words(r), r.logbook_record)));
  $(id).value = records.some((r) => String(r.logbook_record) === kept) ? kept : "";
}

/** Records of the sensor that was measured last: one of them was made before its adjustment. */
function show_found(records) {
  const [last] = records, before = records.filter((r) => r !== last && last.dut_serial && r.dut_serial === last.dut_serial);
  offer("as_found", before, (r) => say("record {0}, {1}", r.record_id, day(r)));
}

/** Records of check standards whose certificate is known, by the instrument of the last run: one of them was in its channel. */
export function show_standards(standards) {
  const certified = standards.filter((s) => s.certified).map((s) => s.dut_serial.toLowerCase());
  const [last] = all, of = (r) => (r.dut_serial || "").toLowerCase();
  const other = (r) => of(r) !== of(last) && r.instrument_serial === last.instrument_serial;
  const found = all.filter((r) => certified.includes(of(r)) && other(r));
  offer("substituted", found, (r) => say("{0}, record {1}, {2}", r.dut_serial, r.record_id, day(r)));
  $("by-standard").hidden = !found.length;
}

/** Records of the logbook, the last one first. */
let all = [];

export async function show_records() {
  const wanted = $("search").value.trim().toLowerCase();
  all = (await load("api/records")) || [];
  show_found(all);
  const found = all.filter((r) => (r.dut_serial + " " + r.dut_model).toLowerCase().includes(wanted));
  $("records").replaceChildren(...found.slice(0, 50).map(line));
  $("no-records").hidden = all.length > 0;
}

async function show_history(serial) {
  const history = await load("api/history/" + encodeURIComponent(serial));
  const results = history ? history.results : [];
  $("history").hidden = !results.length;
  if (!results.length) return;
  const last = results.at(-1), year = (r) => 1970 + r.unix_time_s / 31557600;
  const words = last.drift_rel === null ? say("calibrated once")
    : say("last change {0} % (U {1} %)", decimals(100 * last.drift_rel, 2), decimals(100 * last.expanded_uncertainty_drift_rel, 2))
      + (last.e_n === null ? "" : ", E_n " + decimals(last.e_n, 2)) + (last.drift_exceeds_uncertainty ? say(": changed") : "");
  $("drift").textContent = say("{0} at {1} Hz: {2}", serial, figures(history.frequency_hz, 5), words);
  $("drift").className = last.drift_exceeds_uncertainty ? "exceeds" : "";
  const points = results.map((r) => ({ x: year(r), y: r.sensitivity,
    u: r.sensitivity * r.expanded_uncertainty_rel, class: r.drift_exceeds_uncertainty ? "outside" : "",
    title: new Date(1000 * r.unix_time_s).toISOString().slice(0, 10) + ": " + sensitivity(r.sensitivity) + " " + printed(history.unit) }));
  const x = { ...around(points.map((p) => p.x), 0.2), label: say("day; S in {0} with U", printed(history.unit)), spacing: 80,
    text: (value) => new Date(31557600000 * (value - 1970)).toISOString().slice(0, points.at(-1).x - points[0].x > 1 ? 7 : 10) };
  chart($("history-plot"), x, around(points.flatMap((p) => [p.y - p.u, p.y + p.u]), 0), [{ kind: "marks", points }]);
}

$("search").addEventListener("input", show_records);
