package lightning.render.measure;

import java.util.ArrayList;
import java.util.List;
import lightning.base.work.Progress;
import lightning.base.work.ProgressPart;
import lightning.render.RenderOptions;
import lightning.render.cache.PixelCache;
import lightning.render.gather.ray.PathsTooLargeException;
import lightning.render.relight.PictureTooLargeException;
import lightning.render.relight.Renderer;
import lightning.render.relight.UpdateResult;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;
import lightning.scene.effects.ViewEffects;
import org.jspecify.annotations.Nullable;

/**
 * Time and difference of a scene's image for several settings of an effect, without anti-aliasing. The differences are those to the densest
 * setting that fits into memory.
 *
 * @param baseMilliseconds time of a first pass without the effect
 * @param points           one for each setting, in the effect's order
 */
public record SettingSweep(double baseMilliseconds, List<Point> points) {
    public SettingSweep {
        points = List.copyOf(points);
    }

    /**
     * Measurement of one setting.
     *
     * @param milliseconds   time that the effect adds to a first pass
     * @param meanDifference mean difference of the pixels' luminance ({@link RelativeErrors})
     * @param difference95   95th percentile of these differences
     */
    public record Point(SweptSetting setting, boolean fits, double milliseconds, double meanDifference, double difference95) {}

    /** Settings, and their time and luminance if they fit into memory. */
    private record Trial(SweptSetting setting, double milliseconds, double @Nullable [] luminance) {}

    /**
     * Measures all settings.
     *
     * @param scene   scene, with or without the effect
     * @param options render options; their view is ignored
     * @throws PictureTooLargeException if not even the picture without the effect fits into memory
     * @throws java.util.concurrent.CancellationException if {@code progress} requests a stop
     */
    public static SettingSweep measure(SweptEffect effect, Scene scene, RenderOptions options, Progress progress) {
        double total = effect.settings().stream().mapToDouble(SweptSetting::expectedWork).sum();
        Scene centers = scene.withPicture(scene.picture().withSampling(SamplingSettings.DEFAULT));
        Scene plain = ViewEffects.ALL.with(effect.effect(), false).apply(centers);
        try (var renderer = new Renderer(options)) {
            UpdateResult base = renderer.render(plain, progress.cancellationOnly());
            PixelCache start = renderer.cache();
            List<Trial> trials = new ArrayList<>();
            double work = 0;
            for (SweptSetting setting : effect.settings()) {
                double after = work + setting.expectedWork();
                renderer.restore(start);
                trials.add(render(renderer, centers, setting, new ProgressPart(progress, work / total, after / total)));
                work = after;
            }
            return new SettingSweep(base.milliseconds(), compare(trials));
        }
    }

    /** Returns the points that no other beats in both time and mean difference, fastest first. */
    public List<Point> front() {
        return ParetoFront.of(points.stream().filter(Point::fits).toList(), Point::milliseconds, Point::meanDifference);
    }

    private static Trial render(Renderer renderer, Scene centers, SweptSetting setting, Progress progress) {
        Scene scene = setting.applyTo(centers);
        try {
            renderer.requireMemory(scene, 0, progress.cancellationOnly(), _ -> {});
            UpdateResult update = renderer.render(scene, progress);
            return new Trial(setting, update.milliseconds(), RelativeErrors.luminances(renderer.film()));
        } catch (PictureTooLargeException | PathsTooLargeException | OutOfMemoryError e) {
            return new Trial(setting, Double.NaN, null);
        }
    }

    private static List<Point> compare(List<Trial> trials) {
        double[] densest = trials.stream().map(Trial::luminance).filter(l -> l != null).reduce(null, (_, last) -> last);
        return trials.stream().map(trial -> compare(trial, densest)).toList();
    }

    private static Point compare(Trial trial, double @Nullable [] densest) {
        if (trial.luminance == null || densest == null) {
            return new Point(trial.setting, false, 0, 0, 0);
        }
        RelativeErrors differences = RelativeErrors.of(trial.luminance, densest);
        return new Point(trial.setting, true, trial.milliseconds, differences.mean(), differences.percentile(IndirectError.HIGH));
    }
}
