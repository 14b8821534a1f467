package lightning.render.trace;

import java.util.Arrays;
import java.util.stream.IntStream;
import lightning.base.math.Ray;
import lightning.base.math.Vec3;
import lightning.render.trace.HitRows.ColumnGroup;
import lightning.render.trace.mesh.MeshRayQuery;
import lightning.render.trace.primitive.SurfaceHit;
import lightning.render.trace.primitive.TextureFootprint;
import lightning.render.trace.solid.SolidGeometry;
import lightning.render.trace.tree.ShadowRayTarget;
import lightning.scene.asset.TextureMap;

/** Finds the surfaces that rays hit; tests every primitive and every triangle of a mesh. */
public final class BruteForce {
    private BruteForce() {}

    /** Returns the index of the primitive that a ray hits first, or −1. */
    public static int nearest(Geometry geometry, Ray ray) {
        int nearest = -1;
        double minDistance = SolidGeometry.MISS;
        for (int s = 0; s < geometry.primitives().count; s++) {
            double t = geometry.isSeen(s) ? geometry.distance(s, ray) : SolidGeometry.MISS;
            if (t < minDistance) {
                minDistance = t;
                nearest = s;
            }
        }
        return nearest;
    }

    /** Returns whether a ray hits any shadow-casting primitive at a distance below {@code limit}. */
    public static boolean isBlocked(Geometry geometry, Ray ray, double limit) {
        return IntStream.range(0, geometry.primitives().count)
                .anyMatch(s -> geometry.isShadowCaster(s) && geometry.distance(s, ray) < limit);
    }

    /** Returns whether any shadow-casting primitive is between a point and a light, both in render space. */
    public static boolean isBlocked(Geometry geometry, Vec3 point, ShadowRayTarget target) {
        Ray shadowRay = new Ray(point, target.point().minus(point));
        return IntStream.range(0, geometry.primitives().count)
                .anyMatch(s -> geometry.isShadowCaster(s) && geometry.distance(s, shadowRay, target) < 1);
    }

    /** Returns the target of shadow rays to a light at a point in render space. */
    public static ShadowRayTarget shadowRayTarget(Geometry geometry, Vec3 point) {
        return ShadowRayTarget.findBruteForce(point, geometry.all);
    }

    /** Part of a primitive that a ray hits, and the distance. */
    private record Hit(int primitive, int part, Ray ray, double distance) {
        static Hit of(Geometry geometry, int primitive, Ray ray) {
            double distance = geometry.distance(primitive, ray);
            if (distance == SolidGeometry.MISS) {
                throw new IllegalArgumentException("the ray misses primitive " + primitive);
            }
            return new Hit(primitive, geometry.primitives().mesh(primitive) == null ? 0 : triangle(geometry, primitive, ray), ray,
                    distance);
        }

        private static int triangle(Geometry geometry, int primitive, Ray ray) {
            Vec3 o = ray.origin();
            Vec3 d = ray.direction();
            var query = new MeshRayQuery();
            geometry.primitives().setProbeRay(query, primitive, o.x(), o.y(), o.z(), d.x(), d.y(), d.z());
            query.nearestBruteForce();
            return query.triangle();
        }

        SurfaceHit surface(Geometry geometry) {
            return builder(geometry).hit(primitive, part, ray, distance);
        }
    }

    private static SurfacePointBuilder builder(Geometry geometry) {
        return new SurfacePointBuilder(geometry.primitives(), geometry.materials());
    }

    /** Computes the surface point where a ray hits a primitive. */
    public static SurfacePoint surface(Geometry geometry, int primitive, Ray ray) {
        return point(geometry, primitive, ray, true);
    }

    /** Returns the same on the facet of a mesh: vertex normals do not lift it. */
    public static SurfacePoint facet(Geometry geometry, int primitive, Ray ray) {
        return point(geometry, primitive, ray, false);
    }

    private static SurfacePoint point(Geometry geometry, int primitive, Ray ray, boolean lifts) {
        Hit hit = Hit.of(geometry, primitive, ray);
        return builder(geometry).surfacePoint(primitive, hit.part, ray, hit.distance, lifts);
    }

    /** Returns the start of a ray that passes a primitive which it hits, behind the surface. */
    public static Vec3 pointBehind(Geometry geometry, int primitive, Ray ray) {
        SurfaceHit surface = Hit.of(geometry, primitive, ray).surface(geometry);
        surface.computeBackPoint();
        return new Vec3(surface.backX, surface.backY, surface.backZ);
    }

    /**
     * Returns the mean texture color of a square around a ray's hit: red, green, blue, 1 without a texture.
     *
     * @param side of the square, scene units
     */
    public static float[] meanTexel(Geometry geometry, int primitive, Ray ray, double side) {
        Hit hit = Hit.of(geometry, primitive, ray);
        SurfaceHit surface = hit.surface(geometry);
        int material = geometry.primitives().material[primitive];
        float[] texel = {1, 1, 1};
        if (geometry.materials().isTextured(material)) {
            new TextureFootprint().lookUp(geometry.primitives(), primitive, hit.part, geometry.materials().texture(material),
                    surface.localX, surface.localY, surface.localZ, surface.nx, surface.ny, surface.nz, side, texel);
        }
        return texel;
    }

    /**
     * Returns the mean of a map in a square around a ray's hit, as {@link SurfacePoint#maps}; null without a map.
     *
     * @param group columns of the map
     * @param side of the square, scene units
     */
    public static float[] meanMapTexel(Geometry geometry, ColumnGroup group, int primitive, Ray ray, double side) {
        int material = geometry.primitives().material[primitive];
        TextureMap map = geometry.materials().map(group, material);
        if (map == null) {
            return null;
        }
        Hit hit = Hit.of(geometry, primitive, ray);
        SurfaceHit surface = hit.surface(geometry);
        float[] texel = new float[3];
        new TextureFootprint().lookUpMap(geometry.primitives(), primitive, hit.part, map, surface.localX, surface.localY, surface.localZ,
                surface.nx, surface.ny, surface.nz, side, texel);
        int first = group.firstChannel(geometry.materials().material(material));
        return Arrays.copyOfRange(texel, first, first + group.columnCount());
    }
}
