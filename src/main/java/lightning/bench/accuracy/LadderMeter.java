package lightning.bench.accuracy;

import java.util.ArrayList;
import java.util.List;
import lightning.base.work.Memory;
import lightning.base.work.Progress;
import lightning.base.work.Workers;
import lightning.render.cache.PixelCache;
import lightning.render.engine.choice.Engines;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.render.image.Film;
import lightning.render.relight.MemoryNeed;
import lightning.render.shading.SeenScenes;
import lightning.scene.Scene;
import lightning.scene.effects.ViewEffects;

/**
 * Measures the ladder of an edit: every grade of accuracy, in turns with a full trace.
 *
 * <p>Each grade makes the edit once and is compared with its oracle before anything is timed. Each timed edit starts from
 * what was kept of the scene before it, so none profits from the one before. The full trace gets its tree of boxes for free.
 * Edits that start from the same scene share its first pass; what is kept of it stays in memory until the meter is closed.
 */
public final class LadderMeter implements AutoCloseable {
    private final Workers workers;
    private final Turns turns;
    private final List<Relighting> grades = new ArrayList<>();
    private Scene start;
    private PixelCache kept;

    /**
     * @param threads     how many threads each grade works with, ≥ 1
     * @param repetitions how often each grade is measured, ≥ 1
     * @param patienceMs  how long warming up takes at most, milliseconds
     * @throws IllegalArgumentException if {@code threads} or {@code repetitions} is below 1
     */
    public LadderMeter(int threads, int repetitions, double patienceMs) {
        this(threads, new Turns(repetitions, patienceMs));
    }

    /** A meter for a Java that has not run for long, as an editor's: works must be steady for a while. */
    public static LadderMeter patient(int threads, int repetitions, double patienceMs) {
        return new LadderMeter(threads, new Turns(repetitions, patienceMs, WarmSaving.STEADY_MS));
    }

    private LadderMeter(int threads, Turns turns) {
        this.turns = turns;
        workers = new Workers(threads);
        for (Grade grade : Grade.values()) {
            if (grade != Grade.FULL_TRACE) {
                grades.add(new Relighting(grade, workers));
            }
        }
    }

    /**
     * Measures the edit that leads from one scene to another.
     *
     * @param progress hears of finished rounds
     * @throws BrokenPromise if a grade's picture is not what it promises
     * @throws java.util.concurrent.CancellationException if {@code progress} asked to stop
     */
    public Ladder measure(Scene before, Scene after, Progress progress) {
        Progress silent = progress.silent();
        begin(before, silent);
        List<Relighting> measured = grades.stream().filter(grade -> grade.grade().isOf(before)).toList();
        for (Relighting grade : measured) {
            grade.edit(after, silent);
            grade.verify(silent);
        }
        var tracer = new TraditionalTracer(after, grades.getLast().geometry()).by(Engines.FASTEST);
        TraditionalTracer.Result full = tracer.trace(workers, silent);
        // What shows the scene as it is must be the very picture that it is measured beside.
        var same = new Promise(SeenScenes.of(after), ViewEffects.ALL, 0);
        measured.stream().filter(grade -> grade.grade() == Grade.EXACT_UPDATED || grade.grade() == Grade.EXACT_CURRENT)
                .forEach(grade -> BrokenPromise.require(same.verify(grade.film(), workers, silent), grade.grade()));
        List<Turns.Turn<RuntimeException>> works = new ArrayList<>();
        measured.forEach(grade -> works.add(() -> grade.edit(after, silent)));
        works.add(() -> Turns.time(() -> tracer.trace(workers, silent)));
        boolean warm = turns.warmUp(works, silent);
        List<Timing> times = turns.measure(works, progress);
        return new Ladder(before, after, kept.film(), rungs(measured, times, full.film(), silent), full.rays(), warm);
    }

    /** What is kept of the scene that the last measured edit started from. */
    public PixelCache kept() {
        return kept;
    }

    private void begin(Scene before, Progress progress) {
        if (before.equals(start)) {
            return;
        }
        start = null;
        kept = null;
        // The grades' pictures lie in memory beside each other.
        long memory = Memory.available();
        for (Relighting grade : grades.stream().filter(g -> g.grade().isOf(before)).toList()) {
            if (grade.grade().startsFromExact()) {
                grade.begin(kept);
            } else {
                PixelCache own = grade.begin(before, memory, progress);
                memory -= MemoryNeed.of(own);
                kept = grade.grade() == Grade.EXACT ? own : kept;
            }
        }
        start = before;
    }

    private List<Rung> rungs(List<Relighting> measured, List<Timing> times, Film reference, Progress progress) {
        PictureError[] errors = new PictureError[measured.size()];
        workers.run(errors.length, (_, i) -> errors[i] = PictureError.of(measured.get(i).film(), reference), progress);
        List<Rung> rungs = new ArrayList<>();
        for (int i = 0; i < errors.length; i++) {
            Relighting grade = measured.get(i);
            rungs.add(new Rung(grade.grade(), times.get(i), errors[i], grade.film(), grade.update()));
        }
        rungs.add(new Rung(Grade.FULL_TRACE, times.getLast(), PictureError.of(reference, reference), reference, null));
        return rungs;
    }

    @Override
    public void close() {
        grades.forEach(Relighting::close);
        workers.close();
    }
}
