package lightning.bench.report;

import java.util.Optional;
import lightning.bench.EditResult;
import lightning.bench.RungResult;
import lightning.bench.SceneResult;
import lightning.bench.Work;
import lightning.bench.accuracy.Grade;

/** The table of a scene's edits: what each did, what it saved, and why not more. */
final class EditTable {
    private EditTable() {}

    static void write(Markup page, SceneResult scene) {
        try (Table table = new Table(page, "plans",
                "Each edit at grade " + Grade.DEFAULT.label() + ": work of its first value, savings averaged over all values.",
                "edit", "plan", "rows touched", "shadow rays", "avoided", "time", "full trace", "saves", "paper", "cap",
                "saves with mirrors as they were", "updated afterwards", "above floor")) {
            scene.edits().forEach(edit -> row(table, edit));
        }
    }

    private static void row(Table table, EditResult edit) {
        Optional<RungResult> shown = edit.first(Grade.DEFAULT);
        Optional<Work> work = shown.map(RungResult::work);
        table.row(edit.edit(), work.map(Work::plan).orElse("–"), work.map(w -> Numbers.grouped(w.rowsTouched())).orElse("–"),
                work.map(w -> Numbers.grouped(w.shadowRays())).orElse("–"),
                work.map(w -> Numbers.grouped(w.shadowRaysAvoided())).orElse("–"),
                shown.map(r -> Numbers.ms(r.time().median())).orElse("–"),
                edit.first(Grade.FULL_TRACE).map(r -> Numbers.ms(r.time().median())).orElse("–"),
                Numbers.percent(edit.saving()), Numbers.percent(edit.paperSaving()), Numbers.percent(edit.cap()),
                Numbers.percent(edit.saving(Grade.EXACT)),
                Numbers.percent(edit.saving(Grade.EXACT_UPDATED)),
                work.filter(w -> !Double.isNaN(w.timesFloor())).map(w -> "×\u202f" + Numbers.plain(w.timesFloor())).orElse("–"));
    }
}
