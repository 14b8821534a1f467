package lightning.render.shading.reference;

import java.util.ArrayList;
import java.util.List;
import lightning.base.math.Ray;
import lightning.base.math.Vec3;
import lightning.render.gather.cell.CellKeys;
import lightning.render.gather.glow.GlowAim;
import lightning.render.gather.glow.GlowShapes;
import lightning.render.trace.Geometry;
import lightning.render.trace.SurfacePoint;

/** Light of small glowing objects at points that gather light, for {@link ReferenceTracer}. */
final class ReferenceGlow {
    private final Geometry geometry;
    private final CellKeys keys;
    private final GlowShapes glows;
    private final GlowAim aim;
    private final float[][] colors;

    /** @param rays number of the cosine-distributed rays of a point */
    ReferenceGlow(Geometry geometry, CellKeys keys, GlowShapes glows, int rays) {
        this.geometry = geometry;
        this.keys = keys;
        this.glows = glows;
        aim = new GlowAim(glows, rays);
        colors = glows.glow(geometry.materials());
    }

    /**
     * Returns the light of each object that a point sees: red, green, blue.
     *
     * @param seed of the point's directions
     */
    List<float[]> at(SurfacePoint point, long seed) {
        ReferenceGatherRay.Facet facet = ReferenceGatherRay.Facet.under(geometry, point);
        List<float[]> light = new ArrayList<>();
        for (int shape = 0; shape < glows.count(); shape++) {
            float[] share = new float[3];
            for (int k = 0; k < aim.rays(shape, seed, point.px(), point.py(), point.pz()); k++) {
                double[] d = new double[3];
                double angle = aim.aim(shape, k, seed, point.px(), point.py(), point.pz(), d);
                Vec3 direction = new Vec3(d[0], d[1], d[2]);
                addTo(share, shape, new Ray(facet.start(), direction), (float) (angle * density(point, facet.normal(), direction)));
            }
            light.add(new float[] {share[0] * colors[0][shape], share[1] * colors[1][shape], share[2] * colors[2][shape]});
        }
        return light;
    }

    private void addTo(float[] share, int shape, Ray ray, float weight) {
        ReferenceGatherRay met = ReferenceGatherRay.cast(geometry, keys, 0, ray);
        for (int c = 0; c < 3 && met.hit() != null && met.hit().primitive() == glows.primitive(shape); c++) {
            share[c] += weight * met.tint()[c];
        }
    }

    /** Returns the density of the point's cosine-distributed directions, in units of 1/π per steradian. */
    private static double density(SurfacePoint point, Vec3 surface, Vec3 direction) {
        double cosine = cosine(point, direction);
        if (surface == null) {
            return cosine;
        }
        double height = dot(direction, surface);
        Vec3 below = new Vec3(direction.x() - 2 * height * surface.x(), direction.y() - 2 * height * surface.y(),
                direction.z() - 2 * height * surface.z());
        return height > 0 ? cosine + cosine(point, below) : 0;
    }

    private static double cosine(SurfacePoint point, Vec3 direction) {
        return Math.max(0, dot(direction, new Vec3(point.nx(), point.ny(), point.nz())));
    }

    private static double dot(Vec3 a, Vec3 b) {
        return a.x() * b.x() + a.y() * b.y() + a.z() * b.z();
    }
}
