// The running or last run: where it stands, its points, its certificate.
import { around, chart } from "./chart.js";
import { certificate } from "./server.js";
import { decimals, figures, say, sensitivity } from "./words.js";

const $ = (id) => document.getElementById(id);
const frequency = () => ({ log: true, label: say("frequency, Hz") });

/** A line of a table; `heads` name the cells where a narrow screen makes a card of the line. */
export function row(cells, name, heads) {
  const line = document.createElement("tr");
  line.setAttribute("role", "row");
  for (const [at, cell] of cells.entries()) {
    const place = line.appendChild(document.createElement("td"));
    place.setAttribute("role", "cell");
    if (cell instanceof Node) place.append(cell);
    else place.textContent = cell;
    place.dataset.head = heads[at];
  }
  if (name) line.className = name;
  return line;
}

/** What the server made of a run that ended: conformity of the sensor, and a statement on each point. */
let judged = { number: 0, document: null };

export function judge(number, document, run) {
  judged = { number, document };
  show(run);
}

const of = (run) => run && !run.running && run.number === judged.number ? judged.document : null;
const same = (a, b) => a.frequency_hz === b.frequency_hz && a.set_acceleration_rms_ms2 === b.set_acceleration_rms_ms2;

/** Statement on a point: its conformity where it was judged, else that it is valid. */
function stated(run, point) {
  const document = of(run), found = document && document.points.find((p) => same(p, point));
  return found && found.conformity !== "not_specified" ? found.conformity : "valid";
}

/** U of a point: the certificate's where the run ended, else the instrument's, which knows neither temperature nor mount. */
function uncertainty(run, point, key) {
  const document = of(run), found = document && document.points.find((p) => same(p, point));
  return found && found[key] !== null ? found[key] : point[key];
}

/** Reasons of refusals in words, with what to do; by their code. */
let reasons = new Map();

export function know(table) {
  reasons = new Map((table || []).map((line) => [line.reason, line]));
}

const in_words = (reason) => (reasons.get(reason) || { reason_text: reason.replaceAll("_", " ") }).reason_text;

const hertz = (all) => all.map((hz) => figures(hz, 5)).join(", ") + " Hz";

function paragraph(text) {
  const line = document.createElement("p");
  line.textContent = text;
  return line;
}

/** Points of a list that was measured which nobody came to. */
const untried = (run) => run.list.filter((set) => !run.points.some((p) => same(p, set)));

/** What to do about the refusals of a run that ended, or of a list that was not begun. */
function advice(run, running) {
  const ended = run && !running ? run : null, impossible = ended ? ended.impossible : [];
  const codes = ended ? [...new Set(ended.points.filter((p) => !valid(p)).map((p) => p.reason))] : [];
  const lines = codes.filter((reason) => reasons.has(reason)).map((reason) => {
    const { reason_text, remedy } = reasons.get(reason);
    return paragraph(reason_text + ": " + say(remedy));
  });
  for (const { frequencies_hz, reason, remedy } of impossible) {
    lines.push(paragraph(hertz(frequencies_hz) + ": " + in_words(reason) + ". " + say(remedy)));
  }
  const left = ended && ended.points.length ? untried(ended) : [];
  if (left.length) lines.push(paragraph(say("Never tried, because the run ended before: {0}", hertz(left.map((set) => set.frequency_hz)))));
  $("advice").replaceChildren(...lines);
  $("retry").hidden = !codes.length && !left.length;
  $("advice-card").hidden = !lines.length;
}

const failed = (state) => state === "fail" || state === "conditional_fail";

const state_words = { settling: "settling point {0} of {1}", measuring: "measuring point {0} of {1}", idle: "starting point {0} of {1}" };
const valid = (point) => point.state === "valid";

function heading(run, running) {
  if (!run) return say("ready");
  if (!running) return say(run.ended);
  const status = run.status;
  if (!status) return say("starting");
  if (status.point >= run.list.length && state_words[status.state]) return say("repeating the first point");
  const point = Math.min(status.point + 1, run.list.length);
  return say(state_words[status.state] || "storing point {0} of {1}", point, run.list.length);
}

function left(run, running) {
  if (!running || run.left_s === null) return "";
  const seconds = Math.round(run.left_s);
  return seconds >= 90 ? say("{0} min left", Math.round(seconds / 60)) : say("{0} s left", seconds);
}

/** The big numbers: what the calibrator says now, and the last point that was measured; of a run that
 *  ended, the reference point. */
function tiles(run, running) {
  const document = of(run), reference = document && document.reference;
  const status = running && run.status, last = reference || (run && run.points.filter(valid).at(-1));
  $("tile-at").textContent = reference ? say("at {0} Hz", figures(reference.frequency_hz, 5)) : "";
  const put = (id, value, digits) => {
    $(id).textContent = value === undefined || value === false || value === null ? "–" : decimals(value, digits);
  };
  const working = status && status.frequency_hz > 0 ? status : null;
  $("frequency").textContent = working ? figures(working.frequency_hz, 5) : "–";
  put("target", working && working.set_acceleration_rms_ms2, 1);
  put("acceleration", working && working.acceleration_rms_ms2, 3);
  put("drive", working && working.drive_peak_v, 3);
  $("level-bar").value = working ? working.acceleration_rms_ms2 / working.set_acceleration_rms_ms2 : 0;
  $("sensitivity").textContent = last && last.in_unit ? sensitivity(last.in_unit.sensitivity) : "–";
  put("phase", last && last.in_unit && last.in_unit.phase_deg, 2);
  put("uncertainty", last && 100 * last.expanded_uncertainty_rel, 2);
  const whose = of(run) ? "U as the certificate states it" : "U of the instrument: without temperature and mount";
  $("whose-u").textContent = last ? say(whose) : "";
}

/** A unit as it is printed. */
export const printed = (unit) => (unit || "mV/(m/s2)").replace("s2", "s²").replace("um", "µm");

function table(run) {
  const heads = ["Hz", "m/s²", "S, " + printed(run && run.unit), "U, %", say("phase, °"), say("settled, s"), ""];
  const without = (hz, words) => row([figures(hz, 5), "", "", "", "", "", words], "refused", heads);
  const lines = (run ? run.points : []).map((p) => valid(p)
    ? row([figures(p.frequency_hz, 5), decimals(p.acceleration_rms_ms2, 3), sensitivity(p.in_unit.sensitivity),
        decimals(100 * uncertainty(run, p, "expanded_uncertainty_rel"), 2), decimals(p.in_unit.phase_deg, 2), decimals(p.settling_s, 2),
        say(stated(run, p).replaceAll("_", " "))], failed(stated(run, p)) ? "failed" : "", heads)
    : without(p.frequency_hz, say("refused: {0}", in_words(p.reason))));
  for (const { frequencies_hz, reason } of run && !run.running ? run.impossible : []) {
    lines.push(...frequencies_hz.map((hz) => without(hz, say("cannot be measured: {0}", in_words(reason)))));
  }
  return lines;
}

function certificates(run, running) {
  const there = Boolean(run && !running && run.record_id !== null && run.points.length);
  $("certificates").hidden = !there;
  if (!there) return;
  const refused = run.points.filter((p) => !valid(p)).length;
  $("judgement").textContent = refused ? say("{0} points, {1} refused", run.points.length, refused)
    : say("{0} points, none refused", run.points.length);
  $("judgement").className = refused ? "exceeds" : "";
  const judged = of(run), conformity = judged && judged.conformity_statement;
  $("conformity").hidden = !conformity;
  if (conformity) {
    $("conformity").dataset.conformity = conformity.conformity;
    $("conformity-title").textContent = conformity.title;
    $("conformity-because").textContent = conformity.because;
  }
  $("kept").textContent = say(run.logbook_record === null ? "record {0}" : "record {0}, kept in the logbook", run.record_id);
  for (const link of document.querySelectorAll("#certificates a")) {
    link.href = certificate("api/certificate/" + link.dataset.format);
  }
}

/** Who signs, and what nobody has signed. */
export function signer({ signer, unsigned_entries }) {
  const who = signer ? say("PDF and DCC are signed by {0}", signer) : say("not signed: the server has no key of the laboratory");
  const waits = unsigned_entries ? say("; entries of the logbook that nobody has signed: {0}", unsigned_entries) : "";
  $("signer").textContent = who + waits;
}

/** Deviation from 160 Hz (else from the first point) and phase, over log f. */
export function draw(run) {
  const points = (run ? run.points : []).filter(valid);
  const all = run && run.list.length ? run.list.map((p) => p.frequency_hz) : [20, 10000];
  const x = { ...frequency(), min: Math.min(...all) / 1.15, max: Math.max(...all) * 1.15 };
  const reference = points.find((p) => p.frequency_hz === 160) || points[0];
  const marks = points.map((p) => {
    const ratio = p.in_unit.sensitivity / reference.in_unit.sensitivity;
    const y = 100 * (ratio - 1), u = 100 * ratio * uncertainty(run, p, "expanded_uncertainty_rel");
    const title = figures(p.frequency_hz, 5) + " Hz: S = " + sensitivity(p.in_unit.sensitivity) + " " + printed(run.unit) + ", "
      + decimals(y, 2) + " %, U = " + decimals(u, 2) + " %";
    return { x: p.frequency_hz, y, u, title, class: failed(stated(run, p)) ? "outside" : "" };
  });
  const top = 1.15 * Math.max(1, ...marks.map((m) => Math.abs(m.y) + m.u));
  chart($("plot"), x, { min: -top, max: top }, [{ kind: "marks", points: marks }]);
  const phases = points.map((p) => ({ x: p.frequency_hz, y: p.in_unit.phase_deg, u: uncertainty(run, p, "expanded_uncertainty_phase_deg"),
    title: figures(p.frequency_hz, 5) + " Hz: " + decimals(p.in_unit.phase_deg, 2) + "°" }));
  const ends = phases.flatMap((p) => [p.y - p.u, p.y + p.u]);
  chart($("phase-plot"), x, around(ends.length ? ends : [0], 2), [{ kind: "marks", points: phases }]);
}

export function show(run) {
  const running = Boolean(run && run.running);
  document.body.classList.toggle("measured", Boolean(run));
  document.body.classList.toggle("running", running);
  $("state").textContent = heading(run, running);
  $("state").dataset.state = running ? "running" : "idle";
  $("left").textContent = left(run, running);
  $("progress").value = run ? run.fraction : 0;
  tiles(run, running);
  for (const place of document.querySelectorAll(".unit")) place.textContent = printed(run && run.unit);
  const lines = table(run);
  $("points").replaceChildren(...lines);
  $("no-points").hidden = lines.length > 0;
  certificates(run, running);
  advice(run, running);
  draw(run);
}
