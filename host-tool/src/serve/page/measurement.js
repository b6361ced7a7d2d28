// The running or last run: where it stands, its points, its certificate.
import { around, chart } from "./chart.js";
import { url } from "./server.js";

const $ = (id) => document.getElementById(id);
const frequency = { log: true, label: "frequency, Hz" };

export function row(cells, name) {
  const line = document.createElement("tr");
  for (const cell of cells) {
    const place = line.appendChild(document.createElement("td"));
    if (cell instanceof Node) place.append(cell);
    else place.textContent = cell;
  }
  if (name) line.className = name;
  return line;
}

const state_words = { settling: "settling", measuring: "measuring", idle: "starting" };
const valid = (point) => point.state === "valid";

function heading(run, running) {
  if (!run) return "ready";
  if (!running) return run.ended;
  const status = run.status;
  if (!status) return "starting";
  const point = Math.min(status.point + 1, run.list.length);
  return (state_words[status.state] || "storing") + " point " + point + " of " + run.list.length;
}

function left(run, running) {
  if (!running || run.left_s === null) return "";
  const seconds = Math.round(run.left_s);
  return seconds >= 90 ? Math.round(seconds / 60) + " min left" : seconds + " s left";
}

/** The big numbers: what the calibrator says now, and the last point that was measured. */
function tiles(run, running) {
  const status = running && run.status, last = run && run.points.filter(valid).at(-1);
  const put = (id, value, digits) => {
    $(id).textContent = value === undefined || value === false || value === null ? "–" : value.toFixed(digits);
  };
  const working = status && status.frequency_hz > 0 ? status : null;
  $("frequency").textContent = working ? String(+working.frequency_hz.toPrecision(5)) : "–";
  put("target", working && working.set_acceleration_rms_ms2, 1);
  put("acceleration", working && working.acceleration_rms_ms2, 3);
  put("drive", working && working.drive_peak_v, 3);
  $("level-bar").value = working ? working.acceleration_rms_ms2 / working.set_acceleration_rms_ms2 : 0;
  put("sensitivity", last && 1000 * last.sensitivity_v_per_ms2, 4);
  put("phase", last && last.phase_deg, 2);
  put("uncertainty", last && 100 * last.expanded_uncertainty_rel, 2);
}

function table(run) {
  return (run ? run.points : []).map((p) => valid(p)
    ? row([p.frequency_hz, p.acceleration_rms_ms2.toFixed(3), (1000 * p.sensitivity_v_per_ms2).toFixed(4),
        (100 * p.expanded_uncertainty_rel).toFixed(2), p.phase_deg.toFixed(2), p.settling_s.toFixed(2), "valid"])
    : row([p.frequency_hz, "", "", "", "", "", "refused: " + p.reason.replaceAll("_", " ")], "refused"));
}

function certificates(run, running) {
  const there = Boolean(run && !running && run.record_id !== null && run.points.length);
  $("certificates").hidden = !there;
  if (!there) return;
  const refused = run.points.filter((p) => !valid(p)).length;
  $("judgement").textContent = run.points.length + " points, " + (refused ? refused + " refused" : "none refused");
  $("judgement").className = refused ? "exceeds" : "pass";
  $("kept").textContent = run.logbook_record === null ? "" : "kept in the logbook as record " + run.logbook_record;
  for (const link of document.querySelectorAll("#certificates a")) {
    link.href = url("api/certificate/" + link.dataset.format);
  }
}

/** Deviation from 160 Hz (else from the first point) and phase, over log f. */
export function draw(run) {
  const points = (run ? run.points : []).filter(valid);
  const all = run && run.list.length ? run.list.map((p) => p.frequency_hz) : [20, 10000];
  const x = { ...frequency, min: Math.min(...all) / 1.15, max: Math.max(...all) * 1.15 };
  const tolerance = Math.max(0, Number($("tolerance").value) || 0);
  const reference = points.find((p) => p.frequency_hz === 160) || points[0];
  const marks = points.map((p) => {
    const ratio = p.sensitivity_v_per_ms2 / reference.sensitivity_v_per_ms2;
    const y = 100 * (ratio - 1), u = 100 * ratio * p.expanded_uncertainty_rel;
    const title = p.frequency_hz + " Hz: S = " + (1000 * p.sensitivity_v_per_ms2).toFixed(4) + " mV/(m/s²), "
      + y.toFixed(2) + " %, U = " + u.toFixed(2) + " %";
    return { x: p.frequency_hz, y, u, title, class: Math.abs(y) > tolerance ? "outside" : "" };
  });
  const top = 1.15 * Math.max(tolerance, 0.1, ...marks.map((m) => Math.abs(m.y) + m.u));
  chart($("plot"), x, { min: -top, max: top }, [{ kind: "marks", points: marks }], [-tolerance, tolerance]);
  const phases = points.map((p) => ({ x: p.frequency_hz, y: p.phase_deg, u: p.expanded_uncertainty_phase_deg,
    title: p.frequency_hz + " Hz: " + p.phase_deg.toFixed(2) + "°" }));
  const ends = phases.flatMap((p) => [p.y - p.u, p.y + p.u]);
  chart($("phase-plot"), x, around(ends.length ? ends : [0], 2), [{ kind: "marks", points: phases }]);
}

export function show(run) {
  const running = Boolean(run && run.running);
  document.body.classList.toggle("running", running);
  $("state").textContent = heading(run, running);
  $("state").dataset.state = running ? "running" : "idle";
  $("left").textContent = left(run, running);
  $("progress").value = run ? run.fraction : 0;
  tiles(run, running);
  $("points").replaceChildren(...table(run));
  certificates(run, running);
  draw(run);
}
