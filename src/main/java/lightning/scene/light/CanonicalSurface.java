package lightning.scene.light;

import java.util.ArrayList;
import java.util.List;
import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.scene.node.Solid;

/** Rings of the surface of a canonical solid, in the scene. */
final class CanonicalSurface {
    private static final int RINGS = 64;
    private static final int CELLS = 64;
    /** Step of the differences that give a normal. */
    private static final double STEP = 1e-4;

    private CanonicalSurface() {}

    /** Part of a solid's surface. */
    private record Patch(Points points, Coordinates coordinates) {
        /** Returns a point in the solid's coordinates. */
        Vec3 point(double a, double b) {
            return points.at(a, b);
        }
    }

    /** Points of a patch as a function of the unit square. */
    private interface Points {
        Vec3 at(double a, double b);
    }

    /** Texture coordinates of points: u, v. */
    private interface Coordinates {
        double[] of(Vec3 point);
    }

    /** Ring of a patch: the first parameter between two values. @param cells areas of cells along it */
    private record Ring(Patch patch, Transform toScene, double from, double to, boolean bothSides, Vec3 inside, AreaSums cells)
            implements ObjectSurface.Strip {
        static Ring of(Patch patch, Transform toScene, double from, double to, boolean bothSides, Vec3 inside) {
            double[] area = new double[CELLS];
            double sum = 0;
            for (int i = 0; i < CELLS; i++) {
                Vec3 first = toScene.transformPoint(patch.point(from, i / (double) CELLS));
                Vec3 second = toScene.transformPoint(patch.point(to, i / (double) CELLS));
                Vec3 third = toScene.transformPoint(patch.point(to, (i + 1) / (double) CELLS));
                Vec3 fourth = toScene.transformPoint(patch.point(from, (i + 1) / (double) CELLS));
                sum += 0.5 * (third.minus(first).cross(fourth.minus(second)).length());
                area[i] = sum;
            }
            return new Ring(patch, toScene, from, to, bothSides, inside, new AreaSums(area));
        }

        @Override
        public double area() {
            return cells.total();
        }

        @Override
        public double emittingArea() {
            return bothSides ? 2 * area() : area();
        }

        @Override
        public ObjectSurface.Point point(double across, double along) {
            AreaSums.Place cell = cells.at(along);
            double a = from + across * (to - from);
            double b = (cell.index() + cell.share()) / CELLS;
            Vec3 position = toScene.transformPoint(patch.point(a, b));
            Vec3 normal = normal(a, b).normalized();
            boolean inwards = normal.dot(position.minus(toScene.transformPoint(inside))) < 0;
            double[] uv = patch.coordinates().of(patch.point(a, b));
            return new ObjectSurface.Point(position, inwards ? normal.negated() : normal, uv[0], uv[1], bothSides);
        }

        private Vec3 normal(double a, double b) {
            // Away from the ends, where a ring can be a point.
            double middle = Math.clamp(a, STEP, 1 - STEP);
            Vec3 across = toScene.transformVector(patch.point(middle + STEP, b).minus(patch.point(middle - STEP, b)));
            Vec3 along = toScene.transformVector(patch.point(middle, b + STEP).minus(patch.point(middle, b - STEP)));
            return across.cross(along);
        }
    }

    /** Returns the rings of all parts of a solid. */
    static List<ObjectSurface.Strip> strips(Solid.Canonical solid, Transform toScene) {
        var strips = new ArrayList<ObjectSurface.Strip>();
        switch (solid) {
            case Solid.Sphere _ -> add(strips, new Patch((a, b) -> circle(2 * Math.sqrt(a * (1 - a)), 2 * a - 1, b),
                    p -> new double[] {longitude(p), StrictMath.asin(Math.clamp(p.y(), -1, 1)) / Math.PI + 0.5}), toScene, RINGS, false,
                    Vec3.ZERO);
            case Solid.Plane _ -> add(strips, new Patch((a, b) -> new Vec3(b - 0.5, 0, a - 0.5),
                    p -> new double[] {p.x() + 0.5, p.z() + 0.5}), toScene, 1, true, Vec3.Y.negated());
            case Solid.Cone c -> addAround(strips, 0, c.caps(), toScene);
            case Solid.Cylinder c -> addAround(strips, 1, c.caps(), toScene);
            case Solid.Frustum f -> addAround(strips, f.top(), f.caps(), toScene);
        }
        return List.copyOf(strips);
    }

    /** Adds the side and the caps of a solid around y. */
    private static void addAround(List<ObjectSurface.Strip> strips, double top, boolean caps, Transform toScene) {
        var inside = new Vec3(0, 0.5, 0);
        add(strips, new Patch((a, b) -> circle(1 + (top - 1) * a, a, b), p -> new double[] {longitude(p), p.y()}), toScene, RINGS, !caps,
                inside);
        if (caps) {
            add(strips, cap(1, 0), toScene, RINGS, false, inside);
        }
        if (caps && top > 0) {
            add(strips, cap(top, 1), toScene, RINGS, false, inside);
        }
    }

    private static Patch cap(double radius, double height) {
        return new Patch((a, b) -> circle(radius * Math.sqrt(a), height, b), p -> new double[] {0.5 * (p.x() + 1), 0.5 * (p.z() + 1)});
    }

    private static Vec3 circle(double radius, double height, double turn) {
        return new Vec3(radius * Transform.cosDegrees(360 * turn), height, radius * Transform.sinDegrees(360 * turn));
    }

    /** Returns the share of a turn of a point around y, as the textures of solids are wrapped. */
    private static double longitude(Vec3 p) {
        return StrictMath.atan2(p.x(), p.z()) / (2 * Math.PI) + 0.5;
    }

    private static void add(List<ObjectSurface.Strip> strips, Patch patch, Transform toScene, int rings, boolean bothSides, Vec3 inside) {
        for (int i = 0; i < rings; i++) {
            strips.add(Ring.of(patch, toScene, i / (double) rings, (i + 1) / (double) rings, bothSides, inside));
        }
    }
}
