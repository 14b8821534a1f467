package lightning.render.trace.solid;

import lightning.scene.node.Solid;

/** Kind of canonical solid; a closed set. */
public enum SolidKind {
    SPHERE(new Sphere()),
    CYLINDER(new Cylinder()),
    /** Also cones, whose top has radius 0. */
    FRUSTUM(new Frustum()),
    PLANE(new Plane());

    private static final SolidKind[] ALL = values();
    private static final double[] NONE = {};

    private final SolidGeometry geometry;

    SolidKind(SolidGeometry geometry) {
        this.geometry = geometry;
    }

    /** Returns the kind with a given {@link #ordinal}. */
    public static SolidKind fromOrdinal(int ordinal) {
        return ALL[ordinal];
    }

    public static SolidKind of(Solid.Canonical solid) {
        return switch (solid) {
            case Solid.Sphere _ -> SPHERE;
            case Solid.Cone _ -> FRUSTUM;
            case Solid.Cylinder _ -> CYLINDER;
            case Solid.Frustum f -> f.top() == 1 ? CYLINDER : FRUSTUM;
            case Solid.Plane _ -> PLANE;
        };
    }

    /** Returns the parameters of a solid that its {@link SolidGeometry} expects after the transform. */
    public static double[] parameters(Solid.Canonical solid) {
        return switch (solid) {
            case Solid.Sphere _ -> NONE;
            case Solid.Cone c -> frustumParameters(0, c.caps());
            case Solid.Cylinder c -> frustumParameters(1, c.caps());
            case Solid.Frustum f -> frustumParameters(f.top(), f.caps());
            case Solid.Plane _ -> NONE;
        };
    }

    private static double[] frustumParameters(double top, boolean caps) {
        return new double[] {top, caps ? 1 : 0};
    }

    /** Returns the intersection code of this kind. */
    public SolidGeometry geometry() {
        return geometry;
    }
}
