package lightning.scene.node;

import java.util.List;
import java.util.function.BiFunction;
import java.util.function.Function;
import lightning.scene.asset.Texture;
import lightning.scene.attribute.ChoiceKind;
import lightning.scene.attribute.NumericKind;
import lightning.scene.attribute.SceneAttribute;
import lightning.scene.attribute.ValueKind;
import lightning.scene.value.SceneLimits;

/** Geometry of a shape: a canonical solid of fixed size, or a triangle mesh. */
public sealed interface Solid {
    Canonical SPHERE = new Sphere();
    Canonical CONE = new Cone(true);
    Canonical CYLINDER = new Cylinder(true);
    Canonical FRUSTUM = new Frustum(0.5, true);
    Canonical PLANE = new Plane();

    /** Canonical solids with initial attributes, one of each type. */
    List<Canonical> CANONICAL = List.of(SPHERE, CONE, CYLINDER, FRUSTUM, PLANE);

    /** Solid defined by a formula, in a canonical size. */
    sealed interface Canonical extends Solid {
        /** Returns the attributes of this solid, in file order. */
        default List<SceneAttribute<Canonical, ?>> attributes() {
            return List.of();
        }

        /** Returns the bounding box in local space: minimum x, y, z, maximum x, y, z. */
        double[] bounds();

        /** Returns the texture mapping, except for caps. */
        default Wrap wrap() {
            return switch (this) {
                case Sphere _ -> Wrap.SPHERICAL;
                case AxialSolid _ -> Wrap.CYLINDRICAL;
                case Plane _ -> Wrap.FLAT;
            };
        }

        /** Returns whether it has caps, which have their own texture coordinates. */
        default boolean hasCaps() {
            return switch (this) {
                case AxialSolid s -> s.caps();
                case Sphere _,Plane _ -> false;
            };
        }

        /** Returns the POV-Ray object, left open for texture and placement. */
        default String toPovRay() {
            return switch (this) {
                case Sphere _ -> "sphere { <0, 0, 0>, 1";
                case Cone c -> "cone { <0, 0, 0>, 1, <0, 1, 0>, 0" + openKeyword(c.caps);
                case Cylinder c -> "cylinder { <0, 0, 0>, <0, 1, 0>, 1" + openKeyword(c.caps);
                case Frustum f -> "cone { <0, 0, 0>, 1, <0, 1, 0>, " + f.top + openKeyword(f.caps);
                case Plane _ -> "polygon { 5, <-0.5, 0, -0.5>, <0.5, 0, -0.5>, <0.5, 0, 0.5>, <-0.5, 0, 0.5>, <-0.5, 0, -0.5>";
            };
        }

        private static String openKeyword(boolean caps) {
            return caps ? "" : " open";
        }
    }

    /** Texture mapping of a solid. */
    enum Wrap {
        /** Along x and z. */
        FLAT,
        /** By longitude and latitude. */
        SPHERICAL,
        /** By longitude and height. */
        CYLINDRICAL
    }

    /** Solid around the y axis from y = 0 to y = 1. */
    sealed interface AxialSolid extends Canonical {
        /** Returns whether discs close it; otherwise the inside is visible. */
        boolean caps();
    }

    /** Sphere of radius 1 about the origin. */
    record Sphere() implements Canonical {
        @Override
        public double[] bounds() {
            return new double[] {-1, -1, -1, 1, 1, 1};
        }
    }

    /**
     * Cone with a base of radius 1 at y = 0 and its apex at y = 1.
     *
     * @param caps true if a disc closes the base; otherwise the inside is visible
     */
    record Cone(boolean caps) implements AxialSolid {
        @Override
        public List<SceneAttribute<Canonical, ?>> attributes() {
            return List.of(capsAttribute(Cone.class, Cone::caps, (_, v) -> new Cone(v)));
        }

        @Override
        public double[] bounds() {
            return axialBox(1);
        }
    }

    /**
     * Cylinder of radius 1 about the y axis, from y = 0 to y = 1.
     *
     * @param caps true if two discs close it; otherwise the inside is visible
     */
    record Cylinder(boolean caps) implements AxialSolid {
        @Override
        public List<SceneAttribute<Canonical, ?>> attributes() {
            return List.of(capsAttribute(Cylinder.class, Cylinder::caps, (_, v) -> new Cylinder(v)));
        }

        @Override
        public double[] bounds() {
            return axialBox(1);
        }
    }

    /**
     * Frustum of a cone: radius 1 at y = 0, another at y = 1.
     *
     * @param top  radius at y = 1
     * @param caps true if two discs close it; otherwise the inside is visible
     */
    record Frustum(double top, boolean caps) implements AxialSolid {
        public Frustum {
            SceneLimits.checkRange("top", top, 0, SceneLimits.MAX_TOP);
        }

        @Override
        public List<SceneAttribute<Canonical, ?>> attributes() {
            return List.of(
                    attribute(Frustum.class, "top", NumericKind.number(0, SceneLimits.MAX_TOP, 0.1), 0.5, "radius; the base has radius 1",
                            Frustum::top, (f, v) -> new Frustum(v, f.caps)),
                    capsAttribute(Frustum.class, Frustum::caps, (f, v) -> new Frustum(f.top, v)));
        }

        @Override
        public double[] bounds() {
            return axialBox(Math.max(1, top));
        }
    }

    /** Unit square in the plane y = 0, x and z from −½ to ½. */
    record Plane() implements Canonical {
        @Override
        public double[] bounds() {
            return new double[] {-0.5, 0, -0.5, 0.5, 0, 0.5};
        }
    }

    /**
     * Triangle mesh from a file.
     *
     * @param file        name as written in the scene file
     * @param part        name of the file's part; empty for the whole file
     * @param showsColors true if vertex colors are used
     * @param mesh        the decoded mesh, shared by all shapes that show it
     */
    record TriangleMesh(String file, String part, boolean showsColors, Mesh mesh) implements Solid {
        /** Creates a mesh that uses its vertex colors. */
        public TriangleMesh(String file, String part, Mesh mesh) {
            this(file, part, true, mesh);
        }

        /** Returns whether the file cannot be used; the shape then keeps its names and is not seen. */
        public boolean isMissing() {
            return mesh == Mesh.MISSING;
        }

        /** Returns whether vertex colors multiply the material's diffuse color. */
        public boolean hasVertexColors() {
            return showsColors && mesh.colors() != null;
        }

        public TriangleMesh withShowsColors(boolean v) {
            return new TriangleMesh(file, part, v, mesh);
        }
    }

    /** Returns the box of a solid on y = 0 of height 1. */
    private static double[] axialBox(double radius) {
        return new double[] {-radius, 0, -radius, radius, 1, radius};
    }

    private static <S extends Canonical> SceneAttribute<Canonical, Boolean> capsAttribute(Class<S> type, Function<S, Boolean> get,
            BiFunction<S, Boolean, Canonical> with) {
        return attribute(type, "caps", ChoiceKind.YES_OR_NO, true, "", get, with);
    }

    private static <S extends Canonical, V> SceneAttribute<Canonical, V> attribute(Class<S> type, String name, ValueKind<V> kind, V initial,
            String unit, Function<S, V> get, BiFunction<S, V, Canonical> with) {
        return new SceneAttribute<>(name, name, kind, initial, unit, s -> get.apply(type.cast(s)), (s, v) -> with.apply(type.cast(s), v));
    }

    /** Returns the type's name in files and in the UI, in the singular. */
    default String typeName() {
        return switch (this) {
            case Sphere _ -> "sphere";
            case Cone _ -> "cone";
            case Cylinder _ -> "cylinder";
            case Frustum _ -> "frustum";
            case Plane _ -> "plane";
            case TriangleMesh _ -> "mesh";
        };
    }
}
