"use strict";
(() => {
  const compare = document.getElementById("compare");
  const slider = compare.querySelector("input[type=range]");
  const update = () => {
    const chosen = compare.querySelector("input[type=radio]:checked");
    compare.style.setProperty("--split", `${slider.value}%`);
    compare.dataset.other = chosen.value;
    compare.querySelector(".other").textContent = chosen.dataset.label || "reference";
  };
  compare.addEventListener("input", update);
  update();
})();
