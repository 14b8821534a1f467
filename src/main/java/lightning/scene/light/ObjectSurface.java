package lightning.scene.light;

import java.util.List;
import java.util.Optional;
import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.scene.asset.TextureMap;
import lightning.scene.node.Solid;
import org.jspecify.annotations.Nullable;

/**
 * Surface of a shape that is a light, in the scene. The unit square maps to it by area: the first coordinate chooses a strip and the place
 * across it, the second the place along the strip. The strips of a canonical solid are rings of its parts; a mesh has one strip, of
 * its triangles in the order of {@link MeshSides}.
 *
 * <p>A part of a closed surface shines to its outer side. The surface is closed if it is a sphere, has caps, or is a connected part of a mesh in
 * which each edge has a triangle on either side. Other parts shine to both sides.
 *
 * <p>Immutable. Two are equal if they are the same solid at the same place with the same image.
 */
public final class ObjectSurface {
    private final Solid solid;
    private final Transform toScene;
    private final Optional<TextureMap> glowMap;
    private final List<Strip> strips;
    /** Areas of the strips. */
    private final AreaSums areas;
    private final double emittingArea;
    /** Middle relative to the origin of the solid. */
    private final Vec3 center;

    /**
     * Point of the surface.
     *
     * @param position relative to the origin that it was asked for
     * @param normal   unit vector, to the outer side of a closed surface
     * @param u        texture coordinate
     * @param v        texture coordinate, upwards
     * @param bothSides whether it shines to both sides
     */
    public record Point(Vec3 position, Vec3 normal, double u, double v, boolean bothSides) {}

    /** Part of a surface that is as wide in one parameter as it is long in the other. */
    interface Strip {
        /** Returns the area, square scene units. */
        double area();

        /** Returns the area of its sides that shine, square scene units. */
        double emittingArea();

        /** Returns a point by its share of the area across the strip and along it, relative to the origin of the solid. */
        Point point(double across, double along);
    }

    /**
     * @param toScene map from the solid to the scene
     * @param glowMap image that multiplies its light; empty for none
     * @param known   surface whose analysis of the same mesh is used; null if there is none
     */
    public ObjectSurface(Solid solid, Transform toScene, Optional<TextureMap> glowMap, @Nullable ObjectSurface known) {
        this.solid = solid;
        this.toScene = toScene;
        this.glowMap = glowMap;
        Transform turned = toScene.linearPart();
        strips = switch (solid) {
            case Solid.Canonical canonical -> CanonicalSurface.strips(canonical, turned);
            case Solid.TriangleMesh mesh -> List.of(new MeshSurface(mesh.mesh(), turned, sides(mesh, known)));
        };
        double[] sums = new double[strips.size()];
        double sum = 0;
        double emitting = 0;
        for (int i = 0; i < sums.length; i++) {
            sum += strips.get(i).area();
            emitting += strips.get(i).emittingArea();
            sums[i] = sum;
        }
        areas = new AreaSums(sums);
        emittingArea = emitting;
        center = center();
    }

    private static MeshSides sides(Solid.TriangleMesh mesh, @Nullable ObjectSurface known) {
        return known != null && known.strips.getFirst() instanceof MeshSurface s && s.mesh() == mesh.mesh() ? s.sides()
                : MeshSides.of(mesh.mesh());
    }

    private Vec3 center() {
        int steps = 16;
        int count = area() > 0 ? steps * steps : 0;
        Vec3 sum = Vec3.ZERO;
        for (int i = 0; i < count; i++) {
            sum = sum.plus(pointOfStrip((i / steps + 0.5) / steps, (i % steps + 0.5) / steps).position().times(1.0 / count));
        }
        return sum;
    }

    /** Returns the area, square scene units; 0 if nothing can shine. */
    public double area() {
        double sum = areas.total();
        return sum > 0 && sum < Double.POSITIVE_INFINITY ? sum : 0;
    }

    /** Returns the area of all sides that shine: of a part that shines to both sides twice its area; square scene units. */
    public double emittingArea() {
        return emittingArea;
    }

    /**
     * Returns a point in its middle, relative to an origin. The origin is subtracted from the place of the solid first, so that nothing is lost far
     * from the origin of the scene.
     */
    public Vec3 middle(Vec3 origin) {
        return center.plus(place(origin));
    }

    private Vec3 place(Vec3 origin) {
        return new Vec3(toScene.t0(), toScene.t1(), toScene.t2()).minus(origin);
    }

    public Optional<TextureMap> glowMap() {
        return glowMap;
    }

    /**
     * Returns a point of a surface with an area, relative to an origin as {@link #middle}.
     *
     * @param a 0 … below 1
     * @param b 0 … below 1
     */
    public Point point(double a, double b, Vec3 origin) {
        Point point = pointOfStrip(a, b);
        return new Point(point.position().plus(place(origin)), point.normal(), point.u(), point.v(), point.bothSides());
    }

    private Point pointOfStrip(double a, double b) {
        AreaSums.Place strip = areas.at(a);
        return strips.get(strip.index()).point(Math.min(strip.share(), Math.nextDown(1.0)), b);
    }

    /** Returns whether it is the surface of this solid at a place. */
    public boolean isOf(Solid other, Transform place, Optional<TextureMap> image) {
        return (solid == other || solid.equals(other)) && toScene.equals(place) && glowMap.equals(image);
    }

    @Override
    public boolean equals(@Nullable Object o) {
        return this == o || o instanceof ObjectSurface s && s.isOf(solid, toScene, glowMap);
    }

    @Override
    public int hashCode() {
        return toScene.hashCode();
    }
}
