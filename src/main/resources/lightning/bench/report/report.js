"use strict";
document.documentElement.classList.add("scripted");
document.body.insertAdjacentHTML("beforeend", '\u003csvg width="0" height="0" style="position:absolute" aria-hidden="true">\u003cfilter id="exposed" color-interpolation-filters="linearRGB">\u003cfeComponentTransfer>\u003cfeFuncR type="linear"/>\u003cfeFuncG type="linear"/>\u003cfeFuncB type="linear"/>\u003c/feComponentTransfer>\u003c/filter>\u003c/svg>');

const gains = document.querySelectorAll("#exposed feFuncR, #exposed feFuncG, #exposed feFuncB");

// One exposure for the whole page: a factor on linear values, as in the program.
function expose(stops) {
  gains.forEach(gain => gain.setAttribute("slope", 2 ** stops));
  document.documentElement.classList.toggle("exposed", stops !== 0);
  for (const slider of document.querySelectorAll("input.exposure")) {
    slider.value = stops;
    slider.nextElementSibling.textContent = (stops > 0 ? "+" : "") + stops + " EV";
  }
}

for (const wipe of document.querySelectorAll(".wipe")) {
  const part = name => wipe.querySelector(name);
  const show = (element, style) => {
    element.className = element.className.replace(/\s+p\d+|\s+$/g, "") + " " + style;
  };
  part(".cut").addEventListener("input", e => wipe.style.setProperty("--cut", e.target.value + "%"));
  part(".exposure").addEventListener("input", e => expose(Number(e.target.value)));
  part("select.left").addEventListener("change", e => show(part(".pic.left"), e.target.value));
  part("select.right").addEventListener("change", e => {
    show(part(".pic.right"), e.target.value);
    const same = [...part("select.of").options].find(option => option.text === e.target.selectedOptions[0].text);
    if (same) {
      part("select.of").selectedIndex = same.index;
      show(part(".pic.difference"), same.value);
    }
  });
  part("select.of").addEventListener("change", e => show(part(".pic.difference"), e.target.value));
}
