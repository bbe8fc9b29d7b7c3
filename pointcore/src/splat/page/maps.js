"use strict";
(() => {
  const { tile, maps } = JSON.parse(document.getElementById("maps").textContent);
  const dark = matchMedia("(prefers-color-scheme: dark)");
  // The lowest count is near the ground, the highest far from it.
  const stops = {
    light: [[254, 232, 170], [253, 174, 80], [226, 98, 24], [160, 40, 10], [80, 8, 20]],
    dark: [[60, 34, 98], [126, 42, 120], [205, 70, 80], [248, 150, 50], [252, 250, 170]],
  };
  const color = (share) => {
    const colors = dark.matches ? stops.dark : stops.light;
    const at = Math.min(Math.max(share, 0), 1) * (colors.length - 1), first = Math.min(Math.floor(at), colors.length - 2);
    return colors[first].map((c, i) => Math.round(c + (at - first) * (colors[first + 1][i] - c)));
  };
  const counts = async ({ image, size: [width, height] }) => {
    const picture = new Image();
    picture.src = image;
    await picture.decode();
    const context = Object.assign(document.createElement("canvas"), { width, height }).getContext("2d");
    context.drawImage(picture, 0, 0);
    const { data } = context.getImageData(0, 0, width, height);
    return Array.from({ length: width * height }, (_, i) => (data[4 * i] << 16) | (data[4 * i + 1] << 8) | data[4 * i + 2]);
  };
  const byTile = ({ size: [width, height], counts }) => {
    const size = [Math.ceil(width / tile), Math.ceil(height / tile)], sums = new Array(size[0] * size[1]).fill(0);
    counts.forEach((count, i) => { sums[Math.floor(i / width / tile) * size[0] + Math.floor((i % width) / tile)] += count; });
    return { size, counts: sums, cell: tile };
  };
  const show = (figure, map, view) => {
    const { size: [width, height], counts, cell } = view;
    const canvas = figure.querySelector("canvas"), context = canvas.getContext("2d");
    const set = counts.filter((count) => count > 0).sort((a, b) => a - b);
    const largest = set.length ? set[set.length - 1] : 0, at = counts.indexOf(largest);
    // A few places may be far above all others: the scale ends where the last two hundredth begins.
    const high = set.length ? Math.max(set[Math.floor(0.995 * (set.length - 1))], 1) : 1;
    // Its middle is a count, too.
    const end = high > 3 ? 2 * Math.ceil(high / 2) : high;
    Object.assign(canvas, { width, height });
    const pixels = context.createImageData(width, height);
    counts.forEach((count, i) => { if (count) pixels.data.set([...color(count / end), 255], 4 * i); });
    context.putImageData(pixels, 0, 0);
    const parts = [0, 0.25, 0.5, 0.75, 1].map((share) => `rgb(${color(share)})`).join(",");
    figure.querySelector(".scale").style.background = `linear-gradient(to right,${parts})`;
    const ticks = figure.querySelectorAll(".ticks span"), number = (count) => count.toLocaleString("en");
    ticks[0].textContent = "0";
    ticks[1].textContent = end % 2 ? "" : number(end / 2);
    ticks[2].textContent = largest > end ? `${number(end)} and more` : number(end);
    const name = (i) => (cell > 1 ? `tile ${i % width}, ${Math.floor(i / width)}` : `column ${i % width}, row ${Math.floor(i / width)}`);
    const words = figure.querySelector(".words");
    const rest = () => {
      words.textContent = largest ? `Largest ${number(largest)}, at ${name(at)}; ${number(map.sum)} in all` : "None in the whole frame";
    };
    const point = (event) => {
      const box = canvas.getBoundingClientRect();
      const column = Math.floor(((event.clientX - box.left) / box.width) * width), row = Math.floor(((event.clientY - box.top) / box.height) * height);
      if (column < 0 || row < 0 || column >= width || row >= height) return;
      const i = row * width + column;
      words.textContent = `${number(counts[i])} at ${name(i)}`;
    };
    Object.assign(canvas, { onpointermove: point, onpointerdown: point, onpointerleave: rest });
    rest();
  };
  Promise.all(maps.map(async (map) => {
    const whole = { ...map, counts: await counts(map) };
    return { map, pixel: whole, tile: map.cell > 1 ? whole : byTile(whole) };
  })).then((views) => {
    const draw = () => {
      const cells = document.querySelector("input[name=cells]:checked");
      for (const figure of document.querySelectorAll("[data-map]")) {
        const view = views[figure.dataset.map];
        show(figure, view.map, view[cells ? cells.value : "pixel"]);
      }
    };
    document.querySelectorAll("input[name=cells]").forEach((choice) => choice.addEventListener("change", draw));
    dark.addEventListener("change", draw);
    draw();
  });
})();
