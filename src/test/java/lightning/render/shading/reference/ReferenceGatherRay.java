package lightning.render.shading.reference;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import lightning.base.math.Ray;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.render.gather.cell.CellKeys;
import lightning.render.gather.cell.DirectionTable;
import lightning.render.gather.glow.GlowShapes;
import lightning.render.trace.BruteForce;
import lightning.render.trace.Geometry;
import lightning.render.trace.HitRows.ColumnGroup;
import lightning.render.trace.MaterialTable;
import lightning.render.trace.NormalSteps;
import lightning.render.trace.RayBatch;
import lightning.render.trace.Refraction;
import lightning.render.trace.SurfacePoint;
import lightning.scene.material.Transmission;

/**
 * Ray by which a point gathers light, for {@link ReferenceTracer}.
 *
 * @param hit    first surface that is neither transparent nor the face of a light; null for none, and {@link #withoutSurface}
 * @param direction of length 1
 * @param length distance to it, in lengths of the direction; infinite if the ray leaves the scene
 * @param cell   cell of surfels that the ray hits; undefined for none
 * @param rank   order among the rays that hit the cell
 * @param tint   product of the tints of the transparent surfaces in between: red, green, blue
 * @param texel  mean texture color of the cell: red, green, blue; null for none
 * @param maps   means of the material's other images in the cell, as in {@link SurfacePoint#maps}
 * @param dark   whether the ray does not count the glow of what it hits, because other rays are aimed at it
 */
record ReferenceGatherRay(SurfacePoint hit, Vec3 direction, double length, long cell, int rank, float[] tint, float[] texel,
        Map<ColumnGroup, float[]> maps, boolean dark) {
    // Arrays in a record: written once by their creator, never after.

    /** Casts the rays of a point, in directions of {@link DirectionTable#write}. */
    static List<ReferenceGatherRay> cast(Geometry geometry, CellKeys keys, GlowShapes glows, DirectionTable directions, long seed,
            int turn, SurfacePoint from) {
        double[] x = new double[directions.rays()];
        double[] y = new double[directions.rays()];
        double[] z = new double[directions.rays()];
        directions.write(seed, turn, from.nx(), from.ny(), from.nz(), x, y, z, 0);
        Facet facet = Facet.under(geometry, from);
        List<ReferenceGatherRay> rays = new ArrayList<>();
        for (int k = 0; k < directions.rays(); k++) {
            ReferenceGatherRay ray = cast(geometry, keys, CellKeys.rank(seed, from.px(), from.py(), from.pz(), k),
                    new Ray(facet.start, aboveSurface(facet.normal, new Vec3(x[k], y[k], z[k]))));
            rays.add(ray.hit != null && glows.isAimed(ray.hit.primitive(), from.px(), from.py(), from.pz()) ? ray.darkened() : ray);
        }
        return rays;
    }

    private static Map<ColumnGroup, float[]> meanMaps(Geometry geometry, int primitive, Ray ray, double side) {
        Map<ColumnGroup, float[]> means = new EnumMap<>(ColumnGroup.class);
        for (ColumnGroup group : ColumnGroup.TEXELS) {
            float[] mean = group == ColumnGroup.TEXEL || group == ColumnGroup.COAT_NORMAL ? null
                    : BruteForce.meanMapTexel(geometry, group, primitive, ray, side);
            if (mean != null) {
                means.put(group, mean);
            }
        }
        return means;
    }

    /** Returns true if the ray leaves the scene. */
    boolean isMiss() {
        return length == Double.POSITIVE_INFINITY;
    }

    /** Returns the ray with no more than what its light depends on. */
    ReferenceGatherRay withoutSurface() {
        return new ReferenceGatherRay(null, direction, length, cell, rank, tint, null, Map.of(), dark);
    }

    private ReferenceGatherRay darkened() {
        return new ReferenceGatherRay(hit, direction, length, cell, rank, tint, texel, maps, true);
    }

    /**
     * Surface under a point, at which its rays start.
     *
     * @param normal of the surface; null if the point is shaded by this normal
     */
    record Facet(Vec3 normal, Vec3 start) {
        /** Finds the surface, of the point's own primitive, behind at most three others. */
        static Facet under(Geometry geometry, SurfacePoint from) {
            Vec3 at = new Vec3(from.px(), from.py(), from.pz());
            Ray down = new Ray(at, new Vec3(-from.nx(), -from.ny(), -from.nz()));
            for (int passed = 0; passed <= 3; passed++) {
                int primitive = BruteForce.nearest(geometry, down);
                if (primitive == from.primitive()) {
                    NormalSteps steps = geometry.normalSteps(primitive, down);
                    return steps == null ? new Facet(null, at)
                            : new Facet(rounded(steps.geometric()), start(BruteForce.facet(geometry, primitive, down)));
                }
                if (primitive < 0) {
                    break;
                }
                down = new Ray(BruteForce.pointBehind(geometry, primitive, down), down.direction());
            }
            return new Facet(null, at);
        }

        private static Vec3 rounded(Vec3 v) {
            return new Vec3((float) v.x(), (float) v.y(), (float) v.z());
        }

        private static Vec3 start(SurfacePoint at) {
            return new Vec3(at.px(), at.py(), at.pz());
        }
    }

    /** Returns a direction, or its mirror image above the plane of a surface. */
    private static Vec3 aboveSurface(Vec3 normal, Vec3 direction) {
        if (normal == null) {
            return direction;
        }
        double twice = 2 * Math.min(0, direction.x() * normal.x() + direction.y() * normal.y() + direction.z() * normal.z());
        return new Vec3(direction.x() - twice * normal.x(), direction.y() - twice * normal.y(), direction.z() - twice * normal.z());
    }

    static ReferenceGatherRay cast(Geometry geometry, CellKeys keys, int rank, Ray first) {
        float[] tint = {1, 1, 1};
        double passed = 0;
        Ray ray = first;
        for (int surfaces = 0;; surfaces++) {
            int primitive = BruteForce.nearest(geometry, ray);
            if (primitive < 0) {
                return miss(ray, rank, tint);
            }
            SurfacePoint hit = BruteForce.facet(geometry, primitive, ray);
            double distance = geometry.distance(primitive, ray);
            boolean isFace = geometry.isLightFace(primitive);
            if (hit.backSide() == null && !isFace) {
                double length = passed + distance;
                double side = keys.surfelSide(hit.px(), hit.py(), hit.pz(), length);
                return new ReferenceGatherRay(hit, ray.direction(), length,
                        keys.surfelKey(hit.px(), hit.py(), hit.pz(), hit.nx(), hit.ny(), hit.nz(), primitive, length), rank, tint,
                        BruteForce.meanTexel(geometry, primitive, ray, side),
                        meanMaps(geometry, primitive, ray, side), false);
            }
            if (surfaces == RayBatch.MAX_SURFACES) {
                return miss(ray, rank, new float[3]);
            }
            if (!isFace) {
                multiply(tint, geometry.materials(), hit);
            }
            passed += distance;
            ray = new Ray(BruteForce.pointBehind(geometry, primitive, ray), ray.direction());
        }
    }

    private static ReferenceGatherRay miss(Ray ray, int rank, float[] tint) {
        return new ReferenceGatherRay(null, ray.direction(), Double.POSITIVE_INFINITY, 0, rank, tint, null, Map.of(), false);
    }

    /** Multiplies a tint by the transmittance of a surface, by the angle from outside. */
    private static void multiply(float[] tint, MaterialTable materials, SurfacePoint hit) {
        Transmission transmission = hit.backSide().transmission();
        float reflectance =
                Refraction.fresnelReflectance(transmission, false, hit.nx(), hit.ny(), hit.nz(), hit.vx(), hit.vy(), hit.vz());
        for (int c = 0; c < 3; c++) {
            tint[c] *= materials.transmitted(hit.material(), reflectance, c);
        }
        if (hit.backSide().isInside()) {
            multiply(tint, transmission.tint(), hit.backSide().insideDistance() / transmission.tintDistance());
        }
    }

    private static void multiply(float[] tint, Rgb color, double power) {
        tint[0] *= (float) StrictMath.pow(color.r(), power);
        tint[1] *= (float) StrictMath.pow(color.g(), power);
        tint[2] *= (float) StrictMath.pow(color.b(), power);
    }

    /**
     * Returns the harmonic mean length of a point's rays; {@code +∞} if none hits a surface. Each inverse length is rounded down to a
     * multiple of 2⁻³⁰ per unit, and is at most 2¹⁶ per unit.
     *
     * @param unit length, scene units
     */
    static float harmonicMean(List<ReferenceGatherRay> rays, double unit) {
        long sum = 0;
        for (ReferenceGatherRay ray : rays) {
            double inverse = ray.hit == null ? 0 : Math.scalb(unit, 30) / ray.length;
            sum += inverse > 1L << 46 ? 1L << 46 : (long) inverse;
        }
        return (float) (Math.scalb(unit, 30) * rays.size() / sum);
    }
}
