// One kind of chart: axes, a band, bars with marks, traces. Drawn to the width there is.
import { figures } from "./words.js";

const margin = { left: 52, right: 12, top: 8, bottom: 34 };

function ticks(axis) {
  const { min, max } = axis, all = [];
  if (axis.log) {
    const steps = Math.log10(max / min) > 2.5 ? [1] : [1, 2, 5];
    for (let decade = Math.floor(Math.log10(min)); decade <= Math.log10(max); decade++) {
      for (const step of steps) {
        const value = step * 10 ** decade;
        if (value >= min * 0.999 && value <= max * 1.001) all.push(value);
      }
    }
    return all.length ? all : [min];
  }
  const rough = (max - min) / (axis.wanted || 5), power = 10 ** Math.floor(Math.log10(rough));
  const step = power * [1, 2, 5, 10].find((n) => n * power >= rough * 0.999);
  for (let n = Math.ceil(min / step - 1e-6); n * step <= max + step * 1e-6; n++) all.push(n * step);
  return all;
}

function words(axis, value) {
  if (axis.text) return axis.text(value);
  if (axis.log) return value >= 1000 ? value / 1000 + "k" : value < 0.01 ? value.toExponential(0) : figures(value, 3);
  return figures(value, 4).replace("-", "−");
}

/** Draws into `svg`; `x` and `y` are `{min, max, log, label, text}`. A series is
 *  `{kind: "marks" | "trace", class, y, points: [{x, y, u, title, class}]}`; one with an
 *  axis `y` of its own has it on the right. A band is `[lower, upper]`. */
export function chart(svg, x, y, series, band) {
  const other = (series.find((one) => one.y) || {}).y;
  const width = svg.clientWidth || 600, height = svg.clientHeight || 240;
  svg.setAttribute("viewBox", `0 0 ${width} ${height}`);
  const nodes = [];
  const add = (name, attributes, text) => {
    const node = document.createElementNS("http://www.w3.org/2000/svg", name);
    for (const [key, value] of Object.entries(attributes)) node.setAttribute(key, value);
    if (text !== undefined) node.textContent = text;
    nodes.push(node);
    return node;
  };
  const part = (axis, value) => axis.log
    ? Math.log(Math.max(value, axis.min) / axis.min) / (Math.log(axis.max / axis.min) || 1)
    : (value - axis.min) / (axis.max - axis.min || 1);
  const right = width - (other ? margin.left : margin.right), bottom = height - margin.bottom;
  const inside = (value) => Math.min(1, Math.max(0, value));
  const at_x = (value) => margin.left + (right - margin.left) * part(x, value);
  const on = (axis) => (value) => bottom - (bottom - margin.top) * inside(part(axis, value));
  const at_y = on(y);
  if (band) {
    const upper = at_y(band[1]), lower = at_y(band[0]);
    add("rect", { x: margin.left, y: upper, width: right - margin.left, height: lower - upper, class: "band" });
    for (const limit of [upper, lower]) add("line", { x1: margin.left, x2: right, y1: limit, y2: limit, class: "limit" });
  }
  for (const value of ticks(y)) {
    add("line", { x1: margin.left, x2: right, y1: at_y(value), y2: at_y(value), class: value === 0 ? "zero" : "grid" });
    add("text", { x: margin.left - 6, y: at_y(value) + 4, "text-anchor": "end" }, words(y, value));
  }
  for (const value of other ? ticks(other) : []) {
    add("text", { x: right + 6, y: on(other)(value) + 4 }, words(other, value));
  }
  let free = -Infinity;
  for (const value of ticks({ ...x, wanted: width / 110 })) {
    add("line", { x1: at_x(value), x2: at_x(value), y1: margin.top, y2: bottom, class: "grid" });
    if (at_x(value) < free) continue;
    free = at_x(value) + (x.spacing || 34);
    add("text", { x: at_x(value), y: bottom + 15, "text-anchor": "middle" }, words(x, value));
  }
  add("text", { x: (margin.left + right) / 2, y: height - 3, "text-anchor": "middle" }, x.label);
  for (const one of series) draw(add, one, at_x, one.y ? on(one.y) : at_y);
  svg.replaceChildren(...nodes);
}

function draw(add, series, at_x, at_y) {
  const name = (kind, point) => [kind, series.class, point && point.class].filter(Boolean).join(" ");
  if (series.kind === "trace") {
    const line = series.points.map((p) => at_x(p.x).toFixed(1) + "," + at_y(p.y).toFixed(1)).join(" ");
    add("polyline", { points: line, class: name("trace") });
    return;
  }
  for (const p of series.points) {
    if (p.u) {
      const ends = { y1: at_y(p.y - p.u), y2: at_y(p.y + p.u) };
      add("line", { x1: at_x(p.x), x2: at_x(p.x), ...ends, class: name("bar", p) });
      for (const end of Object.values(ends)) add("line", { x1: at_x(p.x) - 3, x2: at_x(p.x) + 3, y1: end, y2: end, class: name("bar", p) });
    }
    const mark = add("circle", { cx: at_x(p.x), cy: at_y(p.y), r: 3.5, class: name("point mark", p) });
    if (p.title) mark.appendChild(document.createElementNS("http://www.w3.org/2000/svg", "title")).textContent = p.title;
  }
}

/** Limits around values, not narrower than `least`. */
export function around(values, least) {
  const low = Math.min(...values), high = Math.max(...values), middle = (low + high) / 2;
  const half = Math.max((high - low) * 0.58, least / 2);
  return { min: middle - half, max: middle + half };
}
