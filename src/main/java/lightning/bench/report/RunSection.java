package lightning.bench.report;

import lightning.bench.BenchResults;
import lightning.bench.BenchRun;
import lightning.bench.FirstPassResult;
import lightning.bench.MachineSpec;
import lightning.bench.SceneResult;
import lightning.bench.SystemLoad;

/** The head of the report: what ran where, what went wrong, all scenes at a glance; and its foot: how it was measured. */
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
            page.element("p", "A quick run: few scenes, sizes and repetitions. Its numbers show the way, no more.", "class", "note");
        }
        if (!run.complete()) {
            page.element("p", "The run had not ended after " + NumberText.threeDigits(run.actualSeconds())
                    + " s: it was canceled then, or is still at work. Below is what had been measured.", "class", "note");
        }
    }

    /** What other work did to the run. */
    private static String load(BenchRun run) {
        SystemLoad load = run.load();
        String facts =
                "load average " + NumberText.threeDigits(load.atStart()) + " before, " + NumberText.threeDigits(load.atEnd())
                        + " at the end; other work had "
                        + NumberText.percent(100 * load.others()) + " of the processors' time";
        return load.isBusy(run.machine().processors()) ? "This machine was busy: " + facts + ". Its times say little." : facts;
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
        page.element("a", "How it was measured", "href", "#method");
        page.close();
    }

    private static void problems(HtmlWriter page, BenchResults results) {
        if (results.problems().isEmpty()) {
            return;
        }
        page.open("section", "class", "problems", "id", "problems");
        page.element("h2", "What could not be measured");
        page.open("ul");
        results.problems().forEach(problem -> page.open("li").element("b", problem.where()).text(" " + problem.what()).close());
        page.close().close();
    }

    private static void overview(HtmlWriter page, BenchResults results) {
        page.open("section", "id", "glance");
        page.element("h2", "All scenes at a glance");
        try (HtmlTable table =
                new HtmlTable(page, null, "Medians. The first pass keeps what edits need; the full trace keeps nothing.", "scene",
                        "pixels", "lights", "shapes", "full trace", "first pass", "slower by", "bytes a pixel", "edits to break even",
                        "edits save, median", "least", "most")) {
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
        return count == 0 ? "at once" : Double.isFinite(count) ? NumberText.grouped(Math.round(count)) + (count == 1 ? " edit" : " edits")
                : "never";
    }

    private static String samples(BenchRun run) {
        return run.repetitions() == 1 ? "one sample each and nothing warmed up: a look, and no measurement."
                : run.repetitions() + " samples each, after warming up until no work becomes faster, or patience ends.";
    }

    static void writeMethod(HtmlWriter page, BenchRun run) {
        page.open("section", "id", "method");
        page.element("h2", "How it was measured");
        page.element("p", "Each edit's grades of accuracy and the full trace run in turns, again and again, so that whatever slows the "
                + "machine for a while slows all of them; " + samples(run)
                + " Times are medians, whiskers quartiles. No grade is timed before its picture was compared with a "
                + "trace from nothing. Where the quartiles of an edit and of the full trace overlap, or there are fewer than three samples, no "
                + "saving is given. A saving is what an edit spares of the time of the traditional full trace, the fastest that "
                + "the program can make, which keeps nothing; the paper's are of its own scene on a computer of 1998.");
        page.element("p", "The cap is what an edit could save if it cast its rays as fast as the full trace casts its own and moved its "
                + "bytes at the speed of memory; the floor is the time of those bytes at the bandwidth measured in this run. Errors "
                + "are taken against the full trace: RMSE and the largest difference of linear values, ulp in floats between two "
                + "values, PSNR, SSIM and ꟻLIP of the picture as displayed (ꟻLIP at 67 pixels per degree; 0 is no visible "
                + "difference, 1 the worst).");
        page.element("p", "Seed " + run.seed() + ", arguments: " + (run.arguments().isEmpty() ? "none" : String.join(" ", run.arguments()))
                + ". Predicted " + NumberText.threeDigits(run.predictedSeconds()) + " s, took "
                + NumberText.threeDigits(run.actualSeconds())
                + " s. Every raw sample is in results.json.");
        page.close();
    }
}
