package lightning.bench.report;

import java.util.Optional;
import lightning.bench.result.EditResult;
import lightning.bench.result.SceneResult;
import lightning.bench.result.SweepPointResult;
import lightning.bench.result.UpdateWork;
import lightning.render.measure.AccuracySetting;

/** Table of a scene's edits: work, saving, and its limits. */
final class EditTable {
    private EditTable() {}

    static void write(HtmlWriter page, SceneResult scene) {
        try (HtmlTable table = new HtmlTable(page, "plans",
                "Each edit at setting " + AccuracySetting.DEFAULT.label() + ": work of its first value, savings averaged over all values.",
                "edit", "plan", "rows touched", "shadow rays", "avoided", "time", "full trace", "saves", "paper", "cap",
                "saves without reflections", "updated afterwards", "× memory floor")) {
            scene.edits().forEach(edit -> row(table, edit));
        }
    }

    private static void row(HtmlTable table, EditResult edit) {
        Optional<SweepPointResult> point = edit.first(AccuracySetting.DEFAULT);
        Optional<UpdateWork> work = point.map(SweepPointResult::work);
        table.row(edit.edit(), work.map(UpdateWork::plan).orElse("–"), work.map(w -> NumberText.grouped(w.rowsTouched())).orElse("–"),
                work.map(w -> NumberText.grouped(w.shadowRays())).orElse("–"),
                work.map(w -> NumberText.grouped(w.shadowRaysAvoided())).orElse("–"),
                point.map(r -> NumberText.ms(r.time().median())).orElse("–"),
                edit.first(AccuracySetting.FULL_TRACE).map(r -> NumberText.ms(r.time().median())).orElse("–"),
                NumberText.percent(edit.saving()), NumberText.percent(edit.paperSaving()), NumberText.percent(edit.cap()),
                NumberText.percent(edit.saving(AccuracySetting.EXACT)),
                NumberText.percent(edit.saving(AccuracySetting.EXACT_UPDATED)),
                work.filter(w -> !Double.isNaN(w.timesFloor())).map(w -> "×\u202f" + NumberText.threeDigits(w.timesFloor())).orElse("–"));
    }
}
