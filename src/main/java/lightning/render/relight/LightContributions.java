package lightning.render.relight;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CancellationException;
import java.util.stream.Collectors;
import lightning.base.work.Progress;
import lightning.render.cache.PixelCache;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.render.relight.tile.RenderOptions;
import lightning.scene.Contribution;
import lightning.scene.EnvironmentLayer;
import lightning.scene.Scene;
import lightning.scene.light.Light;

/**
 * Contributions of all lights to a picture, computed from its cache. A light's share is composed. The picture without a light is
 * rendered as an edit, which only composes, except for finer samples at the light's edges.
 *
 * @param lights            one contribution for each light and each environment of the scene, in its order; the shares of an environment are
 *                          the losses without it, its visible background included
 * @param idleLights        lights that shine, but change the display color of no pixel when all of them are off
 * @param changeWhenIdleOff change of the picture when all of these are off
 */
public record LightContributions(List<LightContribution> lights, List<Contribution> idleLights,
        LightContribution.FilmChange changeWhenIdleOff) {

    /**
     * Region of a picture.
     *
     * @param left  the first column, with {@code top} as the first row
     * @param right the column after the last, with {@code bottom} as the row after the last
     */
    public record Region(int left, int top, int right, int bottom) {
        /** Returns the region of a whole film. */
        public static Region ofFilm(Film film) {
            return new Region(0, 0, film.width(), film.height());
        }

        double luminance(Film film) {
            double sum = 0;
            for (int y = Math.max(0, top); y < Math.min(film.height(), bottom); y++) {
                for (int x = Math.max(0, left); x < Math.min(film.width(), right); x++) {
                    sum += 0.2126 * film.red(x, y) + 0.7152 * film.green(x, y) + 0.0722 * film.blue(x, y);
                }
            }
            return sum;
        }
    }

    /**
     * Computes the contributions of all lights to a picture.
     *
     * @param cache    cache of a finished picture; not modified
     * @param options  options of its render
     * @param view     view transform of its display
     * @param region   region whose shares are computed too
     * @param progress counts lights
     * @throws CancellationException if {@code progress} requested cancellation
     */
    public static LightContributions of(PixelCache cache, RenderOptions options, ViewTransform view, Region region, Progress progress) {
        Scene scene = cache.scene();
        Film picture = cache.film();
        Region all = Region.ofFilm(picture);
        List<LightContribution> lights = new ArrayList<>();
        int total = Contribution.sources(scene).size();
        Progress silent = progress.cancellationOnly();
        try (Renderer renderer = new Renderer(options)) {
            for (Light one : scene.lights()) {
                progress.report(lights.size(), total);
                renderer.restore(cache);
                if (!scene.isActive(one)) {
                    lights.add(new LightContribution(Contribution.of(one), false, 0, 0, LightContribution.FilmChange.NONE));
                    continue;
                }
                Film share = renderer.lightImage(one.name(), silent);
                lights.add(new LightContribution(Contribution.of(one), true, LightShares.ofContribution(share, picture, all),
                        LightShares.ofContribution(share, picture, region),
                        without(renderer, Set.of(Contribution.of(one)), scene, picture, view, silent)));
            }
            List<LightContribution> idle = new ArrayList<>(lights.stream().filter(c -> c.shines() && c.changeWhenOff().isInvisible())
                    .sorted(Comparator.comparingDouble(LightContribution::imageShare)).toList());
            LightContribution.FilmChange together = LightContribution.FilmChange.NONE;
            // Lights that are invisible alone may be visible together: the brightest ones then stay.
            while (!idle.isEmpty()) {
                renderer.restore(cache);
                together =
                        without(renderer, idle.stream().map(LightContribution::light).collect(Collectors.toSet()), scene, picture, view,
                                silent);
                if (together.isInvisible()) {
                    break;
                }
                idle.removeLast();
                together = LightContribution.FilmChange.NONE;
            }
            for (Contribution environment : Contribution.environments(scene)) {
                progress.report(lights.size(), total);
                lights.add(ofEnvironment(environment, renderer, cache, view, region, silent));
            }
            progress.report(total, total);
            return new LightContributions(List.copyOf(lights), idle.stream().map(LightContribution::light).toList(), together);
        }
    }

    private static LightContribution ofEnvironment(Contribution environment, Renderer renderer, PixelCache cache, ViewTransform view,
            Region region, Progress progress) {
        int index = environment.environmentIndex(cache.scene());
        EnvironmentLayer layer = cache.scene().world().environments().get(index);
        Film picture = cache.film();
        Film filmOff = LightShares.withoutEnvironment(renderer, cache, index, progress);
        return new LightContribution(environment, layer.on() && layer.intensity() > 0,
                LightShares.ofLoss(filmOff, picture, Region.ofFilm(picture)), LightShares.ofLoss(filmOff, picture, region),
                LightContribution.FilmChange.between(picture, filmOff, view));
    }

    private static LightContribution.FilmChange without(Renderer renderer, Set<Contribution> switchedOff, Scene scene, Film picture,
            ViewTransform view,
            Progress progress) {
        renderer.renderWithSameSamples(switchOff(scene, switchedOff), progress);
        return LightContribution.FilmChange.between(picture, renderer.film(), view);
    }

    /** Returns the scene with some of its lights switched off. */
    public static Scene switchOff(Scene scene, Collection<Contribution> lights) {
        Set<Contribution> off = Set.copyOf(lights);
        return scene.withLights(scene.lights().stream().map(l -> off.contains(Contribution.of(l)) ? l.withOn(false) : l).toList());
    }
}
