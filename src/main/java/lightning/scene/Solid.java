package lightning.scene;

import lightning.mesh.Mesh;

/** The form of a shape: of a canonical size, or as large as its triangles are. */
public sealed interface Solid {
    Canonical SPHERE = new Sphere();
    Canonical CONE = new Cone(true);
    Canonical CYLINDER = new Cylinder(true);
    Canonical FRUSTUM = new Frustum(0.5, true);
    Canonical PLANE = new Plane();

    /** What a formula describes, in a canonical size of its own. */
    sealed interface Canonical extends Solid {}

    /** Radius 1 about the origin. */
    record Sphere() implements Canonical {}

    /**
     * A base of radius 1 at y = 0, and the apex at y = 1.
     *
     * @param caps whether a disc closes the base; without it the inside of the side is seen
     */
    record Cone(boolean caps) implements Canonical {}

    /**
     * Radius 1 about the y axis, from y = 0 to y = 1.
     *
     * @param caps whether two discs close it; without them the inside of the side is seen
     */
    record Cylinder(boolean caps) implements Canonical {}

    /**
     * A cone cut parallel to its base: radius 1 at y = 0, another at y = 1.
     *
     * @param top  the radius at y = 1
     * @param caps whether two discs close it; without them the inside of the side is seen
     */
    record Frustum(double top, boolean caps) implements Canonical {
        public Frustum {
            Limits.range("top", top, 0, Limits.MAX_TOP);
        }
    }

    /** A patch of the plane y = 0: the unit square, x and z from −½ to ½. */
    record Plane() implements Canonical {}

    /**
     * Triangles of a file.
     *
     * @param file the name as written in the scene file
     * @param part the name of the part of the file; empty for all that it holds
     * @param mesh what was read: shared by all shapes that show it
     */
    record Triangles(String file, String part, Mesh mesh) implements Solid {}

    /** What files and people call it, in the singular. */
    default String noun() {
        return switch (this) {
            case Sphere _ -> "sphere";
            case Cone _ -> "cone";
            case Cylinder _ -> "cylinder";
            case Frustum _ -> "frustum";
            case Plane _ -> "plane";
            case Triangles _ -> "mesh";
        };
    }
}
