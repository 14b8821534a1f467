// Pictures of an edit: two under a wipe, the difference from the full trace, and side by side for print.
const blocks = new Map(Object.entries(data.pictures));
const sourceOf = (file) => blocks.has(file) ? byId(blocks.get(file)).textContent : null;
const gains = document.querySelectorAll("#exposed feComponentTransfer > *");

// One exposure for the whole page: a factor on linear values, as in the program.
function expose(stops) {
  gains.forEach((gain) => gain.setAttribute("slope", 2 ** stops));
  document.documentElement.classList.toggle("exposed", stops !== 0);
  document.querySelectorAll("input.exposure").forEach((slider) => {
    slider.value = stops;
    slider.nextElementSibling.textContent = `${stops > 0 ? "+" : ""}${minus(String(stops))} EV`;
  });
}

// Returns elements that show the pictures of a value; none without two pictures.
function wipe(scene, value) {
  const pictureOf = ({ level, picture, difference, error }) =>
    ({ level, name: settingOf(level).label, source: sourceOf(picture), difference: sourceOf(difference), isEqual: error.values === 0 });
  const found = [{ name: "before", source: sourceOf(scene.before) }, ...value.rungs.map(pictureOf)].filter((p) => p.source);
  if (found.length < 2) {
    return [];
  }
  const made = byId("wipe").content.cloneNode(true);
  const part = (name) => made.querySelector(name);
  const [view, cut, left, right, difference, equal] = [".wipe", ".cut", "img.left", "img.right", ".difference", ".stage p"].map(part);
  made.querySelectorAll(".stage").forEach((stage) => { stage.style.aspectRatio = `${scene.width} / ${scene.height}`; });
  const show = (image, picture) => Object.assign(image, { src: picture.source, alt: picture.name });
  const showDifference = (picture) => {
    difference.hidden = !picture.difference;
    difference.src = picture.difference || "data:,";
    difference.alt = `difference of ${picture.name}, false colors`;
    equal.textContent = picture.isEqual ? "bit-identical" : "no picture";
  };
  // Fills a select with pictures, shows one, and then each that is chosen.
  const choose = (select, pictures, start, act) => {
    select.append(...pictures.map((p) => element("option", {}, p.name)));
    select.selectedIndex = pictures.indexOf(start);
    select.addEventListener("change", () => act(pictures[select.selectedIndex]));
    act(start);
  };
  const of = (level) => found.find((p) => p.level === level);
  const after = of(data.usual) || of("EXACT") || found.at(-1);
  const compared = found.filter((p) => p.level && p.level !== "FULL_TRACE");
  const ofSelect = part("select.of");
  choose(ofSelect, compared, compared.includes(after) ? after : compared[0], showDifference);
  choose(part("select.left"), found, found[0], (p) => show(left, p));
  choose(part("select.right"), found, after, (p) => {
    show(right, p);
    if (compared.includes(p)) {
      ofSelect.selectedIndex = compared.indexOf(p);
      showDifference(p);
    }
  });
  cut.addEventListener("input", () => view.style.setProperty("--cut", `${cut.value}%`));
  part(".exposure").addEventListener("input", (e) => expose(Number(e.target.value)));
  const full = of("FULL_TRACE");
  const side = [found[0], after, ...(full && full !== after ? [full] : []),
    ...(after.difference ? [{ name: "difference, false colors", source: after.difference }] : [])];
  part(".side").append(...side.map((p) => element("figure", {}, show(element("img", {}), p), element("figcaption", {}, p.name))));
  return [...made.children];
}
