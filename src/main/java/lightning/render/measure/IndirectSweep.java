package lightning.render.measure;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import lightning.base.work.Progress;
import lightning.base.work.ProgressPart;
import lightning.render.cache.PixelCache;
import lightning.render.gather.PathsTooLargeException;
import lightning.render.image.Film;
import lightning.render.relight.PictureTooLargeException;
import lightning.render.relight.Renderer;
import lightning.render.relight.UpdateResult;
import lightning.render.relight.tile.RenderOptions;
import lightning.scene.IndirectSettings;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;
import org.jspecify.annotations.Nullable;

/**
 * Time and difference of a scene's indirect light for several spacings and numbers of rays, without anti-aliasing. The differences are
 * those to the densest setting that fits into memory.
 *
 * @param directMilliseconds time of a first pass without indirect light
 * @param points             one for each setting, from fast to slow
 */
public record IndirectSweep(double directMilliseconds, List<Point> points) {
    private static final int[] SPACINGS = {16, 8, 4};
    private static final int[] RAYS = {16, 64, 256};

    public IndirectSweep {
        points = List.copyOf(points);
    }

    /**
     * Measurement of one setting.
     *
     * @param milliseconds   time that indirect light adds to a first pass
     * @param meanDifference mean difference of the pixels' luminance ({@link RelativeErrors})
     * @param difference95   95th percentile of these differences
     */
    public record Point(IndirectSettings settings, boolean fits, double milliseconds, double meanDifference, double difference95) {}

    /** Settings, and their time and luminance if they fit into memory. */
    private record Trial(IndirectSettings settings, double milliseconds, double @Nullable [] luminance) {}

    /**
     * Measures all settings.
     *
     * @param scene   scene, with or without indirect light
     * @param options render options; their view is ignored
     * @throws PictureTooLargeException if not even the picture without indirect light fits into memory
     * @throws java.util.concurrent.CancellationException if {@code progress} requests a stop
     */
    public static IndirectSweep measure(Scene scene, RenderOptions options, Progress progress) {
        IndirectSettings base = scene.picture().indirect().orElse(IndirectSettings.DEFAULT);
        List<IndirectSettings> settings = Arrays.stream(SPACINGS).boxed()
                .flatMap(spacing -> Arrays.stream(RAYS).mapToObj(rays -> base.withSpacing(spacing).withRays(rays))).toList();
        double total = settings.stream().mapToDouble(IndirectSweep::expectedWork).sum();
        Scene plain = scene.withPicture(scene.picture().withSampling(SamplingSettings.DEFAULT)).withoutIndirect();
        try (var renderer = new Renderer(options)) {
            UpdateResult direct = renderer.render(plain, progress.cancellationOnly());
            PixelCache start = renderer.cache();
            List<Trial> trials = new ArrayList<>();
            double work = 0;
            for (IndirectSettings s : settings) {
                double after = work + expectedWork(s);
                renderer.restore(start);
                trials.add(render(renderer, plain, s, new ProgressPart(progress, work / total, after / total)));
                work = after;
            }
            return new IndirectSweep(direct.milliseconds(), compare(trials));
        }
    }

    /** Returns the points that no other beats in both time and mean difference, fastest first. */
    public List<Point> front() {
        return ParetoFront.of(points.stream().filter(Point::fits).toList(), Point::milliseconds, Point::meanDifference);
    }

    /** Returns the expected work of a setting: the rays of its gather points, and a part that does not depend on them. */
    private static double expectedWork(IndirectSettings s) {
        return (s.rays() + 64.0) / (s.spacing() * s.spacing());
    }

    private static Trial render(Renderer renderer, Scene plain, IndirectSettings settings, Progress progress) {
        Scene scene = plain.withPicture(plain.picture().withIndirect(Optional.of(settings)));
        try {
            renderer.requireMemory(scene, 0, progress.cancellationOnly(), _ -> {});
            UpdateResult update = renderer.render(scene, progress);
            return new Trial(settings, update.milliseconds(), luminance(renderer.film()));
        } catch (PictureTooLargeException | PathsTooLargeException | OutOfMemoryError e) {
            return new Trial(settings, Double.NaN, null);
        }
    }

    private static double[] luminance(Film film) {
        double[] values = new double[film.width() * film.height()];
        for (int y = 0; y < film.height(); y++) {
            for (int x = 0; x < film.width(); x++) {
                values[y * film.width() + x] = BruteForceGather.luminance(film.red(x, y), film.green(x, y), film.blue(x, y));
            }
        }
        return values;
    }

    private static List<Point> compare(List<Trial> trials) {
        double[] densest = trials.stream().map(Trial::luminance).filter(l -> l != null).reduce(null, (_, last) -> last);
        return trials.stream().map(trial -> compare(trial, densest)).toList();
    }

    private static Point compare(Trial trial, double @Nullable [] densest) {
        if (trial.luminance == null || densest == null) {
            return new Point(trial.settings, false, 0, 0, 0);
        }
        RelativeErrors differences = RelativeErrors.of(trial.luminance, densest);
        return new Point(trial.settings, true, trial.milliseconds, differences.mean(), differences.percentile(IndirectError.HIGH));
    }
}
