package lightning.bench.report;

import lightning.bench.result.BenchResults;
import lightning.bench.result.IndirectAbsence;
import lightning.bench.result.IndirectCost;
import lightning.bench.result.IndirectResults;

/** Report section of indirect light. */
final class IndirectSection {
    private IndirectSection() {}

    static void write(HtmlWriter page, BenchResults results) {
        IndirectResults indirect = results.indirect();
        if (indirect.hasNone()) {
            return;
        }
        page.open("section", "id", "indirect");
        page.element("h2", "Indirect light");
        page.element("p", "Errors are relative, at random pixels, against brute force by the same tracer. Labels are spacing and rays; "
                + "the default is filled, and the dashed line is the Pareto front.", "class", "lead");
        page.open("div", "class", "charts");
        indirect.accuracy().forEach(scene -> SceneSection.figure(page, scene.scene(),
                "Mean error against the time of the first pass (ms).", IndirectCharts.svg(scene)));
        indirect.reflections().stream().filter(scene -> !scene.points().isEmpty()).forEach(scene -> SceneSection.figure(page,
                scene.scene() + ", blurred reflections", "Mean error against the time of the first pass (ms); labels are rays.",
                IndirectCharts.svg(scene)));
        indirect.softShadows().forEach(scene -> SceneSection.figure(page, scene.scene() + ", area lights",
                "Mean error against the time of the first pass (ms); labels are samples.", IndirectCharts.svg(scene)));
        if (!indirect.accuracy().isEmpty()) {
            SceneSection.figure(page, "Bounces", "Share of the light of eight bounces that is missing, against bounces.",
                    IndirectCharts.bounces(indirect));
        }
        indirect.growth().forEach(growth -> SceneSection.figure(page, "Growth with " + growth.along(),
                "Time (ms) against " + growth.along() + "; " + growth.scene() + ".", IndirectCharts.svg(growth)));
        page.close();
        try (HtmlTable table = new HtmlTable(page, "edits", "Updates after one edit", "scene, edit", "update", "without indirect light",
                "first pass")) {
            for (IndirectCost scene : indirect.costs()) {
                scene.edits().forEach(edit -> table.row(scene.scene() + ", " + edit.edit(), NumberText.ms(edit.time().median()),
                        NumberText.ms(edit.without().median()), NumberText.ms(scene.first().median())));
            }
        }
        try (HtmlTable table = new HtmlTable(page, "edits", "Scenes without indirect light", "scene", "bytes", "rays", "first pass",
                "with hidden indirect light")) {
            for (IndirectAbsence scene : indirect.absence()) {
                table.row(scene.scene(), Long.toString(scene.bytes()), Long.toString(scene.rays()),
                        NumberText.ms(scene.absent().median()), NumberText.ms(scene.hidden().median()));
            }
        }
        page.close();
    }
}
