package lightning.bench.report;

import java.util.ArrayList;
import java.util.List;
import lightning.bench.Cold;
import lightning.bench.EditResult;
import lightning.bench.FirstPass;
import lightning.bench.Peer;
import lightning.bench.SceneResult;
import lightning.bench.accuracy.Grade;

/** All that was measured on one scene at one size. */
final class SceneSection {
    /** The paper's first pass and full trace on its scene of four spheres, two cones, four cylinders and a plane, seconds (§4.1). */
    private static final double PAPER_FIRST_PASS = 100 * 22.1 / 18.6;
    private static final String PAPER_SCENE = "bird";

    private SceneSection() {}

    static String title(SceneResult scene) {
        return scene.scene() + ", " + scene.width() + " × " + scene.height();
    }

    static void write(Markup page, String id, SceneResult scene, PictureBook book) {
        page.open("section", "id", id, "class", "scene");
        page.leaf("h2", title(scene));
        lead(page, scene);
        List<GradeSummary> grades = GradeSummary.of(scene);
        if (!scene.edits().isEmpty()) {
            page.open("div", "class", "charts").open("div");
            shares(page, scene);
            page.close().open("div");
            ladder(page, grades);
            floors(page, scene);
            page.close().close();
            GradeSummary.table(page, grades);
            EditTable.write(page, scene);
        }
        EffectTable.write(page, scene);
        if (scene.peer() != null) {
            peer(page, scene.peer());
        }
        if (scene.cold() != null) {
            cold(page, scene.cold());
        }
        EditPictures.write(page, id, scene, book);
        page.close();
    }

    private static void lead(Markup page, SceneResult scene) {
        FirstPass first = scene.firstPass();
        String facts = scene.shapes() + " shapes, " + scene.lights() + " lights, mirrors to depth " + scene.depth() + ".";
        page.leaf("p", first == null ? facts : facts + " The full trace takes " + Numbers.ms(first.fullTrace().median())
                + ", the first pass " + Numbers.ms(first.time().median()) + "; it keeps " + Numbers.bytes(first.bytes()) + ", "
                + Numbers.plain(first.bytesPerPixel()) + " bytes a pixel (the paper: 250).", "class", "lead");
    }

    private static void shares(Markup page, SceneResult scene) {
        figure(page, "The paper's figures, redrawn",
                "Time of each edit in percent of the full trace's: shorter is better. Where times scatter too much to "
                        + "say, there is no bar.",
                shares(scene),
                Ink.PAPER, "the paper, 1998, on its own scene", Ink.OURS, "grade " + Grade.DEFAULT.label() + ", the default", Ink.SKY,
                "grade " + Grade.EXACT.label() + ", mirrors as they were", Ink.TEXT, "tick: least that ray counts and memory allow");
    }

    /** The chart of the paper's edits. */
    static String shares(SceneResult scene) {
        List<ShareChart.Bar> bars = new ArrayList<>();
        if (scene.firstPass() != null) {
            bars.add(new ShareChart.Bar("first pass", scene.scene().equals(PAPER_SCENE) ? PAPER_FIRST_PASS : Double.NaN,
                    100 + scene.firstPass().percentSlower(), Double.NaN, Double.NaN));
        }
        for (EditResult edit : scene.edits()) {
            if (!edit.figure().isEmpty()) {
                bars.add(new ShareChart.Bar(edit.edit() + " (" + edit.figure() + ")", 100 - edit.paperSaving(), 100 - edit.saving(),
                        100 - edit.saving(Grade.EXACT), 100 - edit.cap()));
            }
        }
        return ShareChart.svg("Time of each edit beside the paper's", bars);
    }

    private static void ladder(Markup page, List<GradeSummary> grades) {
        figure(page, "What accuracy costs", "Error (RMSE, the largest of all edits) against time (ms, median of all edits). "
                + "Dashed: the front of Pareto; a grade off it is beaten in both.",
                ladder(grades));
    }

    /** The chart of error against time. */
    static String ladder(List<GradeSummary> grades) {
        return LadderChart.svg("Error against time of each grade of accuracy", grades.stream().map(GradeSummary::point).toList(), 550, 330);
    }

    private static void floors(Markup page, SceneResult scene) {
        List<FloorChart.Row> rows = new ArrayList<>();
        for (EditResult edit : scene.edits()) {
            edit.first(Grade.DEFAULT).filter(rung -> rung.work() != null).ifPresent(rung -> {
                if (Charts.plausible(rung.work().floorMs()) && Charts.plausible(rung.time().median())) {
                    rows.add(new FloorChart.Row(edit.edit(), rung.work().floorMs(), rung.time().median()));
                }
            });
        }
        if (!rows.isEmpty()) {
            figure(page, "How far above the floor",
                    "Time of each edit (ms, grade " + Grade.DEFAULT.label() + ") beside the time that memory needs to move its bytes.",
                    FloorChart.svg("Time of each edit beside its memory floor", rows),
                    Ink.OURS, "measured, and how many times the floor", Ink.TEXT, "tick: the floor");
        }
    }

    private static void peer(Markup page, Peer peer) {
        page.leaf("p", "The same picture by " + peer.program() + ": " + Numbers.ms(peer.time().median()) + " against our full trace of "
                + Numbers.ms(peer.fullTrace().median()) + ", " + Numbers.plain(peer.ratio()) + " times as fast. The pictures agree in "
                + Numbers.percent(100 * peer.agreement()) + " of pixels (" + peer.measure() + ")."
                + (peer.losses().isEmpty() ? "" : " It cannot say exactly: " + String.join("; ", peer.losses()) + "."), "class", "peer");
    }

    private static void cold(Markup page, Cold cold) {
        String ours = "From cold: a whole process of 'lightning render' takes " + Numbers.ms(cold.process().median())
                + (cold.processor() == null ? "" : " and " + Numbers.ms(cold.processor().median()) + " of processor time");
        page.leaf("p", ours + (cold.rival() == null ? "." : "; that of " + cold.rival().program() + " takes "
                + Numbers.ms(cold.rival().process().median()) + ", so ours takes " + Numbers.percent(100 * cold.rival().share())
                + " of its time."), "class", "peer");
    }

    /** A chart with a title, a line that says what its axes are, and a legend of inks and their meanings. */
    static void figure(Markup page, String title, String axes, String chart, Object... legend) {
        page.open("figure").open("figcaption");
        page.leaf("h3", title).leaf("p", axes);
        if (legend.length > 0) {
            page.open("ul", "class", "legend");
            for (int i = 0; i < legend.length; i += 2) {
                page.open("li").leaf("i", "", "style", "background:" + ((Ink) legend[i]).variable()).text((String) legend[i + 1]).close();
            }
            page.close();
        }
        page.close().ready(chart).close();
    }
}
