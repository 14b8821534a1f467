package lightning.bench.report;

import java.util.Optional;
import lightning.accuracy.Grade;
import lightning.bench.EditResult;
import lightning.bench.RungResult;
import lightning.bench.SceneResult;
import lightning.bench.Work;

/** The table of a scene's edits: what each did, what it saved, and why not more. */
final class EditTable {
    private EditTable() {}

    static void write(Markup page, SceneResult scene) {
        try (Table table = new Table(page, "plans", "Each edit at grade exact: work of its first value, savings averaged over all values.",
                "edit", "plan", "rows touched", "shadow rays", "avoided", "time", "full trace", "saves", "paper", "cap",
                "saves with mirrors updated", "kept current", "above floor")) {
            scene.edits().forEach(edit -> row(table, edit));
        }
    }

    private static void row(Table table, EditResult edit) {
        Optional<RungResult> exact = GradeSummary.first(edit, Grade.EXACT);
        Optional<Work> work = exact.map(RungResult::work);
        table.row(edit.edit(), work.map(Work::plan).orElse("–"), work.map(w -> Numbers.grouped(w.rowsTouched())).orElse("–"),
                work.map(w -> Numbers.grouped(w.shadowRays())).orElse("–"),
                work.map(w -> Numbers.grouped(w.shadowRaysAvoided())).orElse("–"),
                exact.map(r -> Numbers.ms(r.time().median())).orElse("–"),
                GradeSummary.first(edit, Grade.FULL_TRACE).map(r -> Numbers.ms(r.time().median())).orElse("–"),
                Numbers.percent(edit.saving()), Numbers.percent(edit.paperSaving()), Numbers.percent(edit.cap()),
                Numbers.percent(GradeSummary.saving(edit, Grade.EXACT_UPDATED)),
                Numbers.percent(GradeSummary.saving(edit, Grade.EXACT_CURRENT)),
                work.filter(w -> !Double.isNaN(w.timesFloor())).map(w -> "×\u202f" + Numbers.plain(w.timesFloor())).orElse("–"));
    }
}
