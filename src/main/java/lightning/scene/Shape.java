package lightning.scene;

/**
 * A primitive solid in its own canonical size, put into the scene by its placement.
 *
 * <p>{@link #material()} is the name of a material of the scene.
 */
public sealed interface Shape extends Node permits Shape.Sphere, Shape.Cone, Shape.Cylinder, Shape.Plane {
    String material();

    /** Radius 1 about the origin. */
    record Sphere(String name, String material, Placement placement) implements Shape {
        public Sphere {
            Limits.name(name);
        }
    }

    /** A capped cone: a base of radius 1 at y = 0, the apex at y = 1. */
    record Cone(String name, String material, Placement placement) implements Shape {
        public Cone {
            Limits.name(name);
        }
    }

    /** A capped cylinder: radius 1 about the y axis, from y = 0 to y = 1. */
    record Cylinder(String name, String material, Placement placement) implements Shape {
        public Cylinder {
            Limits.name(name);
        }
    }

    /** A patch of the plane y = 0: the unit square, x and z from −½ to ½. */
    record Plane(String name, String material, Placement placement) implements Shape {
        public Plane {
            Limits.name(name);
        }
    }
}
