// Check standards: how each stands, and its control charts for level and scatter.
import { around, chart } from "./chart.js";
import { row } from "./measurement.js";
import { show_records, show_standards } from "./records.js";
import { load } from "./server.js";
import { decimals, figures, say, sensitivity } from "./words.js";

const $ = (id) => document.getElementById(id);
const year = (unix_time_s) => 1970 + unix_time_s / 31557600;

function stands(state) {
  const words = [state.in_control ? (state.judged ? "in control" : "no chart yet") : "OUT OF CONTROL", state.overdue ? "OVERDUE" : ""];
  return words.filter(Boolean).map((word) => say(word)).join(", ");
}

function line(state) {
  const name = document.createElement("button");
  name.textContent = state.dut_serial;
  name.addEventListener("click", () => draw(state));
  const latest = state.last_unix_time_s
    ? new Date(1000 * state.last_unix_time_s).toISOString().slice(0, 16).replace("T", " ") + "Z" : say("never");
  const bad = !state.in_control || state.overdue;
  const cells = row([name, figures(state.frequency_hz, 5), state.results, latest, state.e_n === null ? "" : decimals(state.e_n, 2), stands(state)],
    bad ? "failed" : "", [say("sensor"), "Hz", say("results"), say("measured"), "E_n", say("stands")]);
  for (const place of [0, 3, 5]) cells.children[place].className = "text";
  return cells;
}

/** Level and scatter of one, each within its limits. */
function draw(state) {
  const charts = state.chart;
  $("check-charts").hidden = !charts;
  if (!charts) return;
  $("check-name").textContent = say("{0} at {1} Hz: {2}", state.dut_serial, figures(state.frequency_hz, 5), stands(state));
  const milli = (value) => 1000 * value, values = charts.sensitivities_v_per_ms2;
  const points = values.map((value, at) => ({ x: year(charts.unix_times_s[at]), y: milli(value),
    u: milli(value * charts.expanded_uncertainties_rel[at]), title: sensitivity(milli(value)) + " mV/(m/s²)" }));
  const x = { ...around(points.map((p) => p.x), 0.2), label: say("day; S in {0} with U", "mV/(m/s²)"), spacing: 80,
    text: (value) => new Date(31557600000 * (value - 1970)).toISOString().slice(0, 10) };
  const limits = [charts.lower_v_per_ms2, charts.upper_v_per_ms2].map(milli);
  const ends = points.flatMap((p) => [p.y - p.u, p.y + p.u]).concat(limits);
  chart($("check-level"), x, around(ends, 0), [{ kind: "marks", points }], limits);
  const ranges = values.slice(1).map((value, at) => ({ x: points[at + 1].x, y: milli(Math.abs(value - values[at])), u: 0 }));
  const most = milli(charts.range_limit_v_per_ms2);
  const y = { min: 0, max: 1.15 * Math.max(most, ...ranges.map((p) => p.y)) || 1 };
  chart($("check-scatter"), { ...x, label: say("day; difference in {0}", "mV/(m/s²)") }, y, [{ kind: "marks", points: ranges }], [0, most]);
}

/** What the logbook has: records, and how check standards stand. */
export async function show_logbook() {
  const [report] = await Promise.all([load("api/assurance"), show_records()]);
  const standards = report ? report.standards : [];
  $("check-standards").hidden = !standards.length && !(report && report.references.length);
  show_standards(standards);
  $("check-list").replaceChildren(...standards.map(line));
  $("check-charts").hidden = true;
}
