"use strict";
(() => {
  const { slice, cycles, states, units } = JSON.parse(document.getElementById("timeline").textContent);
  const strips = document.getElementById("strips"), words = document.getElementById("slice");
  const number = (count) => count.toLocaleString("en");
  const rest = "Point at a strip for its figures.";
  const draw = () => {
    const style = getComputedStyle(strips);
    const colors = states.map(({ key }) => style.getPropertyValue(`--${key}`));
    for (const canvas of strips.querySelectorAll("canvas")) {
      const scale = window.devicePixelRatio || 1, width = canvas.clientWidth * scale, height = canvas.clientHeight * scale;
      Object.assign(canvas, { width, height });
      const context = canvas.getContext("2d"), { count, states: rows } = units[canvas.dataset.unit];
      for (let i = 0; i < rows[0].length; i += 1) {
        // Edges lie between pixels, so that slices leave no seams.
        const [left, right] = [i * slice, Math.min((i + 1) * slice, cycles)].map((cycle) => Math.round((cycle / cycles) * width));
        const length = count * (Math.min((i + 1) * slice, cycles) - i * slice);
        let below = 0;
        rows.forEach((counts, state) => {
          const [low, high] = [below, below + counts[i]].map((count) => Math.round((count / length) * height));
          context.fillStyle = colors[state];
          context.fillRect(left, height - high, right - left, high - low);
          below += counts[i];
        });
      }
    }
  };
  const axis = strips.querySelector(".axis .track");
  const step = 10 ** Math.floor(Math.log10(cycles / 2));
  const gap = [1, 2, 5].map((factor) => factor * step).find((gap) => cycles / gap <= 5) || 10 * step;
  for (let cycle = 0; cycle <= cycles; cycle += gap) {
    const tick = document.createElement("span");
    tick.textContent = number(cycle);
    tick.style.left = `${(100 * cycle) / cycles}%`;
    // What would run over an end is drawn to its inner side.
    tick.className = cycle === 0 ? "first" : cycle > 0.93 * cycles ? "last" : "";
    axis.append(tick);
  }
  const point = (event) => {
    const unit = units[event.target.dataset.unit];
    if (!unit) return;
    const box = event.target.getBoundingClientRect();
    const at = Math.floor((((event.clientX - box.left) / box.width) * cycles) / slice);
    const i = Math.min(Math.max(at, 0), unit.states[0].length - 1);
    const end = Math.min((i + 1) * slice, cycles), length = end - i * slice;
    const parts = states.map(({ label }, state) => [label, unit.states[state][i]]).filter(([, count]) => count > 0);
    const share = (count) => ((100 * count) / (unit.count * length)).toFixed(0);
    const shares = parts.map(([label, count]) => `${label} ${share(count)} %`).join(", ");
    words.textContent = `${unit.name}, cycles ${number(i * slice)} to ${number(end - 1)}: ${shares || "none of these"}`;
  };
  strips.addEventListener("pointermove", point);
  strips.addEventListener("pointerdown", point);
  strips.addEventListener("pointerleave", () => { words.textContent = rest; });
  words.textContent = rest;
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", draw);
  new ResizeObserver(draw).observe(strips);
  draw();
})();
