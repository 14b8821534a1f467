package lightning.bench.report;

import lightning.bench.result.BenchResults;
import lightning.bench.result.BenchRun;
import lightning.bench.result.FirstPassResult;
import lightning.bench.result.MachineSpec;
import lightning.bench.result.SceneResult;
import lightning.bench.result.SystemLoad;

/** Head and foot of the report: machine and settings, failures, overview of all scenes, and method. */
final class RunSection {
    private RunSection() {}

    static void write(HtmlWriter page, String title, BenchResults results) {
        page.open("header");
        page.element("h1", title);
        facts(page, results.run());
        links(page, results);
        page.close();
        problems(page, results);
        KeyNumbers.write(page, results);
        if (!results.scenes().isEmpty()) {
            overview(page, results);
        }
    }

    private static void facts(HtmlWriter page, BenchRun run) {
        MachineSpec machine = run.machine();
        page.element("p",
                run.date() + " · commit " + run.commit() + " · " + machine.system() + ", " + machine.processor() + ", "
                        + machine.processors()
                        + " processors, " + machine.vectorBits() + "-bit vectors, " + NumberText.bytes(machine.memoryBytes()) + " · "
                        + machine.java() + " · " + run.threads() + " threads · memory " + NumberText.threeDigits(run.triadGBs()) + " GB/s",
                "class",
                "facts");
        page.element("p", load(run), "class", run.load().isBusy(machine.processors()) ? "note" : "facts");
        if (run.quick()) {
            page.element("p", "Quick run with few scenes, sizes and repetitions: a preview, not a measurement.", "class", "note");
        }
        if (!run.complete()) {
            page.element("p", "The run had not ended after " + NumberText.threeDigits(run.actualSeconds())
                    + " s: it was canceled, or is still running. These are the results until then.", "class", "note");
        }
    }

    /** Returns a sentence about other work during the run. */
    private static String load(BenchRun run) {
        SystemLoad load = run.load();
        String facts =
                "load average " + NumberText.threeDigits(load.atStart()) + " before, " + NumberText.threeDigits(load.atEnd())
                        + " at the end; other processes used "
                        + NumberText.percent(100 * load.others()) + " of the processor time";
        return load.isBusy(run.machine().processors()) ? "This machine was busy: " + facts + ". Its times are unreliable." : facts;
    }

    private static void links(HtmlWriter page, BenchResults results) {
        page.open("nav");
        for (int i = 0; i < results.scenes().size(); i++) {
            SceneResult scene = results.scenes().get(i);
            page.element("a", SceneSection.title(scene), "href", "#scene-" + (i + 1));
        }
        if (!results.drift().isEmpty()) {
            page.element("a", "Drift", "href", "#drift");
        }
        if (!results.growth().isEmpty()) {
            page.element("a", "Growth", "href", "#growth");
        }
        if (!results.editing().isEmpty()) {
            page.element("a", "Editing", "href", "#editing");
        }
        if (!results.meshes().isEmpty()) {
            page.element("a", "Meshes", "href", "#meshes");
        }
        page.element("a", "Method", "href", "#method");
        page.close();
    }

    private static void problems(HtmlWriter page, BenchResults results) {
        if (results.problems().isEmpty()) {
            return;
        }
        page.open("section", "class", "problems", "id", "problems");
        page.element("h2", "Failed measurements");
        page.open("ul");
        results.problems().forEach(problem -> page.open("li").element("b", problem.where()).text(" " + problem.what()).close());
        page.close().close();
    }

    private static void overview(HtmlWriter page, BenchResults results) {
        page.open("section", "id", "glance");
        page.element("h2", "Overview of all scenes");
        try (HtmlTable table =
                new HtmlTable(page, null, "Medians. The first pass builds the cache for edits; the full trace has no cache.", "scene",
                        "pixels", "lights", "shapes", "full trace", "first pass", "slower by", "bytes per pixel", "edits to break even",
                        "median saving", "min.", "max.")) {
            for (SceneResult scene : results.scenes()) {
                FirstPassResult first = scene.firstPass();
                double[] savings = scene.edits().stream().mapToDouble(e -> e.saving()).filter(Double::isFinite).sorted().toArray();
                int n = savings.length;
                table.row(scene.scene(), scene.width() + " × " + scene.height(), "" + scene.lights(), "" + scene.shapes(),
                        first == null ? "–" : NumberText.ms(first.fullTrace().median()),
                        first == null ? "–" : NumberText.ms(first.time().median()),
                        first == null ? "–" : NumberText.percent(first.percentSlower()),
                        first == null ? "–" : NumberText.threeDigits(first.bytesPerPixel()),
                        first == null ? "–" : edits(first.editsToPayOff()), n == 0 ? "–" : NumberText.percent(savings[n / 2]),
                        n == 0 ? "–" : NumberText.percent(savings[0]), n == 0 ? "–" : NumberText.percent(savings[n - 1]));
            }
        }
        page.close();
    }

    private static String edits(double count) {
        return count == 0 ? "none" : Double.isFinite(count) ? NumberText.grouped(Math.round(count)) + (count == 1 ? " edit" : " edits")
                : "never";
    }

    private static String samples(BenchRun run) {
        return run.repetitions() == 1 ? "one sample each, nothing warmed up: a preview, not a measurement."
                : run.repetitions() + " samples each, after a warm-up until times stop improving or its time limit ends.";
    }

    static void writeMethod(HtmlWriter page, BenchRun run) {
        page.open("section", "id", "method");
        page.element("h2", "Method");
        page.element("p", "All accuracy settings of an edit and the full trace run in turns, so that a temporary slowdown of the "
                + "machine affects all of them; " + samples(run)
                + " Times are medians, whiskers quartiles. A setting is timed only after its image was compared with a "
                + "full trace. If the quartiles of an edit and of the full trace overlap, or fewer than three samples exist, no "
                + "saving is given. A saving is relative to the time of the traditional full trace, the fastest that "
                + "the program has, without a cache. The paper's savings are of its own scene on a computer of 1998.");
        page.element("p", "The cap is the saving of an edit if it cast its rays as fast as the full trace does and moved its "
                + "bytes at memory speed. The floor is the time of those bytes at the bandwidth measured in this run. Errors "
                + "are relative to the full trace: RMSE and maximum difference of linear values, ulp in floats between two "
                + "values, PSNR, SSIM and ꟻLIP of the displayed image (ꟻLIP at 67 pixels per degree; 0 is no visible "
                + "difference, 1 the worst).");
        page.element("p", "Seed " + run.seed() + ", arguments: " + (run.arguments().isEmpty() ? "none" : String.join(" ", run.arguments()))
                + ". Predicted " + NumberText.threeDigits(run.predictedSeconds()) + " s, took "
                + NumberText.threeDigits(run.actualSeconds())
                + " s. Every raw sample is in results.json.");
        page.close();
    }
}
