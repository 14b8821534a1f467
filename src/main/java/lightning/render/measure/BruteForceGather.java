package lightning.render.measure;

import java.util.Arrays;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import lightning.base.math.Ray;
import lightning.base.math.Vec3;
import lightning.render.engine.Engine;
import lightning.render.engine.choice.Engines;
import lightning.render.gather.cell.DirectionTable;
import lightning.render.shading.BackgroundLight;
import lightning.render.trace.Geometry;
import lightning.render.trace.HitRows;
import lightning.render.trace.MaterialTable;
import lightning.render.trace.NormalSteps;
import lightning.render.trace.RayBatch;
import lightning.render.trace.Tracer;
import lightning.scene.IndirectSettings;
import lightning.scene.Scene;
import org.jspecify.annotations.Nullable;

/**
 * Indirect light at single points by brute force: {@value #RAYS} cosine-distributed rays from the point, {@value #HIT_RAYS} from each hit,
 * and then one path onwards from one of these. Glow that the first rays meet is counted with {@value #GLOW_BATCHES} times as many
 * rays, because few meet a small lamp. Rays that bump maps or vertex normals send below a surface are reflected at it, as in
 * {@code RaySources}. Uses the tracer and the kernels of the picture, but no gather points, surfels or filters.
 * Holds scratch memory: use one instance per thread.
 */
final class BruteForceGather {
    static final int RAYS = 4096;
    static final int HIT_RAYS = 16;
    static final int GLOW_BATCHES = 64;
    /** Rays of a point that are traced together; their directions are stratified. */
    private static final int BATCH_RAYS = RayBatch.MAX_RAYS;
    /** Reference bounces: those of any setting. */
    static final int BOUNCES = IndirectSettings.MAX_BOUNCES;
    /** Luminance of red, green and blue (ITU-R BT.709). */
    private static final double[] LUMINANCE = {0.2126, 0.7152, 0.0722};
    private static final int HITS_PER_BATCH = RayBatch.MAX_RAYS / HIT_RAYS;

    private final Geometry geometry;
    private final boolean glows;
    private final RayBatch batch;
    private final HitShader shader;
    /** Light of rays that leave the scene. */
    private final BackgroundLight background;
    private final DirectionTable pointDirections = new DirectionTable((int) Math.sqrt(BATCH_RAYS));
    private final DirectionTable hitDirections = new DirectionTable((int) Math.sqrt(HIT_RAYS));
    private final DirectionTable pathDirections = new DirectionTable(1);
    private final GatherPaths point = new GatherPaths(1);
    private GatherPaths from = new GatherPaths(BATCH_RAYS);
    private GatherPaths to = new GatherPaths(BATCH_RAYS);
    private SplittableRandom random = new SplittableRandom(0);
    private final boolean hasEnvironment;
    /** Sum of the luminance of rays that left the scene. */
    private double sky;

    /** @param scene its indirect settings decide only whether the background counts */
    BruteForceGather(Scene scene, Geometry geometry) {
        this.geometry = geometry;
        MaterialTable materials = geometry.materials();
        glows = IntStream.range(0, materials.count()).anyMatch(m -> !materials.material(m).glow().isBlack());
        Engine engine = Engines.FASTEST.forTile(0);
        Tracer tracer = engine.tracer(geometry);
        batch = new RayBatch(geometry, scene, tracer);
        shader = new HitShader(scene, geometry, engine, tracer);
        background = BackgroundLight.of(scene);
        hasEnvironment = scene.world().hasEnvironment();
    }

    /**
     * Returns the luminance of the indirect light where a ray hits first, for one bounce, two, … {@link #BOUNCES}; null if it hits
     * nothing.
     *
     * @param ray  camera ray
     * @param seed selects the directions
     */
    double @Nullable [] luminances(Ray ray, long seed) {
        int shape = geometry.nearest(ray);
        if (shape < 0) {
            return null;
        }
        random = new SplittableRandom(seed);
        NormalSteps normals = geometry.normalSteps(shape, ray);
        point.start(geometry.surface(shape, ray), normals == null ? null : normals.geometric());
        double[] mean = new double[BOUNCES];
        for (int rays = 0; rays < RAYS; rays += BATCH_RAYS) {
            double[] light = luminances();
            for (int bounce = 0; bounce < BOUNCES; bounce++) {
                mean[bounce] += light[bounce] * BATCH_RAYS / RAYS;
            }
        }
        return mean;
    }

    /** Returns the same by {@value #BATCH_RAYS} rays from {@link #point}. */
    private double[] luminances() {
        // What the rays of each round find on surfaces, and where they leave the scene.
        double[] met = new double[BOUNCES + 1];
        double[] left = new double[BOUNCES + 1];
        to.count = 0;
        sky = 0;
        met[0] = (cast(point, 0, 1, pointDirections, false) + glow()) / BATCH_RAYS;
        left[0] = sky / BATCH_RAYS;
        swap();
        sky = 0;
        for (int first = 0; first < from.count; first += HITS_PER_BATCH) {
            met[1] += cast(from, first, Math.min(from.count, first + HITS_PER_BATCH), hitDirections, true) / BATCH_RAYS / HIT_RAYS;
        }
        left[1] = sky / BATCH_RAYS / HIT_RAYS;
        for (int round = 2; round < (hasEnvironment ? BOUNCES + 1 : BOUNCES); round++) {
            swap();
            sky = 0;
            met[round] = from.count == 0 ? 0 : cast(from, 0, from.count, pathDirections, false) / BATCH_RAYS;
            left[round] = sky / BATCH_RAYS;
        }
        double[] light = new double[BOUNCES];
        double sum = hasEnvironment ? left[0] : 0;
        for (int bounce = 0; bounce < BOUNCES; bounce++) {
            // A light reaches the surfaces that rays hit without a ray, an environment only by those of the next round.
            sum += met[bounce] + left[hasEnvironment ? bounce + 1 : bounce];
            light[bounce] = sum;
        }
        return light;
    }

    private void swap() {
        GatherPaths ended = from;
        from = to;
        to = ended;
        to.count = 0;
    }

    /**
     * Casts rays from the ends of paths and adds the paths that go on.
     *
     * @param one whether one random ray of each path goes on; otherwise all do
     * @return sum of the luminance that the rays collect from lights, and from glow unless they come from {@link #point}; that of the background
     *     is added to {@link #sky}
     */
    private double cast(GatherPaths paths, int first, int end, DirectionTable directions, boolean one) {
        int rays = directions.rays();
        int count = (end - first) * rays;
        int[] chosen = new int[end - first];
        for (int p = first; p < end; p++) {
            int at = (p - first) * rays;
            aim(paths, p, directions, at);
            chosen[p - first] = at + random.nextInt(rays);
        }
        batch.trace(count);
        HitRows rows = HitShader.rows(batch);
        shader.shade(rows);
        double sum = 0;
        for (int row = 0; row < rows.count; row++) {
            int ray = rows.parent[row];
            int path = ray / rays;
            float[] share = new float[3];
            for (int c = 0; c < 3; c++) {
                share[c] = paths.share[c][first + path] * tint(c, ray);
                float met = shader.albedo[c][ray] * shader.direct[c][ray] + (paths == point ? 0 : shader.glow[c][ray]);
                sum += LUMINANCE[c] * share[c] * met;
                share[c] *= shader.albedo[c][ray];
            }
            if (!one || chosen[path] == ray) {
                Vec3 normal = batch.hasShadingNormals(batch.primitive(ray)) ? batch.geometricNormal(ray) : null;
                to.add(rows, row, normal, share[0], share[1], share[2]);
            }
        }
        sky += background(paths, first, rays, count);
        return sum;
    }

    /** Prepares the rays of a path. */
    private void aim(GatherPaths paths, int p, DirectionTable directions, int at) {
        int end = at + directions.rays();
        directions.write(random.nextLong(), paths.ends.nx[p], paths.ends.ny[p], paths.ends.nz[p], batch.directionX, batch.directionY,
                batch.directionZ, at);
        paths.reflect(p, batch.directionX, batch.directionY, batch.directionZ, at, end);
        Arrays.fill(batch.startX, at, end, paths.ends.px[p]);
        Arrays.fill(batch.startY, at, end, paths.ends.py[p]);
        Arrays.fill(batch.startZ, at, end, paths.ends.pz[p]);
    }

    /** Returns the luminance of the glow that {@value #BATCH_RAYS} rays from the point meet on average. */
    private double glow() {
        double sum = 0;
        for (int i = 0; glows && i < GLOW_BATCHES; i++) {
            aim(point, 0, pointDirections, 0);
            batch.trace(BATCH_RAYS);
            HitRows rows = HitShader.rows(batch);
            shader.shadeUnlit(rows);
            for (int row = 0; row < rows.count; row++) {
                int ray = rows.parent[row];
                for (int c = 0; c < 3; c++) {
                    sum += LUMINANCE[c] * tint(c, ray) * shader.glow[c][ray];
                }
            }
        }
        return sum / GLOW_BATCHES;
    }

    private float tint(int channel, int ray) {
        return batch.isTinted() ? batch.tint[channel][ray] : 1;
    }

    private double background(GatherPaths paths, int first, int rays, int count) {
        double sum = 0;
        for (int ray = 0; ray < count; ray++) {
            if (batch.primitive(ray) < 0) {
                float[] light = background.from(batch.directionX[ray], batch.directionY[ray], batch.directionZ[ray]);
                for (int c = 0; c < 3; c++) {
                    sum += LUMINANCE[c] * paths.share[c][first + ray / rays] * tint(c, ray) * light[c];
                }
            }
        }
        return sum;
    }

    /** Returns the luminance of a color. */
    static double luminance(float red, float green, float blue) {
        return LUMINANCE[0] * red + LUMINANCE[1] * green + LUMINANCE[2] * blue;
    }
}
