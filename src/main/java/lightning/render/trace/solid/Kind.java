package lightning.render.trace.solid;

import lightning.scene.Solid;

/** The kinds of canonical solids that rays can meet: a closed set. */
public enum Kind {
    SPHERE(new Sphere()),
    CYLINDER(new Cylinder()),
    /** Cones too: their top has radius 0. */
    FRUSTUM(new Frustum()),
    PLANE(new Plane());

    private static final Kind[] ALL = values();
    private static final double[] NONE = {};

    private final Form form;

    Kind(Form form) {
        this.form = form;
    }

    /** The kind with a given {@link #ordinal}. */
    public static Kind at(int ordinal) {
        return ALL[ordinal];
    }

    public static Kind of(Solid.Canonical solid) {
        return switch (solid) {
            case Solid.Sphere _ -> SPHERE;
            case Solid.Cone _ -> FRUSTUM;
            case Solid.Cylinder _ -> CYLINDER;
            case Solid.Frustum f -> f.top() == 1 ? CYLINDER : FRUSTUM;
            case Solid.Plane _ -> PLANE;
        };
    }

    /** The numbers of a solid of its own, as its {@link Form} expects them behind its map. */
    public static double[] numbers(Solid.Canonical solid) {
        return switch (solid) {
            case Solid.Sphere _ -> NONE;
            case Solid.Cone c -> round(0, c.caps());
            case Solid.Cylinder c -> round(1, c.caps());
            case Solid.Frustum f -> round(f.top(), f.caps());
            case Solid.Plane _ -> NONE;
        };
    }

    private static double[] round(double top, boolean caps) {
        return new double[] {top, caps ? 1 : 0};
    }

    /** What tracing must know of it. */
    public Form form() {
        return form;
    }
}
