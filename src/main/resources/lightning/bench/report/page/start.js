// Head and foot: machine, settings, failures, key numbers, overview, and links to all sections.
const run = results.run;
const machine = run.machine;
const facts = (text, isNote) => byId("facts").append(element("p", { className: isNote ? "note" : "facts" }, text));

facts(`${run.date} · commit ${run.commit} · ${machine.system}, ${machine.processor}, ${machine.processors} processors, ${
  machine.vectorBits}-bit vectors, ${bytes(machine.memoryBytes)} · ${machine.java} · ${run.threads} threads · memory ${threeDigits(run.triadGBs)} GB/s`);
const load = `load average ${threeDigits(run.load.atStart)} before, ${threeDigits(run.load.atEnd)} at the end; other processes used ${
  percent(100 * run.load.others)} of the processor time`;
facts(data.busy ? `This machine was busy: ${load}. Its times are unreliable.` : load, data.busy);
if (run.quick) {
  facts("Quick run with few scenes, sizes and repetitions: a preview, not a measurement.", true);
}
if (!run.complete) {
  facts(`The run had not ended after ${threeDigits(run.actualSeconds)} s: it was canceled, or is still running. These are the results until then.`,
    true);
}
byId("samples").textContent = run.repetitions === 1 ? "one sample each, nothing warmed up: a preview, not a measurement."
  : `${run.repetitions} samples each, after a warm-up until times stop improving or its time limit ends.`;
byId("run").textContent = `Seed ${run.seed}, arguments: ${run.arguments.length > 0 ? run.arguments.join(" ") : "none"}. Predicted ${
  threeDigits(run.predictedSeconds)} s, took ${threeDigits(run.actualSeconds)} s. Every raw sample is in results.json.`;

fill("problems", results.problems.length > 0);
byId("problems").querySelector("ul").append(...results.problems.map((problem) =>
  element("li", {}, element("b", {}, problem.where), ` ${problem.what ?? ""}`)));

// Key numbers at the default setting: a mix of settings would be misleading, as no single setting has all of them.
const edits = pairs(results.scenes, "edits");
const isCertain = (edit) => Number.isFinite(edit.saving);
const certain = edits.filter(isCertain);
const uncertain = edits.length - certain.length;
const least = certain.reduce((a, b) => a && a.saving <= b.saving ? a : b, null);
const usualPoints = edits.flatMap((edit) => edit.values).flatMap((value) => pointOf(value, data.usual) || []);
const at = `at setting ${usual} (default)`;
fill("key", edits.length > 0, ...[
  [percent(median(certain.map((edit) => edit.saving))), `of a full trace saved by the median edit ${at}; the full trace is the fastest of this program${
    uncertain === 0 ? "" : `; ${uncertain} of ${edits.length} edits are left out because their timing is too noisy`}`],
  [percent(least ? least.saving : NaN), `saved ${at} by the edit that saves least${least ? `: ${least.edit} on ${nameOf(least.outer)}` : ""}`],
  [`${grouped(usualPoints.filter((point) => point.error.values === 0).length)} of ${grouped(usualPoints.length)}`,
    `images ${at} are bit-identical to the full trace`],
  [percent(median(results.scenes.flatMap((scene) => scene.firstPass?.percentSlower ?? []).filter(Number.isFinite))),
    "extra time of the median first pass over a full trace, to build the cache"],
].map(([number, meaning]) => element("div", {}, element("dt", {}, number), element("dd", {}, meaning))));

const ofFirst = (text) => (scene) => scene.firstPass ? text(scene.firstPass) : "–";
const ofSavings = (number) => (scene) => percent(number(scene.edits.filter(isCertain).map((edit) => edit.saving)));
const editCount = (n) => n === 0 ? "none" : Number.isFinite(n) ? `${grouped(n)} ${n === 1 ? "edit" : "edits"}` : "never";
const overviewCaption = "Medians. The first pass builds the cache for edits; the full trace has no cache.";
fill("overview", results.scenes.length > 0, table("", overviewCaption, results.scenes,
  ["scene", (s) => s.scene], ["pixels", (s) => `${s.width} × ${s.height}`], ["lights", (s) => String(s.lights)],
  ["shapes", (s) => String(s.shapes)], ["full trace", ofFirst((f) => ms(f.fullTrace.median))],
  ["first pass", ofFirst((f) => ms(f.time.median))], ["slower by", ofFirst((f) => percent(f.percentSlower))],
  ["bytes per pixel", ofFirst((f) => threeDigits(f.bytesPerPixel))], ["edits to break even", ofFirst((f) => editCount(f.editsToPayOff))],
  ["median saving", ofSavings(median)], ["min.", ofSavings((all) => range(all, NaN)[0])], ["max.", ofSavings((all) => range(all, NaN, NaN)[1])]));

document.querySelector("nav").append(...[...document.querySelectorAll("section:not([hidden])")].map((section) =>
  element("a", { href: `#${section.id}` }, section.querySelector("h2").textContent)));
document.body.dataset.ready = "yes";
