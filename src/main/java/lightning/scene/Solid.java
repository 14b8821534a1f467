package lightning.scene;

/** The form of a shape, in a canonical size of its own. */
public sealed interface Solid {
    Solid SPHERE = new Sphere();
    Solid CONE = new Cone(true);
    Solid CYLINDER = new Cylinder(true);
    Solid FRUSTUM = new Frustum(0.5, true);
    Solid PLANE = new Plane();

    /** Radius 1 about the origin. */
    record Sphere() implements Solid {}

    /**
     * A base of radius 1 at y = 0, and the apex at y = 1.
     *
     * @param caps whether a disc closes the base; without it the inside of the side is seen
     */
    record Cone(boolean caps) implements Solid {}

    /**
     * Radius 1 about the y axis, from y = 0 to y = 1.
     *
     * @param caps whether two discs close it; without them the inside of the side is seen
     */
    record Cylinder(boolean caps) implements Solid {}

    /**
     * A cone cut parallel to its base: radius 1 at y = 0, another at y = 1.
     *
     * @param top  the radius at y = 1
     * @param caps whether two discs close it; without them the inside of the side is seen
     */
    record Frustum(double top, boolean caps) implements Solid {
        public Frustum {
            Limits.range("top", top, 0, Limits.MAX_TOP);
        }
    }

    /** A patch of the plane y = 0: the unit square, x and z from −½ to ½. */
    record Plane() implements Solid {}

    /** What files and people call it, in the singular. */
    default String noun() {
        return switch (this) {
            case Sphere _ -> "sphere";
            case Cone _ -> "cone";
            case Cylinder _ -> "cylinder";
            case Frustum _ -> "frustum";
            case Plane _ -> "plane";
        };
    }
}
