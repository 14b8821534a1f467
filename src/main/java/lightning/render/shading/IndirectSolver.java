package lightning.render.shading;

import java.util.Arrays;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.gather.GatherStructure;
import lightning.render.gather.cell.SkyCells;
import lightning.render.gather.glow.GlowPaths;
import lightning.render.gather.glow.GlowShapes;
import lightning.render.gather.ray.RayLinks;
import lightning.render.gather.reflection.ReflectionPaths;
import lightning.render.gather.rim.RimLinks;

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
 * of the rays. Each film is gathered by itself, with the lights of its contribution.
 */
public final class IndirectSolver {
    private static final int BATCH = 512;
    /** Values of a surfel or point in a row: red, green, blue and one unused, so that they share a cache line. */
    private static final int STRIDE = 4;

    private final GatherStructure structure;
    private final WorkerPool workers;
    private final Progress progress;

    public IndirectSolver(GatherStructure structure, WorkerPool workers, Progress progress) {
        this.structure = structure;
        this.workers = workers;
        this.progress = progress.cancellationOnly();
    }

    /**
     * Returns the light at all gather points: red, green, blue. If the paths contain reflections, six columns follow with the light at
     * reflection points: red, green and blue of what the reflectance multiplies, and the same of what no color multiplies.
     *
     * @param direct lights' diffuse sum at each surfel
     * @param albedo of each surfel
     * @param glow   light that each surfel emits itself
     * @param objects light of each glowing object, as {@link GlowShapes#glow}
     * @param seen   light of each surfel that a picture shows, without the light that it gathers; read by reflections only
     * @param background light of rays that leave the scene
     * @throws java.util.concurrent.CancellationException if the progress requested cancellation
     */
    public float[][] solve(float[][] direct, float[][] albedo, float[][] glow, float[][] objects, float[][] seen,
            BackgroundLight background) {
        ReflectionPaths reflections = structure.reflections();
        float[][] atSurfels = new float[3][reflections == null ? 0 : structure.surfelCount()];
        float[] radiosity = radiosity(direct, albedo, glow, objects, background.cells(structure.pointLinks().misses()), atSurfels);
        GlowPaths glowPaths = structure.glow();
        RayLinks links = structure.pointLinks();
        int points = structure.pointCount();
        float[] gathered = new float[STRIDE * points];
        float[][] light = new float[reflections == null ? 3 : 9][points];
        run(points, (from, to) -> {
            float[] mean = new float[3];
            for (int p = from; p < to; p++) {
                links.sum(p, radiosity, mean);
                structure.rims().add(p, links, radiosity, mean);
                glowPaths.ofPoints().add(p, objects, mean);
                System.arraycopy(mean, 0, gathered, STRIDE * p, 3);
            }
        });
        run(points, (from, to) -> structure.filter(gathered, light, from, to));
        if (reflections != null) {
            reflect(reflections, albedo, seen, atSurfels, background, light);
        }
        return light;
    }

    /** Returns the light that surfels gather, without the noise of their few rays. */
    private float[][] smooth(ReflectionPaths paths, float[][] atSurfels) {
        int gathering = paths.gatheringSurfels();
        float[] noisy = new float[STRIDE * gathering];
        for (int i = 0; i < gathering; i++) {
            for (int c = 0; c < 3; c++) {
                noisy[STRIDE * i + c] = atSurfels[c][i];
            }
        }
        float[][] smooth = {atSurfels[0].clone(), atSurfels[1].clone(), atSurfels[2].clone()};
        run(gathering, (from, to) -> paths.filterSurfels(noisy, smooth, from, to));
        return smooth;
    }

    /**
     * Writes the light at reflection points: what a picture would show of the surfels, and the sky.
     *
     * @param atSurfels light that the rays of surfels gather
     */
    private void reflect(ReflectionPaths paths, float[][] albedo, float[][] seen, float[][] atSurfels,
            BackgroundLight background, float[][] light) {
        int surfels = structure.surfelCount();
        int[] details = paths.surfelOfDetail();
        int whole = surfels - details.length;
        float[] shown = new float[STRIDE * (surfels + SkyCells.COUNT)];
        float[][] smooth = smooth(paths, atSurfels);
        run(surfels, (from, to) -> {
            for (int s = from; s < to; s++) {
                int gathering = s < whole ? s : details[s - whole];
                for (int c = 0; c < 3; c++) {
                    shown[STRIDE * s + c] = seen[c][s] + albedo[c][s] * smooth[c][gathering];
                }
            }
        });
        background.writeSky(shown, STRIDE * surfels, STRIDE);
        int sources = paths.links().points();
        float[] color = new float[STRIDE * sources];
        float[] white = new float[STRIDE * sources];
        run(sources, (from, to) -> {
            float[] one = new float[3];
            float[] other = new float[3];
            for (int p = from; p < to; p++) {
                paths.links().mean(p, shown, one, other);
                System.arraycopy(one, 0, color, STRIDE * p, 3);
                System.arraycopy(other, 0, white, STRIDE * p, 3);
            }
        });
        int points = paths.count();
        for (int c = 3; c < light.length; c++) {
            light[c] = new float[points];
        }
        run(points, (from, to) -> {
            paths.filter(color, Arrays.copyOfRange(light, 3, 6), from, to);
            paths.filter(white, Arrays.copyOfRange(light, 6, 9), from, to);
        });
    }

    /**
     * Returns what each ray of a point that hits a surfel adds to the mean; after the last surfel the same for the background or its cells,
     * then for the surfels on glowing objects without their glow.
     *
     * @param background red, green and blue of each number of rays that leave the scene
     * @param atSurfels  receives the light that the rays of surfels gather; empty if it is not needed
     */
    private float[] radiosity(float[][] direct, float[][] albedo, float[][] glow, float[][] objects, float[] background,
            float[][] atSurfels) {
        int surfels = structure.surfelCount();
        RayLinks links = structure.surfelLinks();
        int linked = links.points();
        int[] dark = structure.glow().surfels();
        int misses = background.length / 3;
        float first = 1f / (structure.bounces() == 0 ? structure.pointLinks() : links).raysPerPoint();
        float[] radiosity = withBackground(background, first, surfels, dark.length);
        for (int bounce = 1; bounce <= structure.bounces(); bounce++) {
            float[] before = bounce == 1 && misses == 1 ? null : radiosity;
            boolean hasGlow = bounce > 1;
            // Shares of the mean are added, because sums of the brightest light overflow.
            float share = 1f / (bounce < structure.bounces() ? links : structure.pointLinks()).raysPerPoint();
            float[] after = withBackground(background, share, surfels, dark.length);
            run(surfels, (from, to) -> {
                float[] gathered = new float[3];
                for (int s = from; s < to; s++) {
                    if (before != null && s < linked) {
                        links.sum(s, before, gathered);
                        if (hasGlow) {
                            structure.glow().ofSurfels().add(s, objects, gathered);
                        }
                    } else {
                        Arrays.fill(gathered, 0);
                    }
                    int twin = Arrays.binarySearch(dark, s);
                    for (int c = 0; c < 3; c++) {
                        if (atSurfels[c].length > 0) {
                            atSurfels[c][s] = gathered[c];
                        }
                        float scattered = albedo[c][s] * (direct[c][s] + gathered[c]);
                        after[STRIDE * s + c] = (glow[c][s] + scattered) * share;
                        if (twin >= 0) {
                            after[STRIDE * (surfels + misses + twin) + c] = scattered * share;
                        }
                    }
                }
            });
            radiosity = after;
        }
        if (!structure.isIndirect() && structure.bounces() > 0) {
            return withBackground(background, 1f / structure.pointLinks().raysPerPoint(), surfels, dark.length);
        }
        return radiosity;
    }

    /** Returns the values of all numbers of rays, of which only those of the background are known. */
    private static float[] withBackground(float[] background, float share, int surfels, int dark) {
        int misses = background.length / 3;
        float[] values = new float[STRIDE * (surfels + misses + dark)];
        for (int i = 0; i < background.length; i++) {
            values[STRIDE * (surfels + i / 3) + i % 3] = background[i] * share;
        }
        return values;
    }

    private interface Part {
        void run(int from, int to);
    }

    private void run(int count, Part part) {
        workers.run(Math.ceilDiv(count, BATCH), (_, job) -> part.run(job * BATCH, Math.min(count, job * BATCH + BATCH)), progress);
    }
}
