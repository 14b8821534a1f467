package lightning.render.relight;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CancellationException;
import java.util.stream.Collectors;
import lightning.base.work.Progress;
import lightning.render.cache.PixelCache;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.render.relight.tile.Options;
import lightning.scene.Light;
import lightning.scene.Scene;

/**
 * Which lights matter to a picture, from what is kept of it. A light's share is composed; what the picture is without a light is rendered as any edit is,
 * which only composes, but for finer samples where the light threw an edge.
 *
 * @param lights      one for each light of the scene, in its order
 * @param environment of the environment with what is seen of it, where the scene has one; its shares are what the picture loses without it
 * @param idle   lights that shine, and of which no pixel is displayed in another colour while all of them are off
 * @param without what is another in the picture without all of these
 */
public record Contributions(List<Contribution> lights, Optional<Contribution> environment, List<String> idle, Contribution.Change without) {

    /** What the environment is called among lights. */
    public static final String ENVIRONMENT = "environment";

    /**
     * A part of a picture.
     *
     * @param left   the first column; likewise {@code top}
     * @param right  behind the last column; likewise {@code bottom}
     */
    public record Region(int left, int top, int right, int bottom) {
        /** All of a picture. */
        public static Region all(Film film) {
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
     * Asks all lights of a picture.
     *
     * @param cache    a finished picture's, never changed here
     * @param options  those that it was rendered with
     * @param view     how it is displayed
     * @param region   the part of which shares are told too
     * @param progress counts lights
     * @throws CancellationException if {@code progress} asked to stop
     */
    public static Contributions of(PixelCache cache, Options options, ViewTransform view, Region region, Progress progress) {
        Scene scene = cache.scene();
        Film picture = cache.film();
        Region all = Region.all(picture);
        double light = all.luminance(picture);
        double inRegion = region.luminance(picture);
        List<Contribution> lights = new ArrayList<>();
        int total = scene.lights().size() + 1;
        Progress silent = progress.silent();
        try (Renderer renderer = new Renderer(options)) {
            for (Light one : scene.lights()) {
                progress.tiles(lights.size(), total);
                renderer.restore(cache);
                if (!scene.shines(one)) {
                    lights.add(new Contribution(one.name(), false, 0, 0, Contribution.Change.NONE));
                    continue;
                }
                Film share = renderer.share(one.name(), silent);
                lights.add(new Contribution(one.name(), true, part(all.luminance(share), light), part(region.luminance(share), inRegion),
                        without(renderer, Set.of(one.name()), scene, picture, view, silent)));
            }
            Optional<Contribution> environment = environment(renderer, cache, view, region, silent);
            List<Contribution> idle = new ArrayList<>(lights.stream().filter(c -> c.shines() && c.without().isUnseen())
                    .sorted(Comparator.comparingDouble(Contribution::picture)).toList());
            Contribution.Change together = Contribution.Change.NONE;
            // What each does not show, all may show together: the brightest stay then.
            while (!idle.isEmpty()) {
                renderer.restore(cache);
                together =
                        without(renderer, idle.stream().map(Contribution::light).collect(Collectors.toSet()), scene, picture, view, silent);
                if (together.isUnseen()) {
                    break;
                }
                idle.removeLast();
                together = Contribution.Change.NONE;
            }
            progress.tiles(total, total);
            return new Contributions(List.copyOf(lights), environment, idle.stream().map(Contribution::light).toList(), together);
        }
    }

    private static Optional<Contribution> environment(Renderer renderer, PixelCache cache, ViewTransform view, Region region,
            Progress progress) {
        Scene scene = cache.scene();
        Film picture = cache.film();
        if (scene.world().environment().isEmpty()) {
            return Optional.empty();
        }
        renderer.restore(cache);
        renderer.render(scene.withWorld(scene.world().withIntensity(0)), progress);
        Film without = renderer.film();
        return Optional.of(new Contribution(ENVIRONMENT, scene.world().intensity() > 0, lost(Region.all(picture), picture, without),
                lost(region, picture, without), Contribution.Change.between(picture, without, view)));
    }

    private static double lost(Region region, Film picture, Film without) {
        double light = region.luminance(picture);
        return part(light - region.luminance(without), light);
    }

    private static double part(double share, double of) {
        return of > 0 ? share / of : 0;
    }

    private static Contribution.Change without(Renderer renderer, Set<String> dark, Scene scene, Film picture, ViewTransform view,
            Progress progress) {
        renderer.render(off(scene, dark), progress);
        return Contribution.Change.between(picture, renderer.film(), view);
    }

    /** The scene with some of its lights switched off. */
    public static Scene off(Scene scene, Iterable<String> lights) {
        Set<String> dark = new HashSet<>();
        lights.forEach(dark::add);
        return scene.withLights(scene.lights().stream().map(l -> dark.contains(l.name()) ? l.withOn(false) : l).toList());
    }
}
