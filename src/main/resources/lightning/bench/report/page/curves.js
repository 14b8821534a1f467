// Sections of all scenes: drift, growth, editing, meshes, modern scenes and indirect light.
const HEIGHT = 300;
// Edits to highlight among many: one for each kind of update.
const TYPICAL = ["color", "position", "attenuation", "angle-larger", "add", "mirrors updated after position"];

function driftFigure(drift) {
  const curve = (accuracy, name, ink, isDashed, value) => ({ name, ink, isDashed,
    points: drift.points.filter((p) => p.accuracy === accuracy).map((p) => [p.edits, value(p)]) });
  const refreshes = Math.max(0, ...drift.points.map((p) => p.refreshes));
  return figure(nameOf(drift), `Maximum difference of any value (linear) against the number of edits. Setting ratio ${
    refreshes === 0 ? "never had to recompute." : `recomputed ${refreshes} times.`}`,
  curveChart(`Error after many edits, ${nameOf(drift)}`, [
    curve("RATIO", "ratio", "purple", false, (p) => p.error.maxAbsolute),
    curve("RATIO", "ratio, bound", "purple", true, (p) => p.bound),
    curve("EXACT", "exact", "ours", false, (p) => p.error.maxAbsolute)], HEIGHT, tick, powerTick));
}

function growthFigure(growth) {
  const edits = [...new Set(growth.points.flatMap((p) => p.edits.map((e) => e.edit)))];
  const hasFew = edits.length <= TYPICAL.length;
  edits.sort((a, b) => TYPICAL.includes(a) - TYPICAL.includes(b));
  const curves = edits.map((edit) => {
    const isNamed = hasFew || TYPICAL.includes(edit);
    return { name: isNamed ? edit : "", ink: isNamed ? INKS[(hasFew ? edits : TYPICAL).indexOf(edit)] : "paper",
      points: growth.points.flatMap((p) => p.edits.filter((e) => e.edit === edit).map((e) => [p.at, e.time.median])) };
  });
  const full = { name: "full trace", ink: "text", points: growth.points.map((p) => [p.at, p.fullTrace.median]) };
  return figure(`Growth with ${growth.along}`, `Time (ms) against ${growth.along}; ${growth.scene}.${hasFew ? "" : " Gray: the other edits."}`,
    curveChart(`Time against ${growth.along}`, [full, ...curves], HEIGHT, tick, tick));
}

function modernFigure(scene) {
  const curves = scene.curves.map((curve, i) => ({ name: curve.program, ink: INKS[i % INKS.length],
    points: curve.points.filter((p) => isPlausible(p.time.median)).map((p) => [p.time.median, p.error]).sort((a, b) => a[0] - b[0]) }));
  return figure(scene.scene, "Error against time (ms).", curveChart(`Error against time (ms), ${scene.scene}`, curves, 260, tick, percentTick));
}

// Mean error against the time of the first pass; the default is filled, and each number of rays has a color.
function meanErrors(title, what, axes, list, label, mean, series = () => 0) {
  const kinds = [...new Set(list.map(series))].sort((a, b) => a - b);
  const chart = paretoChart(`Mean error of ${what} against time (ms), ${title}`, list.map((p) => {
    const i = kinds.indexOf(series(p));
    return { label: label(p), ink: INKS[i % INKS.length], shape: SHAPES[i % SHAPES.length], isFilled: p.usesDefault, time: p.time, error: mean(p) };
  }), chartWidth, HEIGHT, percentTick);
  return figure(what === "indirect light" ? title : `${title}, ${what}`, `Mean error against the time of the first pass (ms)${axes}.`, chart);
}

const withoutZeros = (points) => points.filter((p) => p.every(isPlausible)).sort((a, b) => a[0] - b[0]);

function indirectGrowth(growth) {
  const curve = (name, ink, value) => ({ name, ink, points: withoutZeros(growth.points.map((p) => [p.at, value(p)])) });
  return figure(`Growth with ${growth.along}`, `Time (ms) against ${growth.along}; ${growth.scene}.`,
    curveChart(`Time (ms) of indirect light against ${growth.along}`, [curve("first pass, added", "ours", (p) => p.extraMs),
      curve("moved light", "red", (p) => p.position.median), curve("intensity", "green", (p) => p.intensity.median)], HEIGHT, tick, tick));
}

function indirectFigures({ accuracy, reflections, softShadows, growth }) {
  const bounces = accuracy.map((scene, i) => ({ name: scene.scene, ink: INKS[i % INKS.length],
    points: withoutZeros(scene.byBounces.map((p) => [p.bounces, p.error.missing])) }));
  return figures(
    ...accuracy.map((scene) =>
      meanErrors(scene.scene, "indirect light", "", scene.grid, (p) => `${p.spacing}, ${p.rays}`, (p) => p.error.mean, (p) => p.rays)),
    ...reflections.filter((scene) => scene.points.length > 0).map((scene) =>
      meanErrors(scene.scene, "blurred reflections", "; labels are rays", scene.points, (p) => String(p.rays), (p) => p.mean)),
    ...softShadows.map((scene) =>
      meanErrors(scene.scene, "area lights", "; labels are samples", scene.points, (p) => String(p.samples), (p) => p.mean)),
    ...(accuracy.length > 0 ? [figure("Bounces", "Share of the light of eight bounces that is missing, against bounces.",
      curveChart("Missing light against bounces", bounces, HEIGHT, tick, percentTick))] : []),
    ...growth.map(indirectGrowth));
}

// Lists inner items together with the items that have them.
const pairs = (list, key) => list.flatMap((outer) => outer[key].map((inner) => ({ ...inner, outer })));

fill("drift", results.drift.length > 0, figures(...results.drift.map(driftFigure)));
fill("growth", results.growth.length > 0, figures(...results.growth.map(growthFigure)));
fill("editing", results.editing.length > 0, table("edits", "Scene operations without the window: medians, and heap bytes per shape", results.editing,
  ["shapes, lights", (e) => `${grouped(e.shapes)}, ${grouped(e.lights)}`],
  ...[["load", "load"], ["tree", "tree"], ["new scene", "newScene"], ["plan", "plan"], ["first hover", "hover"]].map(([title, key]) =>
    [title, (e) => ms(e[key].median)]),
  ["document", (e) => withUnit(e.documentBytes, "B")], ["primitives and tree", (e) => withUnit(e.treeBytes, "B")]));
fill("meshes", results.meshes.length > 0,
  table("edits", "Million rays per second", pairs(results.meshes, "rays"),
    ["triangles, rays", (m) => `${grouped(m.outer.triangles)}, ${m.rays}`], ["Lightning", (m) => threeDigits(m.millionsPerSecond)],
    ["Embree", (m) => threeDigits(m.rivalMillionsPerSecond)], ["ratio", (m) => m.rival && withUnit(m.share, "%")]),
  table("edits", "BVH build", results.meshes,
    ["triangles", (m) => grouped(m.triangles)], ["Lightning", (m) => ms(m.tree.median)], ["Embree", (m) => m.rival && ms(m.rival.tree.median)],
    ["bytes per triangle", (m) => threeDigits(m.treeBytes)], ["Embree, bytes", (m) => m.rival && threeDigits(m.rival.treeBytes)]));
fill("modern", results.modern.length > 0,
  figures(...results.modern.filter((scene) => scene.curves.length > 0).map(modernFigure)),
  table("edits", "Updates after one edit", pairs(pairs(results.modern, "pictures"), "edits"),
    ["scene, anti-aliasing, edit", (e) => `${e.outer.outer.scene}, ${e.outer.sampling}, ${e.edit}`], ["update", (e) => ms(e.time.median)],
    ["full trace", (e) => ms(e.fullTrace.median)], ["saves", (e) => percent(e.saving)]),
  table("edits", "Time and error of anti-aliasing", pairs(pairs(results.modern, "curves"), "points"),
    ["scene, program, setting", (p) => `${p.outer.outer.scene}, ${p.outer.program}, ${p.setting}`], ["time", (p) => ms(p.time.median)],
    ["error", (p) => error(p.error)]));
const indirect = results.indirect;
fill("indirect", Object.values(indirect).some((part) => part.length > 0), indirectFigures(indirect),
  table("edits", "Updates after one edit", pairs(indirect.costs, "edits"),
    ["scene, edit", (e) => `${e.outer.scene}, ${e.edit}`], ["update", (e) => ms(e.time.median)],
    ["without indirect light", (e) => ms(e.without.median)], ["first pass", (e) => ms(e.outer.first.median)]),
  table("edits", "Scenes without indirect light", indirect.absence,
    ["scene", (s) => s.scene], ["bytes", (s) => String(s.bytes)], ["rays", (s) => String(s.rays)], ["first pass", (s) => ms(s.absent.median)],
    ["with hidden indirect light", (s) => ms(s.hidden.median)]));
