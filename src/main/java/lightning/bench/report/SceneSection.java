package lightning.bench.report;

import java.util.ArrayList;
import java.util.List;
import lightning.bench.result.ColdStart;
import lightning.bench.result.EditResult;
import lightning.bench.result.FirstPassResult;
import lightning.bench.result.PeerResult;
import lightning.bench.result.SceneResult;
import lightning.render.measure.AccuracySetting;

/** Report section of one scene at one size. */
final class SceneSection {
    /** First pass and full trace of the paper on its scene of four spheres, two cones, four cylinders and a plane, seconds (§4.1). */
    private static final double PAPER_FIRST_PASS = 100 * 22.1 / 18.6;
    private static final String PAPER_SCENE = "bird";

    private SceneSection() {}

    static String title(SceneResult scene) {
        return scene.scene() + ", " + scene.width() + " × " + scene.height();
    }

    static void write(HtmlWriter page, String id, SceneResult scene, EmbeddedPictures pictures) {
        page.open("section", "id", id, "class", "scene");
        page.element("h2", title(scene));
        summary(page, scene);
        List<AccuracySummary> summaries = AccuracySummary.of(scene);
        if (!scene.edits().isEmpty()) {
            page.open("div", "class", "charts").open("div");
            shares(page, scene);
            page.close().open("div");
            accuracy(page, summaries);
            page.close().close();
            AccuracySummary.table(page, summaries);
            EditTable.write(page, scene);
        }
        EffectTable.write(page, scene);
        if (scene.peer() != null) {
            peer(page, scene.peer());
        }
        if (scene.cold() != null) {
            cold(page, scene.cold());
        }
        EditPictureSection.write(page, id, scene, pictures);
        page.close();
    }

    private static void summary(HtmlWriter page, SceneResult scene) {
        FirstPassResult first = scene.firstPass();
        String facts = scene.shapes() + " shapes, " + scene.lights() + " lights, reflection depth " + scene.depth() + ".";
        page.element("p", first == null ? facts : facts + " The full trace takes " + NumberText.ms(first.fullTrace().median())
                + ", the first pass " + NumberText.ms(first.time().median()) + "; its cache has " + NumberText.bytes(first.bytes()) + ", "
                + NumberText.threeDigits(first.bytesPerPixel()) + " bytes per pixel (paper: 250).", "class", "lead");
    }

    private static void shares(HtmlWriter page, SceneResult scene) {
        figure(page, "Savings compared with the paper",
                "Time of each edit in percent of the full trace: shorter is better. Edits with too noisy timing "
                        + "have no bar.",
                shares(scene),
                PlotColor.PAPER, "paper (1998, its own scene)", PlotColor.OURS,
                "setting " + AccuracySetting.DEFAULT.label() + " (default)", PlotColor.SKY,
                "setting " + AccuracySetting.EXACT.label() + ", reflections not updated", PlotColor.TEXT,
                "tick: limit from ray counts and memory");
    }

    /** Returns the chart of the paper's edits. */
    static String shares(SceneResult scene) {
        List<ShareChart.Bar> bars = new ArrayList<>();
        if (scene.firstPass() != null) {
            bars.add(new ShareChart.Bar("first pass", scene.scene().equals(PAPER_SCENE) ? PAPER_FIRST_PASS : Double.NaN,
                    100 + scene.firstPass().percentSlower(), Double.NaN, Double.NaN));
        }
        for (EditResult edit : scene.edits()) {
            if (!edit.figure().isEmpty()) {
                bars.add(new ShareChart.Bar(edit.edit() + " (" + edit.figure() + ")", 100 - edit.paperSaving(), 100 - edit.saving(),
                        100 - edit.saving(AccuracySetting.EXACT), 100 - edit.cap()));
            }
        }
        return ShareChart.svg("Time of each edit, compared with the paper", bars);
    }

    private static void accuracy(HtmlWriter page, List<AccuracySummary> summaries) {
        figure(page, "Accuracy and time", "Error (RMSE, maximum of all edits) against time (ms, median of all edits). "
                + "Dashed: Pareto front; other settings are slower and less accurate.",
                accuracy(summaries));
    }

    /** Returns the chart of error against time. */
    static String accuracy(List<AccuracySummary> summaries) {
        return AccuracyChart.svg("Error against time of each accuracy setting", summaries.stream().map(AccuracySummary::point).toList(),
                550, 330);
    }

    private static void peer(HtmlWriter page, PeerResult peer) {
        page.element("p",
                "Full trace by " + peer.program() + ": " + NumberText.ms(peer.time().median()) + ", by Lightning: "
                        + NumberText.ms(peer.fullTrace().median()) + ", " + NumberText.threeDigits(peer.ratio())
                        + " times as fast. The images agree in "
                        + NumberText.percent(100 * peer.agreement()) + " of pixels (" + peer.measure() + ")."
                        + (peer.losses().isEmpty() ? "" : " Not exactly converted: " + String.join("; ", peer.losses()) + "."),
                "class", "peer");
    }

    private static void cold(HtmlWriter page, ColdStart cold) {
        String ours = "Cold start: a process of 'lightning render' takes " + NumberText.ms(cold.process().median())
                + (cold.processor() == null ? "" : " and " + NumberText.ms(cold.processor().median()) + " of processor time");
        page.element("p", ours + (cold.rival() == null ? "." : "; a process of " + cold.rival().program() + " takes "
                + NumberText.ms(cold.rival().process().median()) + ", so Lightning takes " + NumberText.percent(100 * cold.rival().share())
                + " of its time."), "class", "peer");
    }

    /** Writes a chart with title, axis description, and legend. */
    static void figure(HtmlWriter page, String title, String axes, String chart, Object... legend) {
        page.open("figure").open("figcaption");
        page.element("h3", title).element("p", axes);
        if (legend.length > 0) {
            page.open("ul", "class", "legend");
            for (int i = 0; i < legend.length; i += 2) {
                page.open("li").element("i", "", "style", "background:" + ((PlotColor) legend[i]).variable()).text((String) legend[i + 1])
                        .close();
            }
            page.close();
        }
        page.close().raw(chart).close();
    }
}
