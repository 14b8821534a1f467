package lightning.pov;

import lightning.scene.Solid;

/**
 * A canonical solid in POV-Ray's language.
 *
 * @param text    the solid, left open for texture and placing
 * @param mapping how an image is put around it
 * @param caps    whether discs close its side
 * @param wide    how far it reaches at most along x and z; along y it is 1
 */
record PovSolid(String text, String mapping, boolean caps, double wide) {
    private static final String PLANAR = "map_type 0";
    private static final String SPHERICAL = "map_type 1";
    private static final String CYLINDRICAL = "map_type 2";

    static PovSolid of(Solid.Canonical solid) {
        return switch (solid) {
            case Solid.Sphere _ -> new PovSolid("sphere { <0, 0, 0>, 1", SPHERICAL, false, 1);
            case Solid.Cone c -> round("cone { <0, 0, 0>, 1, <0, 1, 0>, 0", c.caps(), 1);
            case Solid.Cylinder c -> round("cylinder { <0, 0, 0>, <0, 1, 0>, 1", c.caps(), 1);
            case Solid.Frustum f -> round("cone { <0, 0, 0>, 1, <0, 1, 0>, " + f.top(), f.caps(), Math.max(1, f.top()));
            case Solid.Plane _ -> new PovSolid(
                    "polygon { 5, <-0.5, 0, -0.5>, <0.5, 0, -0.5>, <0.5, 0, 0.5>, <-0.5, 0, 0.5>, <-0.5, 0, -0.5>", PLANAR, false, 1);
        };
    }

    private static PovSolid round(String text, boolean caps, double wide) {
        return new PovSolid(text + (caps ? "" : " open"), CYLINDRICAL, caps, wide);
    }
}
