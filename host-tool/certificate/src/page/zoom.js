// Zooms the plots: moves what the drawing already holds, computes no values.
"use strict";
(() => {
  const plots = [...document.querySelectorAll("svg.plot")].map((svg) => {
    const [left, top, right, bottom] = svg.dataset.area.split(" ").map(Number);
    return { svg, left, top, right, bottom, view: [left, top, right, bottom] };
  });
  const whole = (p) => [p.left, p.top, p.right, p.bottom];

  function draw(p) {
    const [x0, y0, x1, y1] = p.view;
    const sx = (p.right - p.left) / (x1 - x0), sy = (p.bottom - p.top) / (y1 - y0);
    const X = (x) => p.left + (x - x0) * sx, Y = (y) => p.top + (y - y0) * sy;
    const inside = (v, a, b) => v >= a - 0.5 && v <= b + 0.5;
    for (const axis of ["x", "y"]) {
      const ticks = [...p.svg.querySelectorAll(`.tick[data-${axis}]`)];
      const [to, a, b] = axis === "x" ? [X, p.left, p.right] : [Y, p.top, p.bottom];
      // A finer level shows when its ticks have room.
      const room = (level) => {
        const at = ticks.filter((t) => t.dataset.level <= level).map((t) => to(+t.dataset[axis]))
          .filter((v) => inside(v, a, b)).sort((u, v) => u - v);
        return at.every((v, i) => !i || v === at[i - 1] || v - at[i - 1] > (axis === "x" ? 26 : 22));
      };
      const shown = room(2) ? 2 : room(1) ? 1 : 0;
      for (const t of ticks) {
        const v = to(+t.dataset[axis]), fine = t.dataset.level > shown;
        t.style.display = inside(v, a, b) ? "" : "none";
        t.setAttribute("transform", axis === "x" ? `translate(${v},0)` : `translate(0,${v})`);
        for (const e of t.children) e.style.display = fine && !e.matches(".minor:not(.fine)") ? "none" : "inline";
      }
    }
    for (const mark of p.svg.querySelectorAll(".mark")) {
      const x = X(+mark.dataset.x), y = mark.dataset.y ? Y(+mark.dataset.y) : p.bottom - 9;
      mark.setAttribute("transform", `translate(${x},${y})`);
      const bar = mark.querySelector(".bar");
      if (bar) {
        const h = bar.dataset.half * sy;
        bar.setAttribute("d", `M-4,${-h}h8M0,${-h}V${h}M-4,${h}h8`);
      }
    }
    for (const line of p.svg.querySelectorAll("[data-points]")) {
      line.setAttribute("points", line.dataset.points.split(" ").map((pair) => {
        const [x, y] = pair.split(",").map(Number);
        return `${X(x)},${Y(y)}`;
      }).join(" "));
    }
  }

  function position(p, event) {
    const box = p.svg.getBoundingClientRect(), view = p.svg.viewBox.baseVal;
    const x = (event.clientX - box.left) * view.width / box.width;
    const y = (event.clientY - box.top) * view.height / box.height;
    return [Math.min(p.right, Math.max(p.left, x)), Math.min(p.bottom, Math.max(p.top, y))];
  }

  for (const p of plots) {
    let from = null;
    const box = document.createElementNS(p.svg.namespaceURI, "rect");
    box.setAttribute("style", "fill:#1f5fa822;stroke:#1f5fa8;display:none");
    p.svg.append(box);
    p.svg.addEventListener("pointerdown", (event) => {
      from = position(p, event);
      p.svg.setPointerCapture(event.pointerId);
    });
    p.svg.addEventListener("pointermove", (event) => {
      if (!from) return;
      const to = position(p, event);
      const set = (name, value) => box.setAttribute(name, value);
      set("x", Math.min(from[0], to[0])); set("y", Math.min(from[1], to[1]));
      set("width", Math.abs(to[0] - from[0])); set("height", Math.abs(to[1] - from[1]));
      box.style.display = "inline";
    });
    p.svg.addEventListener("pointerup", (event) => {
      const to = position(p, event), start = from;
      from = null;
      box.style.display = "none";
      if (!start || Math.abs(to[0] - start[0]) < 8 || Math.abs(to[1] - start[1]) < 8) return;
      const [x0, y0, x1, y1] = p.view;
      const px = (x) => x0 + (x - p.left) * (x1 - x0) / (p.right - p.left);
      const py = (y) => y0 + (y - p.top) * (y1 - y0) / (p.bottom - p.top);
      p.view = [px(Math.min(start[0], to[0])), py(Math.min(start[1], to[1])),
        px(Math.max(start[0], to[0])), py(Math.max(start[1], to[1]))];
      draw(p);
    });
    p.svg.addEventListener("dblclick", () => { p.view = whole(p); draw(p); });
  }
  const reset = () => plots.forEach((p) => { p.view = whole(p); draw(p); });
  document.getElementById("whole").addEventListener("click", reset);
  window.addEventListener("beforeprint", reset);
})();
