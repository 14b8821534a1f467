// Sections of scenes: savings and accuracy, tables of settings, edits and effects, other programs, and each edit.
const nameOf = (scene) => `${scene.scene}, ${scene.width} × ${scene.height}`;
const pointOf = (value, setting) => value?.rungs.find((point) => point.level === setting);
const firstOf = (edit, setting) => pointOf(edit.values[0], setting);
const savingOf = (edit, setting) => mean(edit.values.flatMap((value) => pointOf(value, setting) || []).map((point) => point.saving));

// Each accuracy setting over all edits: the median time and saving, and the worst of each error.
function summariesOf(scene) {
  const all = scene.edits.flatMap((edit) => edit.values.flatMap((value) => value.rungs));
  return data.settings.map((setting) => ({ setting, points: all.filter((point) => point.level === setting.name) }))
    .filter(({ points }) => points.length > 0).map(({ setting, points }) => {
      const timeOf = (key) => median(points.map((point) => point.time[key]));
      const worst = (of, key) => of(...points.map((point) => point.error[key]));
      // Uncertain savings count as the smallest.
      const saving = median(points.map((point) => Number.isNaN(point.saving) ? -Infinity : point.saving));
      const error = Object.fromEntries(["maxUlp", "maxAbsolute", "meanAbsolute", "rmse", "flip"].map((key) => [key, worst(Math.max, key)]));
      ["linearPsnr", "displayPsnr", "ssim"].forEach((key) => { error[key] = worst(Math.min, key); });
      const most = points.map((point) => point.error).reduce((a, b) => b.values / b.of > a.values / a.of ? b : a);
      const time = { lowerQuartile: timeOf("lowerQuartile"), median: timeOf("median"), upperQuartile: timeOf("upperQuartile") };
      return { level: setting.name, time, saving: Number.isFinite(saving) ? saving : NaN, error: { ...error, values: most.values, of: most.of } };
    });
}

const errorChart = (name, list, width, height) => paretoChart(name, list.map(({ level, time, error }) => {
  const i = data.settings.findIndex((setting) => setting.name === level);
  return { label: data.settings[i].label, ink: SETTING_INKS[i], shape: SHAPES[i], isFilled: level !== "EXACT", time, error: error.rmse };
}), width, height, powerTick);

// Settings with times and errors; those of a scene have two columns more.
const settingsTable = (style, caption, list, isOfScene) => table(style, caption, list,
  ["setting", (p) => settingOf(p.level).label], ["time", (p) => ms(p.time.median)], ["saves", (p) => percent(p.saving)],
  ["differing values", (p) => share(p.error.values, p.error.of)], ["max. ulp", (p) => grouped(p.error.maxUlp)],
  ["max. difference", (p) => error(p.error.maxAbsolute)], ...(isOfScene ? [["mean difference", (p) => error(p.error.meanAbsolute)]] : []),
  ["RMSE", (p) => error(p.error.rmse)], ...(isOfScene ? [["PSNR", (p) => decibels(p.error.linearPsnr)]] : []),
  [isOfScene ? "PSNR displayed" : "PSNR", (p) => decibels(p.error.displayPsnr)], ["SSIM", (p) => similarity(p.error.ssim)], ["ꟻLIP", (p) => error(p.error.flip)]);

const workOf = (edit) => firstOf(edit, data.usual)?.work;
const editsCaption = `Each edit at setting ${usual}: work of its first value, savings averaged over all values.`;
const editsTable = (scene) => table("plans", editsCaption, scene.edits,
  ["edit", (e) => e.edit], ["plan", (e) => workOf(e)?.plan],
  ...[["rows touched", "rowsTouched"], ["shadow rays", "shadowRays"], ["avoided", "shadowRaysAvoided"]].map(([title, key]) =>
    [title, (e) => workOf(e) && grouped(workOf(e)[key])]),
  ...[["time", data.usual], ["full trace", "FULL_TRACE"]].map(([title, setting]) =>
    [title, (e) => firstOf(e, setting) && ms(firstOf(e, setting).time.median)]),
  ["saves", (e) => percent(e.saving)], ["paper", (e) => percent(e.paperSaving)], ["cap", (e) => percent(e.cap)],
  ["saves without reflections", (e) => percent(savingOf(e, "EXACT"))],
  ["updated afterwards", (e) => percent(savingOf(e, "EXACT_UPDATED"))],
  ["× memory floor", (e) => Number.isFinite(workOf(e)?.timesFloor) ? `×\u202f${threeDigits(workOf(e).timesFloor)}` : "–"]);

const effectsTables = (scene) => [["Effects in use: cost of each", true], ["Absent effects: cost of each if it were computed", false]]
  .map(([caption, inUse]) => [caption, scene.effects.filter((effect) => effect.inUse === inUse)]).filter(([, effects]) => effects.length > 0)
  .map(([caption, effects]) => table("edits", caption, effects,
    ["effect", (e) => e.effect], ["first pass", (e) => ms(e.certainFirstMs)], ["noise", (e) => `± ${ms(e.noiseMs)}`],
    ["moved light", (e) => ms(e.certainUpdateMs)], ["cache", (e) => bytes(e.bytes)], ["rays", (e) => grouped(e.rays)],
    ["used by", (e) => e.callers.length > 1 ? `${e.callers[0]} and ${e.callers.length - 1} more` : e.callers[0] ?? ""]));

// The first pass of the paper on its own scene, of which it is 22.1 s to 18.6 s of the full trace (§4.1).
const PAPER_FIRST_PASS = { bird: 100 * 22.1 / 18.6 };

function savingsChart(scene) {
  const first = scene.firstPass && { name: "first pass", paper: PAPER_FIRST_PASS[scene.scene], ours: 100 + scene.firstPass.percentSlower };
  const edits = scene.edits.filter((e) => e.figure !== "").map((e) => ({ name: `${e.edit} (${e.figure})`, paper: 100 - e.paperSaving,
    ours: 100 - e.saving, stale: 100 - savingOf(e, "EXACT"), limit: 100 - e.cap }));
  return shareChart(`Time of each edit, compared with the paper, ${nameOf(scene)}`, first ? [first, ...edits] : edits);
}

function factsOf(scene) {
  const first = scene.firstPass;
  return `${scene.shapes} shapes, ${scene.lights} lights, reflection depth ${scene.depth}.${first ? ` The full trace takes ${
    ms(first.fullTrace.median)}, the first pass ${ms(first.time.median)}; its cache has ${bytes(first.bytes)}, ${
    threeDigits(first.bytesPerPixel)} bytes per pixel (paper: 250).` : ""}`;
}

const peerText = (peer) => `Full trace by ${peer.program}: ${ms(peer.time.median)}, by Lightning: ${ms(peer.fullTrace.median)}, ${
  threeDigits(peer.ratio)} times as fast. The images agree in ${percent(100 * peer.agreement)} of pixels (${peer.measure}).${
    peer.losses.length > 0 ? ` Not exactly converted: ${peer.losses.join("; ")}.` : ""}`;

const coldText = (cold) => `Cold start: a process of 'lightning render' takes ${ms(cold.process.median)}${
  cold.processor ? ` and ${ms(cold.processor.median)} of processor time` : ""}${cold.rival ? `; a process of ${cold.rival.program} takes ${
    ms(cold.rival.process.median)}, so Lightning takes ${percent(100 * cold.rival.share)} of its time` : ""}.`;

function editDetails(scene, edit, isOpen, id) {
  const paper = Number.isNaN(edit.paperSaving) ? "" : `, the paper ${percent(edit.paperSaving)}`;
  const headline = `${edit.figure && `${edit.figure} · `}saves ${percent(edit.saving)}${paper}`;
  const details = element("details", { className: "edit", id, open: isOpen },
    element("summary", {}, element("b", {}, edit.edit), ` ${headline}`));
  // Charts and pictures of all edits at once would take seconds.
  details.addEventListener("toggle", () => details.append(...wipe(scene, edit.values[0]), ...edit.values.map((value) =>
    element("div", { className: "value" },
      element("div", {}, errorChart(`Error against time of ${edit.edit}, ${value.value}`, value.rungs, 380, 240),
        element("p", { className: "axes" }, "RMSE against time, ms")),
      settingsTable("tight", value.value, value.rungs)))), { once: true });
  return details;
}

function sceneSection(scene, id) {
  const section = element("section", { id, className: "scene" }, element("h2", {}, nameOf(scene)),
    element("p", { className: "lead" }, factsOf(scene)));
  if (scene.edits.length > 0) {
    const summaries = summariesOf(scene);
    section.append(
      figures(figure("Savings compared with the paper",
        "Time of each edit in percent of the full trace: shorter is better. Edits with too noisy timing have no bar.", savingsChart(scene),
        [["paper", "paper (1998, its own scene)"], ["ours", `setting ${usual} (default)`],
          ["sky", `setting ${settingOf("EXACT").label}, reflections not updated`], ["text", "tick: limit from ray counts and memory"]]),
      figure("Accuracy and time",
        "Error (RMSE, maximum of all edits) against time (ms, median of all edits). Dashed: Pareto front; other settings are slower and less accurate.",
        errorChart(`Error against time of each accuracy setting, ${nameOf(scene)}`, summaries, chartWidth, 330))),
      settingsTable("", "Each accuracy setting over all edits: median time, worst error.", summaries, true),
      element("dl", { className: "settings" }, ...summaries.map(({ level }) => settingOf(level)).flatMap((setting) =>
        [element("dt", {}, setting.label), element("dd", {}, setting.description)])),
      editsTable(scene));
  }
  section.append(...effectsTables(scene), ...[scene.peer && peerText(scene.peer), scene.cold && coldText(scene.cold)].filter((text) => text)
    .map((text) => element("p", {}, text)), ...scene.edits.filter((edit) => edit.values.length > 0).map((edit, i) =>
      editDetails(scene, edit, i === 0, `${id}-edit-${i + 1}`)));
  return section;
}
results.scenes.forEach((scene, i) => byId("scenes").append(sceneSection(scene, `scene-${i + 1}`)));
