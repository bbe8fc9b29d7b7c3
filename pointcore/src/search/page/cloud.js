"use strict";
(() => {
  const { points, queries, cycles } = JSON.parse(document.getElementById("search").textContent);
  const canvas = document.getElementById("cloud");
  const sorted = [...cycles].sort((a, b) => a - b);
  // A few queries wait for all others: the scale ends where the last fiftieth begins.
  const least = sorted[0], most = Math.max(sorted[Math.floor(0.98 * (sorted.length - 1))], least + 1);
  const stops = [[68, 1, 84], [59, 82, 139], [33, 145, 140], [94, 201, 98], [253, 231, 37]];
  const lightStops = [[68, 1, 84], [52, 94, 158], [20, 133, 130], [214, 120, 20], [200, 20, 30]];
  const dark = matchMedia("(prefers-color-scheme: dark)");
  const ramp = (share) => {
    const colors = dark.matches ? stops.map(([r, g, b]) => [r + 50, g + 20, b + 20].map((c) => Math.min(c, 255))) : lightStops;
    const at = Math.min(Math.max(share, 0), 1) * (colors.length - 1), first = Math.min(Math.floor(at), colors.length - 2);
    return `rgb(${colors[first].map((c, i) => Math.round(c + (at - first) * (colors[first + 1][i] - c)))})`;
  };
  const high = [0, 1, 2].map((axis) => points.reduce((most, point) => Math.max(most, point[axis]), 1));
  const radius = Math.hypot(...high) / 2;
  // The thinnest side of the cloud faces the viewer, a little from the side.
  const depthAxis = high.indexOf(Math.min(...high)), across = (depthAxis + 1) % 3, up = (depthAxis + 2) % 3;
  let turn = 0.35, tilt = 0.25;
  const draw = () => {
    const scale = window.devicePixelRatio || 1, width = canvas.clientWidth, height = canvas.clientHeight;
    canvas.width = width * scale;
    canvas.height = height * scale;
    const context = canvas.getContext("2d");
    context.scale(scale, scale);
    const zoom = Math.min(0.66 * height, 0.6 * width) / radius;
    const [ct, st, cp, sp] = [Math.cos(turn), Math.sin(turn), Math.cos(tilt), Math.sin(tilt)];
    const project = (point) => {
      const [x, y, z] = [across, up, depthAxis].map((axis) => point[axis] - high[axis] / 2);
      const side = ct * x + st * z, away = ct * z - st * x;
      return [width / 2 + zoom * side, height / 2 - zoom * (cp * y - sp * away), sp * y + cp * away];
    };
    context.fillStyle = dark.matches ? "rgba(160,170,185,0.25)" : "rgba(60,70,85,0.22)";
    for (const point of points) {
      const [x, y] = project(point);
      context.fillRect(x - 0.6, y - 0.6, 1.2, 1.2);
    }
    const size = queries.length > 5000 ? 1.6 : 2.4;
    const placed = queries.map((point, index) => [...project(point), cycles[index]]).sort((a, b) => a[2] - b[2]);
    for (const [x, y, , taken] of placed) {
      context.fillStyle = ramp((taken - least) / (most - least));
      context.beginPath();
      context.arc(x, y, size, 0, 7);
      context.fill();
    }
    const parts = [0, 0.25, 0.5, 0.75, 1].map(ramp).join(",");
    document.getElementById("scale").style.background = `linear-gradient(to right,${parts})`;
  };
  document.getElementById("least").textContent = least;
  document.getElementById("most").textContent = sorted[sorted.length - 1] > most ? `${most} and more` : most;
  let from = null;
  canvas.addEventListener("pointerdown", (event) => {
    from = [event.clientX, event.clientY];
    canvas.setPointerCapture(event.pointerId);
  });
  canvas.addEventListener("pointermove", (event) => {
    if (!from) return;
    turn += (event.clientX - from[0]) / 150;
    tilt = Math.min(Math.max(tilt + (event.clientY - from[1]) / 150, -1.5), 1.5);
    from = [event.clientX, event.clientY];
    draw();
  });
  canvas.addEventListener("pointerup", () => { from = null; });
  dark.addEventListener("change", draw);
  new ResizeObserver(draw).observe(canvas);
  draw();
})();
