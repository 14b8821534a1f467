package lightning.bench;

import io.soabase.recordbuilder.core.RecordBuilder;
import java.util.List;
import lightning.bench.accuracy.PaperCase;
import lightning.bench.accuracy.PaperCases;

/**
 * What a run measures, and how thoroughly.
 *
 * @param sizes       each scene is measured at each of them; pictures are written of the first
 * @param figure      the paper's figure whose edits alone are measured; 0 for all edits
 * @param values      how many varying values of each edit, 0 (no edits) to {@link PaperCases#VALUES}
 * @param further     whether edits that the paper does not print are measured too
 * @param repetitions how many samples each work has, ≥ 1; 1 is for a look at what comes out: nothing is warmed up
 * @param patienceMs  how long warming up one group of works takes at most, milliseconds
 * @param threads     how many threads each work has, ≥ 1
 * @param seed        what everything random starts from
 * @param curves      whether growth and drift are measured
 * @param editing     whether it is measured what editing large scenes costs
 * @param meshes      whether it is measured how fast rays are traced against meshes
 * @param effects     whether it is measured what each effect takes, at the last of the sizes
 * @param peers       whether other programs are measured where they are installed
 * @param processes   how many processes that begin cold render each picture, 0 for none
 * @param quick       whether it is the small selection
 */
@RecordBuilder
public record BenchSettings(List<PictureSize> sizes, int figure, int values, boolean further, int repetitions, double patienceMs,
        int threads,
        long seed, boolean curves, boolean editing, boolean meshes, boolean effects, boolean peers, int processes, boolean quick)
        implements BenchSettingsBuilder.With {
    /** The paper's pictures (§4.1), and today's. */
    private static final List<PictureSize> FULL_SIZES = List.of(new PictureSize(300, 300), new PictureSize(1920, 1080));
    private static final int PROCESSES = 10;
    private static final List<PictureSize> QUICK_SIZES = List.of(new PictureSize(640, 480));

    public BenchSettings {
        sizes = List.copyOf(sizes);
        patienceMs = repetitions > 1 ? patienceMs : 0;
    }

    /** Everything. */
    public static BenchSettings full(int threads, long seed) {
        return new BenchSettings(FULL_SIZES, 0, PaperCases.VALUES, true, 5, 300, threads, seed, true, true, true, true, true, PROCESSES,
                false);
    }

    /** A selection for a minute or two: one size and one value, the printed edits, short curves, no other programs. */
    public static BenchSettings quick(int threads, long seed) {
        return new BenchSettings(QUICK_SIZES, 0, 1, false, 3, 0, threads, seed, true, true, true, false, false, 0, true);
    }

    /** Nothing of what edits alone need: no effects, no whole processes. */
    public BenchSettings editsAndCurves() {
        return with(s -> s.editing(false).meshes(false).effects(false).processes(0));
    }

    /** The edits of one figure alone, without curves. */
    @Override
    public BenchSettings withFigure(int v) {
        return editsAndCurves().with(s -> s.figure(v).further(false).curves(false));
    }

    /** What effects take, and nothing else but the first pass. */
    public BenchSettings effectsOnly() {
        return firstPassOnly().withEffects(true);
    }

    /** Processes that begin cold, and nothing else but the first pass. */
    public BenchSettings coldStartOnly() {
        return firstPassOnly().withProcesses(PROCESSES);
    }

    /** What editing large scenes costs, and nothing else. */
    public BenchSettings editingOnly() {
        return firstPassOnly().with(s -> s.sizes(List.of()).editing(true));
    }

    /** How fast rays are traced against meshes, and nothing else. */
    public BenchSettings meshesOnly() {
        return firstPassOnly().with(s -> s.sizes(List.of()).meshes(true).peers(peers));
    }

    private BenchSettings firstPassOnly() {
        return withFigure(0).with(s -> s.values(0).peers(false));
    }

    /** Whether times are worth something: code is warmed up. */
    boolean isWarm() {
        return repetitions > 1;
    }

    /** Whether a case is measured. */
    boolean includes(PaperCase edit) {
        return figure == 0 ? further || edit.isPrinted() : PaperFigures.shows(figure, edit);
    }
}
