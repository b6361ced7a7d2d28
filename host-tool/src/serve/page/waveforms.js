// What the two inputs look like while a run goes on.
import { chart } from "./chart.js";
import { load } from "./server.js";
import { figures, say } from "./words.js";

const $ = (id) => document.getElementById(id);
let shown = 0, loading = false, last = null;

/** An axis around zero that holds the whole trace `room` times; zeros are at one height. */
function swing(values, room) {
  const most = room * Math.max(1e-9, ...values.map(Math.abs));
  return { min: -most, max: most, wanted: 4 };
}

/** Five decades below the highest line: what two 16-bit converters can show. */
function decades(values) {
  const top = 10 ** Math.ceil(Math.log10(Math.max(1e-9, ...values)));
  return { log: true, min: top / 1e5, max: top };
}

export function draw() {
  if (!last || $("inputs").hidden) return;
  const time = (n) => 1000 * n * last.step_s, points = (trace) => trace.map((y, n) => ({ x: time(n), y }));
  const dut_mv = last.dut_v.map((volt) => 1000 * volt);
  chart($("waveform"), { min: 0, max: time(last.reference_ms2.length - 1), label: say("time, ms") }, swing(last.reference_ms2, 1.1), [
    { kind: "trace", points: points(last.reference_ms2) },
    { kind: "trace", class: "second", y: swing(dut_mv, 1.6), points: points(dut_mv) },
  ]);
  const line = (channel) => last.spectrum.map((l) => ({ x: l[0], y: l[channel] * (channel === 2 ? 1000 : 1) }));
  const ends = [last.spectrum[0][0], last.spectrum.at(-1)[0]];
  chart($("spectrum"), { log: true, min: ends[0], max: ends[1], label: say("frequency, Hz") }, decades(last.spectrum.map((l) => l[1])), [
    { kind: "trace", points: line(1) },
    { kind: "trace", class: "second", y: decades(last.spectrum.map((l) => 1000 * l[2])), points: line(2) },
  ]);
  $("clipped").hidden = !last.clipped;
  $("played").textContent = say("at {0} Hz", figures(last.frequency_hz, 4));
}

/** Loads waveforms that are newer than those on the page. */
export async function show(number) {
  if (!number || number === shown || loading) return;
  loading = true;
  const loaded = await load("api/waveforms");
  loading = false;
  if (!loaded || !loaded.spectrum.length) return;
  [last, shown] = [loaded, loaded.number];
  $("inputs").hidden = false;
  draw();
}
