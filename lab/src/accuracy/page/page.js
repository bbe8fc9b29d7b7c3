"use strict";
(() => {
  const { truth, points } = JSON.parse(document.getElementById("sweep").textContent);
  const element = (id) => document.getElementById(id);
  element("truth").src = truth;
  const choose = (index) => {
    const point = points[index], kept = point.pictures !== null;
    element("name").textContent = point.name;
    element("settings").textContent = point.hint.split("\n").slice(1).join("\n");
    element("frame-caption").textContent = kept ? `${point.name}, ${point.psnr} dB` : "This point’s pictures are not in the page.";
    for (const name of ["frame", "difference"]) {
      element(name).style.visibility = kept ? "visible" : "hidden";
      if (kept) element(name).src = point.pictures[name];
    }
    for (const other of document.querySelectorAll("[data-index]")) {
      const chosen = other.dataset.index === String(index);
      other.classList.toggle("chosen", chosen);
    }
    // It lies over all others, and lets the pointer through to them.
    document.querySelectorAll(".overlay").forEach((old) => old.remove());
    for (const point of document.querySelectorAll("svg .chosen")) {
      const overlay = point.cloneNode(true);
      overlay.removeAttribute("data-index");
      overlay.removeAttribute("tabindex");
      overlay.classList.add("overlay");
      point.parentNode.append(overlay);
    }
  };
  for (const point of document.querySelectorAll("[data-index]")) {
    for (const event of ["mouseenter", "focus", "click"]) point.addEventListener(event, () => choose(point.dataset.index));
  }
  choose(Math.max(points.findIndex((point) => point.is_on_front), 0));
})();
