package lightning.render.trace;

import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import lightning.base.math.Vec3;
import lightning.render.trace.solid.SolidGeometry;
import lightning.render.trace.solid.SolidKind;
import lightning.scene.node.Solid;

/** Solids for tests, with their distances in local space. */
final class CanonicalSolids {
    /** One solid of each kind. */
    static final List<Solid.Canonical> BASIC = List.of(Solid.SPHERE, Solid.CONE, Solid.CYLINDER, Solid.PLANE, Solid.FRUSTUM);
    /** Solids with an inside. */
    static final List<Solid.Canonical> CLOSED = Stream.concat(Stream.of(Solid.SPHERE, Solid.CONE, Solid.CYLINDER), frustums(true)).toList();
    /** Solids whose inside is visible. */
    static final List<Solid.Canonical> OPEN =
            Stream.concat(Stream.of(new Solid.Cone(false), new Solid.Cylinder(false)), frustums(false)).toList();
    static final List<Solid.Canonical> ALL = Stream.of(CLOSED.stream(), OPEN.stream(), Stream.of(Solid.PLANE)).flatMap(s -> s).toList();

    private CanonicalSolids() {}

    private static Stream<Solid.Canonical> frustums(boolean caps) {
        return Stream.of(0.5, 1e-9, 1 - 0x1p-53, 1 + 1e-9, 3.0, 1000.0).map(top -> new Solid.Frustum(top, caps));
    }

    /** Returns solids without sharp edges. */
    static List<Solid.Canonical> blunt() {
        return ALL.stream().filter(s -> topRadius(s) < 10).toList();
    }

    /** Returns a random solid, including frustums with unusual tops. */
    static Solid.Canonical randomSolid(Random random) {
        return switch (random.nextInt(7)) {
            case 0, 1, 2 -> BASIC.get(random.nextInt(4));
            case 3 -> new Solid.Frustum(random.nextInt(4) == 0 ? 1 + Math.scalb(1.0, -random.nextInt(53))
                    : Math.pow(10, 18 * random.nextDouble() - 12), random.nextBoolean());
            case 4 -> new Solid.Frustum(2 * random.nextDouble(), random.nextBoolean());
            default -> ALL.get(random.nextInt(ALL.size()));
        };
    }

    static boolean isOpen(Solid.Canonical solid) {
        return switch (solid) {
            case Solid.Sphere _,Solid.Plane _ -> false;
            case Solid.Cone c -> !c.caps();
            case Solid.Cylinder c -> !c.caps();
            case Solid.Frustum f -> !f.caps();
        };
    }

    /** Returns the radius of a round solid at y = 1. */
    static double topRadius(Solid.Canonical solid) {
        return switch (solid) {
            case Solid.Sphere _,Solid.Plane _,Solid.Cylinder _ -> 1;
            case Solid.Cone _ -> 0;
            case Solid.Frustum f -> f.top();
        };
    }

    /** Returns a point well inside; for the plane, a point on it. */
    static Vec3 center(Solid.Canonical solid) {
        return switch (solid) {
            case Solid.Sphere _ -> new Vec3(0.1, 0.2, -0.1);
            case Solid.Cone _ -> new Vec3(0.1, 0.3, 0.1);
            case Solid.Cylinder _ -> new Vec3(-0.1, 0.4, 0.2);
            case Solid.Frustum _ -> new Vec3(0.1, 0.3, 0.1);
            case Solid.Plane _ -> new Vec3(0.1, 0, -0.1);
        };
    }

    private static double[] data(Solid.Canonical solid) {
        double[] numbers = SolidKind.parameters(solid);
        double[] data = new double[SolidGeometry.MAP_SIZE + numbers.length];
        System.arraycopy(numbers, 0, data, SolidGeometry.MAP_SIZE, numbers.length);
        return data;
    }

    /** Returns the bounds of the shape: min x, y, z, max x, y, z. */
    static double[] extent(Solid.Canonical solid) {
        double[] box = new double[6];
        for (int axis = 0; axis < 3; axis++) {
            SolidKind.of(solid).geometry().extent(data(solid), 0, axis == 0 ? 1 : 0, axis == 1 ? 1 : 0, axis == 2 ? 1 : 0, 0, box, axis);
        }
        return box;
    }

    /** Returns whether a point belongs to the round side. */
    static boolean isSide(Solid.Canonical solid, double x, double y, double z) {
        double[] out = new double[3];
        SolidKind.of(solid).geometry().outwardNormal(data(solid), 0, x, y, z, out);
        return out[0] != 0 || out[2] != 0;
    }

    static double distance(Solid.Canonical solid, double ox, double oy, double oz, double dx, double dy, double dz) {
        return SolidKind.of(solid).geometry().distance(data(solid), 0, ox, oy, oz, dx, dy, dz);
    }

    static double sphere(double ox, double oy, double oz, double dx, double dy, double dz) {
        return distance(Solid.SPHERE, ox, oy, oz, dx, dy, dz);
    }

    static double cone(double ox, double oy, double oz, double dx, double dy, double dz) {
        return distance(Solid.CONE, ox, oy, oz, dx, dy, dz);
    }

    static double cylinder(double ox, double oy, double oz, double dx, double dy, double dz) {
        return distance(Solid.CYLINDER, ox, oy, oz, dx, dy, dz);
    }

    static double plane(double ox, double oy, double oz, double dx, double dy, double dz) {
        return distance(Solid.PLANE, ox, oy, oz, dx, dy, dz);
    }
}
