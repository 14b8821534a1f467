package lightning.scene;

import java.util.List;
import java.util.function.BiFunction;
import java.util.function.Function;

/** The form of a shape: of a canonical size, or as large as its triangles are. All that a file may say of a solid stands here. */
public sealed interface Solid {
    Canonical SPHERE = new Sphere();
    Canonical CONE = new Cone(true);
    Canonical CYLINDER = new Cylinder(true);
    Canonical FRUSTUM = new Frustum(0.5, true);
    Canonical PLANE = new Plane();

    /** Each of those that a formula describes, as a file has it that says nothing more. */
    List<Canonical> CANONICAL = List.of(SPHERE, CONE, CYLINDER, FRUSTUM, PLANE);

    /** What a formula describes, in a canonical size of its own. */
    sealed interface Canonical extends Solid {
        /** What can be said of such a solid, in the order in which a file writes it. */
        default List<SceneAttribute<Canonical, ?>> attributes() {
            return List.of();
        }

        /** The smallest box that holds it, in its own space: least x, y, z, greatest x, y, z. */
        double[] bounds();

        /** How a texture lies on it, but for the discs that close it. */
        default Wrap wrap() {
            return switch (this) {
                case Sphere _ -> Wrap.SPHERICAL;
                case AxialSolid _ -> Wrap.CYLINDRICAL;
                case Plane _ -> Wrap.FLAT;
            };
        }

        /** Whether discs close it, which have texture coordinates of their own. */
        default boolean hasCaps() {
            return switch (this) {
                case AxialSolid s -> s.caps();
                case Sphere _,Plane _ -> false;
            };
        }

        /** What POV-Ray calls it, left open for texture and placing. */
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

    /** How texture coordinates go around a solid. */
    enum Wrap {
        /** Along x and z. */
        FLAT,
        /** By longitude and latitude. */
        SPHERICAL,
        /** By longitude and height. */
        CYLINDRICAL
    }

    /** What stands on y = 0 around the y axis, 1 high. */
    sealed interface AxialSolid extends Canonical {
        /** Whether discs close it; without them the inside of the side is seen. */
        boolean caps();
    }

    /** Radius 1 about the origin. */
    record Sphere() implements Canonical {
        @Override
        public double[] bounds() {
            return new double[] {-1, -1, -1, 1, 1, 1};
        }
    }

    /**
     * A base of radius 1 at y = 0, and the apex at y = 1.
     *
     * @param caps whether a disc closes the base; without it the inside of the side is seen
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
     * Radius 1 about the y axis, from y = 0 to y = 1.
     *
     * @param caps whether two discs close it; without them the inside of the side is seen
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
     * A cone cut parallel to its base: radius 1 at y = 0, another at y = 1.
     *
     * @param top  the radius at y = 1
     * @param caps whether two discs close it; without them the inside of the side is seen
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

    /** A patch of the plane y = 0: the unit square, x and z from −½ to ½. */
    record Plane() implements Canonical {
        @Override
        public double[] bounds() {
            return new double[] {-0.5, 0, -0.5, 0.5, 0, 0.5};
        }
    }

    /**
     * Triangles of a file.
     *
     * @param file   the name as written in the scene file
     * @param part   the name of the part of the file; empty for all that it holds
     * @param showsColors whether the colors of its vertices are shown, where it has any
     * @param mesh   what was read: shared by all shapes that show it
     */
    record TriangleMesh(String file, String part, boolean showsColors, Mesh mesh) implements Solid {
        /** With the colors of its vertices. */
        public TriangleMesh(String file, String part, Mesh mesh) {
            this(file, part, true, mesh);
        }

        /** Whether colors of vertices are a factor on its material's diffuse color. */
        public boolean hasVertexColors() {
            return showsColors && mesh.colors() != null;
        }

        public TriangleMesh withShowsColors(boolean v) {
            return new TriangleMesh(file, part, v, mesh);
        }
    }

    /** The box of what stands on y = 0, 1 high. */
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

    /** What files and people call it, in the singular. */
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
