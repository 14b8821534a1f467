package lightning.render.trace;

import java.util.Arrays;
import lightning.base.math.Ray;
import lightning.base.math.Vec3;
import lightning.render.trace.HitRows.ColumnGroup;
import lightning.render.trace.primitive.SurfaceHit;
import lightning.render.trace.primitive.TextureFootprint;
import lightning.render.trace.solid.SolidGeometry;
import lightning.scene.asset.TextureMap;

/** Surfaces where rays hit primitives, found with tests of every triangle of a mesh. */
public final class BruteForce {
    private BruteForce() {}

    /** Part of a primitive that a ray hits, and the distance. */
    private record Hit(int primitive, int part, Ray ray, double distance) {
        static Hit of(Geometry geometry, int primitive, Ray ray) {
            double distance = geometry.distance(primitive, ray);
            if (distance == SolidGeometry.MISS) {
                throw new IllegalArgumentException("the ray misses primitive " + primitive);
            }
            Vec3 o = ray.origin();
            Vec3 d = ray.direction();
            return new Hit(primitive, geometry.primitives().hitPart(primitive, o.x(), o.y(), o.z(), d.x(), d.y(), d.z()), ray, distance);
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
