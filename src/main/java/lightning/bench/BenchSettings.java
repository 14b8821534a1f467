package lightning.bench;

import io.soabase.recordbuilder.core.RecordBuilder;
import java.util.List;
import lightning.scene.paper.PaperCase;
import lightning.scene.paper.PaperCases;

/**
 * Selection and precision of a benchmark run.
 *
 * @param sizes       image sizes of each scene; images of the first are written
 * @param figure      paper's figure whose edits are measured; 0 for all edits
 * @param values      number of values of each edit, 0 (no edits) to {@link PaperCases#VALUES}
 * @param further     whether to measure edits that are not in the paper
 * @param repetitions number of samples of each task, ≥ 1; 1 is a preview without warm-up
 * @param patienceMs  maximum warm-up of a group of tasks, milliseconds
 * @param threads     number of threads of each task, ≥ 1
 * @param seed        random seed
 * @param curves      whether to measure growth and drift
 * @param editing     whether to measure editing of large scenes
 * @param meshes      whether to measure ray throughput on meshes
 * @param modern      whether to measure the modern set: anti-aliasing, first pass, edits, cold starts, and time against error
 * @param indirect    whether to measure indirect light: time against error, edits, growth, and the cost if absent
 * @param effects     whether to measure the cost of each effect, at the last size
 * @param peers       whether to measure other installed programs
 * @param processes   number of cold-start processes per image, 0 for none
 * @param quick       whether it is the small selection
 */
@RecordBuilder
public record BenchSettings(List<PictureSize> sizes, int figure, int values, boolean further, int repetitions, double patienceMs,
        int threads,
        long seed, boolean curves, boolean editing, boolean meshes, boolean modern, boolean indirect, boolean effects, boolean peers,
        int processes,
        boolean quick)
        implements BenchSettingsBuilder.With {
    /** Size of the paper's images (§4.1), and a current one. */
    private static final List<PictureSize> FULL_SIZES = List.of(new PictureSize(300, 300), new PictureSize(1920, 1080));
    private static final int PROCESSES = 10;
    private static final List<PictureSize> QUICK_SIZES = List.of(new PictureSize(640, 480));

    public BenchSettings {
        sizes = List.copyOf(sizes);
        patienceMs = repetitions > 1 ? patienceMs : 0;
    }

    /** Returns the full selection. */
    public static BenchSettings full(int threads, long seed) {
        return new BenchSettings(FULL_SIZES, 0, PaperCases.VALUES, true, 5, 300, threads, seed, true, true, true, false, false, true, true,
                PROCESSES,
                false);
    }

    /** Returns a selection for a minute or two: one size and one value, the printed edits, short curves, no other programs. */
    public static BenchSettings quick(int threads, long seed) {
        return new BenchSettings(QUICK_SIZES, 0, 1, false, 3, 0, threads, seed, true, true, true, false, false, false, false, 0, true);
    }

    /** Returns a selection for edits and curves only: no effects, no cold-start processes. */
    public BenchSettings editsAndCurves() {
        return with(s -> s.editing(false).meshes(false).effects(false).processes(0));
    }

    /** Returns a selection of one figure's edits, without curves. */
    @Override
    public BenchSettings withFigure(int v) {
        return editsAndCurves().with(s -> s.figure(v).further(false).curves(false));
    }

    /** Returns a selection of effect costs and the first pass only. */
    public BenchSettings effectsOnly() {
        return firstPassOnly().withEffects(true);
    }

    /** Returns a selection of cold-start processes and the first pass only. */
    public BenchSettings coldStartOnly() {
        return firstPassOnly().withProcesses(PROCESSES);
    }

    /** Returns a selection of editing of large scenes only. */
    public BenchSettings editingOnly() {
        return firstPassOnly().with(s -> s.sizes(List.of()).editing(true));
    }

    /** Returns a selection of ray throughput on meshes only. */
    public BenchSettings meshesOnly() {
        return firstPassOnly().with(s -> s.sizes(List.of()).meshes(true).peers(peers));
    }

    /** Returns a selection of the modern set only. */
    public BenchSettings modernOnly() {
        return firstPassOnly().with(s -> s.sizes(List.of()).modern(true).processes(PROCESSES));
    }

    /** Returns a selection of indirect light only. */
    public BenchSettings indirectOnly() {
        return firstPassOnly().with(s -> s.sizes(List.of()).indirect(true));
    }

    private BenchSettings firstPassOnly() {
        return withFigure(0).with(s -> s.values(0).peers(false));
    }

    /** Returns whether code is warmed up before timing, so that times are valid. */
    boolean isWarm() {
        return repetitions > 1;
    }

    /** Returns whether a case is measured. */
    boolean includes(PaperCase edit) {
        return figure == 0 ? further || edit.isPrinted() : PaperFigures.shows(figure, edit);
    }
}
