package lightning.bench.result;

import java.util.Arrays;
import java.util.List;
import lightning.render.measure.AccuracySetting;
import lightning.render.measure.PictureError;
import lightning.render.measure.Timing;

/** Handmade results. */
public final class SampleResults {
    public static final BenchRun RUN = new BenchRun("2026-01-31T12:00:00Z", "abc", List.of("--quick"),
            new MachineSpec("Linux, amd64", "AMD EPYC", 2, 512, 16_000_000_000L, 4_000_000_000L, "Java 25"), new SystemLoad(0.1, 1.9, 0.02),
            1, 2, 3,
            true, 10, 12, true, 40,
            List.of(39.0, 40.0));

    private SampleResults() {}

    public static TimeSamples samples(double... ms) {
        return TimeSamples.of(new Timing(Arrays.stream(ms).boxed().toList()));
    }

    /** Returns a scene with one edit at setting exact that took about {@code ms} milliseconds. */
    public static SceneResult scene(double ms) {
        return scene(0, ms, ms - 2, ms + 2);
    }

    /** Returns a scene with one edit at setting exact, given its samples and maximum error, and a full trace of 20 ms. */
    public static SceneResult scene(double error, double... ms) {
        return scene(samples(20, 20, 20), error, ms);
    }

    /** Returns a scene with one edit at setting exact and a full trace. */
    public static SceneResult scene(TimeSamples full, double error, double... ms) {
        var none = new PictureError(error > 0 ? 1 : 0, 180_000, 0, error, error / 180_000, error / 424, 60, 70, 1, 0);
        var work = new UpdateWork("sun: weight", 0, 0, 100, 0, 1000, 0.5, 10, 90, 0);
        var rung = new SweepPointResult(AccuracySetting.EXACT, samples(ms), 75, none, work, null, null);
        var same = new PictureError(0, 180_000, 0, 0, 0, 0, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, 1, 0);
        var traced = new SweepPointResult(AccuracySetting.FULL_TRACE, full, 0, same, null, null, null);
        var edit = new EditResult("color", "Fig. 6", 98, 75, 90,
                List.of(new ValueResult("sun: color 1 1 1 → 1 0 0, on yes → no", List.of(rung, traced))));
        return new SceneResult("bird", 300, 200, 3, 10, 3, null, null, List.of(edit), List.of(), null, null);
    }
}
