package lightning.render.measure;

import java.util.Arrays;
import java.util.SplittableRandom;
import lightning.base.math.Ray;
import lightning.base.math.Vec3;
import lightning.render.engine.Engine;
import lightning.render.engine.choice.Engines;
import lightning.render.gather.cell.DirectionTable;
import lightning.render.lobe.ReflectionLobe;
import lightning.render.shading.AnisotropicHighlight;
import lightning.render.shading.BackgroundLight;
import lightning.render.shading.Bsdf;
import lightning.render.trace.Geometry;
import lightning.render.trace.HitRows;
import lightning.render.trace.NormalSteps;
import lightning.render.trace.RayBatch;
import lightning.render.trace.SurfacePoint;
import lightning.render.trace.Tracer;
import lightning.scene.Scene;
import lightning.scene.material.Material;
import org.jspecify.annotations.Nullable;

/**
 * Blurred reflections at single points by brute force: {@value #RAYS} rays of the surface's lobe, each with the direct light, the light of the
 * environment and the glow of what it meets. Uses the tracer, the lobe and the kernels of the picture, but no reflection points, surfels or filters. Holds scratch
 * memory: use one instance per thread.
 */
final class BruteForceReflection {
    static final int RAYS = 16384;
    private static final int SIDE = 128;

    private final Scene scene;
    private final Geometry geometry;
    private final RayBatch batch;
    /** Rays by which what others meet collects the light of the environment. */
    private final RayBatch gathering;
    private final DirectionTable directions = new DirectionTable(1);
    private final HitShader shader;
    private final BackgroundLight background;
    private final ReflectionLobe lobe = new ReflectionLobe();
    private final double[] colorWeight = new double[RayBatch.MAX_RAYS];
    private final double[] whiteWeight = new double[RayBatch.MAX_RAYS];

    /** @param scene without indirect light, which this does not compute */
    BruteForceReflection(Scene scene, Geometry geometry) {
        this.scene = scene;
        this.geometry = geometry;
        Engine engine = Engines.FASTEST.forTile(0);
        Tracer tracer = engine.tracer(geometry);
        batch = new RayBatch(geometry, scene, tracer, true);
        gathering = new RayBatch(geometry, scene, tracer);
        shader = new HitShader(scene, geometry, engine, tracer);
        background = BackgroundLight.of(scene);
    }

    /**
     * Returns the mean light over the lobe where a ray hits first: red, green and blue for what F0 multiplies, then for what no color
     * multiplies; null if the surface is not opaque, principled, rough and without a coat and a sheen.
     *
     * @param ray  camera ray
     * @param seed selects the directions
     */
    double @Nullable [] means(Ray ray, long seed) {
        int shape = geometry.nearest(ray);
        if (shape < 0) {
            return null;
        }
        SurfacePoint at = geometry.surface(shape, ray);
        if (!(Bsdf.of(geometry.materials().material(at.material())) instanceof Bsdf.Principled material) || material.isSmooth()
                || material.coat() != null || material.sheen() != null || material.isFrosted()) {
            return null;
        }
        NormalSteps normals = geometry.normalSteps(shape, ray);
        Vec3 normal = new Vec3(at.nx(), at.ny(), at.nz());
        Vec3 view = new Vec3(-at.vx(), -at.vy(), -at.vz());
        double cosine = Math.clamp(view.dot(normal), 1e-3, 1);
        Vec3 side = view.minus(normal.times(view.dot(normal)));
        Vec3 tangent = side.length() > 1e-6 ? side.normalized()
                : normal.cross(Math.abs(normal.y()) < 0.6 ? Vec3.Y : new Vec3(1, 0, 0)).normalized();
        Vec3 bitangent = normal.cross(tangent);
        aim(material, at, cosine, tangent, bitangent);
        var random = new SplittableRandom(seed);
        double[] sum = new double[8];
        for (int first = 0; first < RAYS; first += RayBatch.MAX_RAYS) {
            for (int i = 0; i < RayBatch.MAX_RAYS; i++) {
                int k = first + i;
                double angle = 2 * Math.PI * (k % SIDE + random.nextDouble()) / SIDE;
                lobe.reflect((k / SIDE + random.nextDouble()) / SIDE, Math.cos(angle), Math.sin(angle));
                aim(i, at, tangent.times(lobe.x()).plus(bitangent.times(lobe.y())).plus(normal.times(Math.abs(lobe.z()))),
                        normals == null ? normal : normals.geometric());
            }
            add(sum, random);
        }
        for (int c = 0; c < 6; c++) {
            sum[c] /= sum[6 + c / 3];
        }
        return Arrays.copyOf(sum, 6);
    }

    /** Sets the lobe in the frame of the view. */
    private void aim(Bsdf.Principled material, SurfacePoint at, double cosine, Vec3 tangent, Vec3 bitangent) {
        double alpha = Material.alpha(at.roughness());
        AnisotropicHighlight highlight = material.highlight();
        if (highlight == null) {
            lobe.aim(cosine, alpha);
            return;
        }
        float[] t = at.tangent();
        Vec3 along = new Vec3(t[0], t[1], t[2]);
        Vec3 turned = along.times(highlight.cos()).plus(new Vec3(at.nx(), at.ny(), at.nz()).cross(along).times(highlight.sin()));
        double x = turned.dot(tangent);
        double y = turned.dot(bitangent);
        double length = Math.sqrt(x * x + y * y);
        lobe.aim(cosine, highlight.anisotropy().along(alpha), highlight.anisotropy().across(alpha), x / length, y / length);
    }

    private void aim(int i, SurfacePoint at, Vec3 direction, Vec3 geometric) {
        double height = direction.dot(geometric);
        Vec3 above = height < 0 ? direction.minus(geometric.times(2 * height)) : direction;
        batch.startX[i] = at.px();
        batch.startY[i] = at.py();
        batch.startZ[i] = at.pz();
        batch.directionX[i] = above.x();
        batch.directionY[i] = above.y();
        batch.directionZ[i] = above.z();
        colorWeight[i] = lobe.weight() * (1 - lobe.schlick());
        whiteWeight[i] = lobe.weight() * lobe.schlick();
    }

    /** Traces the rays of the batch and adds their weighted light, then the weights. */
    private void add(double[] sum, SplittableRandom random) {
        batch.trace(RayBatch.MAX_RAYS);
        HitRows rows = HitShader.rows(batch);
        shader.shade(rows);
        gatherSky(rows, random);
        for (int ray = 0; ray < RayBatch.MAX_RAYS; ray++) {
            float[] sky = batch.primitive(ray) >= 0 ? null : sky(ray);
            for (int c = 0; c < 3; c++) {
                double tint = batch.isTinted() ? batch.tint[c][ray] : 1;
                double light = tint * (sky != null ? sky[c] : shader.seen[c][ray]);
                sum[c] += colorWeight[ray] * light;
                sum[3 + c] += whiteWeight[ray] * light;
            }
            sum[6] += colorWeight[ray];
            sum[7] += whiteWeight[ray];
        }
    }

    /** Adds the light of the environment that rays meet to what they see there, by one random ray of each. */
    private void gatherSky(HitRows rows, SplittableRandom random) {
        if (!scene.world().hasEnvironment()) {
            return;
        }
        for (int row = 0; row < rows.count; row++) {
            gathering.startX[row] = rows.px[row];
            gathering.startY[row] = rows.py[row];
            gathering.startZ[row] = rows.pz[row];
            directions.write(random.nextLong(), rows.nx[row], rows.ny[row], rows.nz[row], gathering.directionX, gathering.directionY,
                    gathering.directionZ, row);
        }
        gathering.trace(rows.count);
        for (int row = 0; row < rows.count; row++) {
            if (gathering.primitive(row) < 0) {
                float[] light = background.from(gathering.directionX[row], gathering.directionY[row], gathering.directionZ[row]);
                for (int c = 0; c < 3; c++) {
                    int ray = rows.parent[row];
                    shader.seen[c][ray] += shader.albedo[c][ray] * light[c] * (gathering.isTinted() ? gathering.tint[c][row] : 1);
                }
            }
        }
    }

    private float[] sky(int ray) {
        return scene.world().hasEnvironment()
                ? background.from(batch.directionX[ray], batch.directionY[ray], batch.directionZ[ray])
                : new float[] {(float) background.seen().r(), (float) background.seen().g(), (float) background.seen().b()};
    }
}
