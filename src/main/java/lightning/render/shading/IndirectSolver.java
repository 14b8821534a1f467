package lightning.render.shading;

import java.util.Arrays;
import java.util.List;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.gather.GatherStructure;
import lightning.render.gather.cell.SkyCells;
import lightning.render.gather.glow.GlowLinks;
import lightning.render.gather.glow.GlowPaths;
import lightning.render.gather.glow.GlowShapes;
import lightning.render.gather.ray.FilmKernel;
import lightning.render.gather.ray.FilmLight;
import lightning.render.gather.ray.RayLinks;
import lightning.render.gather.ray.RaySums;
import lightning.render.gather.reflection.ReflectionPaths;
import lightning.render.gather.rim.RimLinks;
import org.jspecify.annotations.Nullable;

/**
 * Computes the light at gather points from the direct light of surfels, by look-ups along the paths of a {@link GatherStructure}.
 *
 * <pre>
 * B₁ = glow + albedo · (D + S)               D = the lights' diffuse sum at a surfel, S = the environment's light there
 * Bₙ = glow + albedo · (D + mean of Bₙ₋₁ over the surfel's rays + G)
 * E  = filter(mean of B over the gather point's rays + G)
 * </pre>
 *
 * <p>Rays that leave the scene meet the {@link BackgroundLight}. S is the mean of those of an environment over the surfel's rays. Without
 * bounces they alone meet light.
 *
 * <p>Where a point casts additional rays through the rim of an opening ({@link RimLinks}), their mean replaces the light of one ray.
 *
 * <p>G is the light of small glowing objects, at which rays of their own are aimed ({@link GlowPaths}). The other rays that meet these
 * objects do not count their glow.
 *
 * <p>A surfel that a reflection shows sends glow + ambient light + the lights' diffuse and specular light + albedo · (the light that its rays
 * gather).
 *
 * <p>Rays are cosine-distributed, so the plain mean is the irradiance in units of the lights' diffuse sum. Floats are added in the order
 * of the rays. Each film has the lights of its contribution alone; some films stand side by side, so that one walk along the paths serves
 * them.
 *
 * @param films  at most {@link FilmLight#MAX_FILMS}
 * @param albedo of each surfel
 */
public record IndirectSolver(GatherStructure structure, List<Source> films, float[][] albedo, FilmKernel kernel, WorkerPool workers,
        Progress progress) {
    private static final int BATCH = 512;

    /**
     * What a film is gathered from.
     *
     * @param direct     lights' diffuse sum at each surfel
     * @param glow       light that each surfel emits itself
     * @param objects    light of each glowing object, as {@link GlowShapes#glow}; null for none
     * @param seen       light of each surfel that a picture shows, without the light that it gathers; read by reflections only
     * @param background light of rays that leave the scene
     */
    public record Source(float[][] direct, float[][] glow, float @Nullable [][] objects, float[][] seen, BackgroundLight background) {
        // Arrays in a record: written once by their creator, never after.
    }

    public IndirectSolver {
        progress = progress.cancellationOnly();
    }

    /**
     * Returns the light at all gather points by film: red, green, blue. If the paths contain reflections, six columns follow with the light
     * at reflection points: red, green and blue of what the reflectance multiplies, and the same of what no color multiplies.
     *
     * @throws java.util.concurrent.CancellationException if the progress requested cancellation
     */
    public float[][][] solve() {
        ReflectionPaths reflections = structure.reflections();
        float[][][] atSurfels = new float[films.size()][3][reflections == null ? 0 : structure.surfelCount()];
        FilmLight radiosity = radiosity(atSurfels);
        GlowPaths glowPaths = structure.glow();
        RayLinks links = structure.pointLinks();
        int points = structure.pointCount();
        FilmLight gathered = FilmLight.black(films.size(), points);
        float[][][] light = new float[films.size()][reflections == null ? 3 : 9][points];
        run(points, (from, to) -> {
            RaySums mean = new RaySums(kernel);
            RaySums own = new RaySums(kernel);
            RaySums others = new RaySums(kernel);
            for (int p = from; p < to; p++) {
                links.sum(p, radiosity, mean);
                structure.rims().add(p, links, radiosity, own, others, mean);
                addGlow(glowPaths.ofPoints(), p, mean);
                mean.writeTo(gathered, p);
            }
        });
        run(points, (from, to) -> structure.filter(gathered, kernel, light, from, to));
        if (reflections != null) {
            reflect(reflections, atSurfels, light);
        }
        return light;
    }

    private void addGlow(GlowLinks links, int point, RaySums to) {
        for (int film = 0; film < films.size(); film++) {
            float[][] objects = films.get(film).objects;
            if (objects != null) {
                links.add(point, objects, film, to);
            }
        }
    }

    /** Returns the light that surfels gather, without the noise of their few rays. */
    private float[][][] smooth(ReflectionPaths paths, float[][][] atSurfels) {
        int gathering = paths.gatheringSurfels();
        FilmLight noisy = FilmLight.black(films.size(), gathering);
        float[][][] smooth = new float[films.size()][3][];
        for (int film = 0; film < smooth.length; film++) {
            float[][] its = atSurfels[film];
            for (int i = 0; i < gathering; i++) {
                noisy.set(i, film, its[0][i], its[1][i], its[2][i]);
            }
            for (int c = 0; c < 3; c++) {
                smooth[film][c] = its[c].clone();
            }
        }
        run(gathering, (from, to) -> paths.filterSurfels(noisy, kernel, smooth, from, to));
        return smooth;
    }

    /**
     * Writes the light at reflection points: what a picture would show of the surfels, and the sky.
     *
     * @param atSurfels light that the rays of surfels gather
     */
    private void reflect(ReflectionPaths paths, float[][][] atSurfels, float[][][] light) {
        int sources = paths.links().points();
        FilmLight shown = shown(paths, smooth(paths, atSurfels));
        FilmLight color = FilmLight.black(films.size(), sources);
        FilmLight white = FilmLight.black(films.size(), sources);
        boolean hasSky = films.stream().anyMatch(film -> !film.background.layers().isEmpty());
        run(paths.count(), (from, to) -> paths.writeMeans(shown, hasSky, kernel, color, white, from, to));
        float[][][] colors = new float[films.size()][3][paths.count()];
        float[][][] whites = new float[films.size()][3][paths.count()];
        run(paths.count(), (from, to) -> {
            paths.filter(color, kernel, colors, from, to);
            paths.filter(white, kernel, whites, from, to);
        });
        for (int film = 0; film < light.length; film++) {
            System.arraycopy(colors[film], 0, light[film], 3, 3);
            System.arraycopy(whites[film], 0, light[film], 6, 3);
        }
    }

    /** Returns what a picture would show of the surfels, and then the cells of the sky. @param smooth light that surfels gather */
    private FilmLight shown(ReflectionPaths paths, float[][][] smooth) {
        int surfels = structure.surfelCount();
        int[] details = paths.surfelOfDetail();
        int whole = surfels - details.length;
        FilmLight shown = FilmLight.black(films.size(), surfels + SkyCells.NUMBERS);
        run(surfels, (from, to) -> {
            for (int film = 0; film < smooth.length; film++) {
                float[][] seen = films.get(film).seen;
                for (int s = from; s < to; s++) {
                    int gathering = s < whole ? s : details[s - whole];
                    int at = shown.at(s, film);
                    for (int c = 0; c < 3; c++) {
                        shown.values()[at + c] = seen[c][s] + albedo[c][s] * smooth[film][c][gathering];
                    }
                }
            }
        });
        for (int film = 0; film < smooth.length; film++) {
            films.get(film).background.writeSky(shown, surfels, film);
        }
        return shown;
    }

    /**
     * Returns what each ray of a point that hits a surfel adds to the mean; after the last surfel the same for the background or its cells,
     * then for the surfels on glowing objects without their glow.
     *
     * @param atSurfels receives the light that the rays of surfels gather by film; empty if it is not needed
     */
    private FilmLight radiosity(float[][][] atSurfels) {
        int surfels = structure.surfelCount();
        RayLinks links = structure.surfelLinks();
        int misses = structure.pointLinks().misses();
        float[][] background = new float[films.size()][];
        Arrays.setAll(background, film -> films.get(film).background.cells(misses));
        FilmLight radiosity = withBackground(background, share(structure.bounces() == 0));
        for (int bounce = 1; bounce <= structure.bounces(); bounce++) {
            FilmLight before = bounce == 1 && misses == 1 ? null : radiosity;
            boolean hasGlow = bounce > 1;
            // Shares of the mean are added, because sums of the brightest light overflow.
            float share = share(bounce == structure.bounces());
            FilmLight after = withBackground(background, share);
            run(surfels, (from, to) -> {
                float[][][] met = new float[films.size()][3][to - from];
                int end = Math.min(to, links.points());
                RaySums gathered = new RaySums(kernel);
                for (int s = from; before != null && s < end; s++) {
                    links.sum(s, before, gathered);
                    if (hasGlow) {
                        addGlow(structure.glow().ofSurfels(), s, gathered);
                    }
                    gathered.writeTo(met, s - from);
                }
                for (int film = 0; film < met.length; film++) {
                    scatter(film, met[film], after, share, from);
                    for (int c = 0; c < 3 && atSurfels[film][c].length > 0; c++) {
                        System.arraycopy(met[film][c], 0, atSurfels[film][c], from, to - from);
                    }
                }
            });
            radiosity = after;
        }
        return structure.isIndirect() || structure.bounces() == 0 ? radiosity : withBackground(background, share(true));
    }

    /** Returns the share of one ray in the mean of a gather point or of a surfel. */
    private float share(boolean ofPoint) {
        return 1f / (ofPoint ? structure.pointLinks() : structure.surfelLinks()).raysPerPoint();
    }

    /**
     * Writes what consecutive surfels send in a film.
     *
     * @param met   light that their rays gather: red, green and blue
     * @param first first of the surfels
     */
    private void scatter(int film, float[][] met, FilmLight to, float share, int first) {
        int count = met[0].length;
        float[] values = to.values();
        int stride = to.stride();
        int[] dark = structure.glow().surfels();
        int firstDark = structure.surfelCount() + structure.pointLinks().misses();
        int nextDark = Arrays.binarySearch(dark, first);
        nextDark = nextDark < 0 ? -nextDark - 1 : nextDark;
        for (int c = 0; c < 3; c++) {
            float[] direct = films.get(film).direct[c];
            float[] glow = films.get(film).glow[c];
            int at = to.at(first, film) + c;
            for (int i = 0; i < count; i++) {
                float scattered = albedo[c][first + i] * (direct[first + i] + met[c][i]);
                values[at + stride * i] = (glow[first + i] + scattered) * share;
            }
            for (int d = nextDark; d < dark.length && dark[d] < first + count; d++) {
                float scattered = albedo[c][dark[d]] * (direct[dark[d]] + met[c][dark[d] - first]);
                values[to.at(firstDark + d, film) + c] = scattered * share;
            }
        }
    }

    /** Returns the values of all numbers of rays, of which only those of the background are known. @param background by film */
    private FilmLight withBackground(float[][] background, float share) {
        int surfels = structure.surfelCount();
        int misses = background[0].length / 3;
        FilmLight light = FilmLight.black(films.size(), surfels + misses + structure.glow().surfels().length);
        for (int film = 0; film < background.length; film++) {
            for (int i = 0; i < background[film].length; i++) {
                light.values()[light.at(surfels + i / 3, film) + i % 3] = background[film][i] * share;
            }
        }
        return light;
    }

    private interface Part {
        void run(int from, int to);
    }

    private void run(int count, Part part) {
        workers.run(Math.ceilDiv(count, BATCH), (_, job) -> part.run(job * BATCH, Math.min(count, job * BATCH + BATCH)), progress);
    }
}
