package lightning.render.gather.glow;

import java.util.Arrays;
import java.util.stream.IntStream;
import lightning.base.math.Rgb;
import lightning.render.gather.cell.SurfaceColumns;
import lightning.render.trace.Geometry;
import lightning.render.trace.HitRows.ColumnGroup;
import lightning.render.trace.MaterialTable;
import lightning.render.trace.ShapeChange;
import lightning.render.trace.tree.Bvh;
import lightning.scene.asset.TextureMap;

/**
 * Glowing objects of a scene. Where one is small, seen from a point, few of the point's cosine-distributed rays would meet it. So rays are
 * aimed at it ({@link GlowAim}), and the others do not count its glow. Immutable.
 */
public final class GlowShapes {
    private static final GlowShapes NONE = new GlowShapes();
    private static final GlowShapes TOO_MANY = new GlowShapes();

    /** With more objects no ray is aimed. */
    private static final int MAX_SHAPES = 1024;
    /** Squared distance of a small object in squared half diagonals of its box: it covers at most 0.4 steradians. */
    private static final double MIN_DISTANCE_SQUARED = 8;

    private final int[] primitives;
    private final int[] materials;
    /** Centers and half sides of the boxes: x, y, z of each. */
    private final double[] centers;
    private final double[] halfSides;

    private GlowShapes() {
        primitives = new int[0];
        materials = primitives;
        centers = new double[0];
        halfSides = centers;
    }

    private GlowShapes(Geometry geometry, int[] primitives) {
        this.primitives = primitives;
        materials = Arrays.stream(primitives).map(geometry::materialIndex).toArray();
        centers = new double[3 * primitives.length];
        halfSides = new double[3 * primitives.length];
        Bvh bvh = geometry.bvh();
        for (int i = 0; i < centers.length; i++) {
            int box = bvh.leafBox[primitives[i / 3]] + i % 3;
            centers[i] = 0.5 * bvh.boxes[box] + 0.5 * bvh.boxes[box + 3];
            halfSides[i] = 0.5 * bvh.boxes[box + 3] - 0.5 * bvh.boxes[box];
        }
    }

    /** Returns no objects. */
    public static GlowShapes none() {
        return NONE;
    }

    /**
     * Returns the opaque objects that a picture shows glowing, bulbs included, lit or not, but not the faces of lights, unless there are too many.
     */
    public static GlowShapes seen(Geometry geometry, MaterialTable materials) {
        boolean[] glows = new boolean[materials.count()];
        for (int m = 0; m < glows.length; m++) {
            glows[m] = !materials.isTransparent(m) && shows(materials, m);
        }
        return of(geometry, glows);
    }

    private static boolean shows(MaterialTable materials, int m) {
        boolean shows = false;
        for (int c = 0; c < 3; c++) {
            shows |= materials.ownGlow(m, c) > 0 || materials.bulbGlow(m, c) > 0;
        }
        return shows;
    }

    /** Returns the opaque objects that glow, unless there are too many. */
    public static GlowShapes of(Geometry geometry) {
        return of(geometry, geometry.materials());
    }

    /** @param materials of the objects, instead of those of the geometry */
    public static GlowShapes of(Geometry geometry, MaterialTable materials) {
        boolean[] glows = new boolean[materials.count()];
        for (int m = 0; m < glows.length; m++) {
            glows[m] = !materials.isTransparent(m) && (glow(materials, m, 0) > 0 || glow(materials, m, 1) > 0 || glow(materials, m, 2) > 0);
        }
        return of(geometry, glows);
    }

    /** @param glows whether each material glows */
    private static GlowShapes of(Geometry geometry, boolean[] glows) {
        boolean any = false;
        for (boolean glow : glows) {
            any |= glow;
        }
        int[] found = any
                ? IntStream.range(0, geometry.primitiveCount())
                        .filter(p -> glows[geometry.materialIndex(p)] && !geometry.isLightFace(p) && geometry.isSeen(p))
                        .limit(MAX_SHAPES + 1L).toArray()
                : NONE.primitives;
        return found.length == 0 ? NONE : found.length > MAX_SHAPES ? TOO_MANY : new GlowShapes(geometry, found);
    }

    /** Returns one channel of the light that a material emits, with the mean of its glow map. */
    private static float glow(MaterialTable materials, int m, int c) {
        float emitted = (1 - materials.reflective(m, c)) * materials.ownGlow(m, c);
        TextureMap map = materials.map(ColumnGroup.GLOW_TEXEL, m);
        if (map == null) {
            return emitted;
        }
        Rgb mean = map.image().areas().mean();
        return emitted * (float) (c == 0 ? mean.r() : c == 1 ? mean.g() : mean.b());
    }

    /** Returns the number of objects. */
    public int count() {
        return primitives.length;
    }

    /** Returns the primitive that an object is. */
    public int primitive(int shape) {
        return primitives[shape];
    }

    /** Returns the light that the objects emit: red, green and blue of all. */
    public float[][] glow(MaterialTable table) {
        float[][] glow = new float[3][count()];
        for (int shape = 0; shape < count(); shape++) {
            for (int c = 0; c < 3; c++) {
                glow[c][shape] = glow(table, materials[shape], c);
            }
        }
        return glow;
    }

    /**
     * Returns whether these are some objects of the same scene, with the same boxes: rays are aimed at the boxes, whose padding depends on the extent of
     * the whole scene.
     */
    public boolean areSame(GlowShapes others) {
        return (this == TOO_MANY) == (others == TOO_MANY) && Arrays.equals(primitives, others.primitives)
                && Arrays.equals(centers, others.centers) && Arrays.equals(halfSides, others.halfSides);
    }

    /** Returns whether an edit of shapes changed any of these objects. */
    public boolean haveChanged(ShapeChange shapes) {
        return !Arrays.equals(shapes.mapIndices(primitives), primitives);
    }

    /** Returns whether these contain some objects of the same scene. Too many objects contain only too many. */
    public boolean contain(GlowShapes others) {
        return (this == TOO_MANY) == (others == TOO_MANY) && IntStream.of(others.primitives).allMatch(this::contains);
    }

    /** Returns the object that a primitive is; negative for none. */
    public int index(int primitive) {
        return primitives.length == 0 ? -1 : Arrays.binarySearch(primitives, primitive);
    }

    /** Returns whether a primitive is one of these. */
    public boolean contains(int primitive) {
        return index(primitive) >= 0;
    }

    /** Returns whether rays of a point are aimed at a primitive, so that others do not count its glow. */
    public boolean isAimed(int primitive, float x, float y, float z) {
        int shape = index(primitive);
        return shape >= 0 && isSmall(shape, x, y, z);
    }

    /** Returns whether rays of point {@code p} are aimed at a primitive, as above. */
    public boolean isAimed(int primitive, SurfaceColumns points, int p) {
        return isAimed(primitive, points.px[p], points.py[p], points.pz[p]);
    }

    /** Returns whether an object is small, seen from a place. */
    boolean isSmall(int shape, float x, float y, float z) {
        double dx = x - centers[3 * shape];
        double dy = y - centers[3 * shape + 1];
        double dz = z - centers[3 * shape + 2];
        double hx = halfSides[3 * shape];
        double hy = halfSides[3 * shape + 1];
        double hz = halfSides[3 * shape + 2];
        return dx * dx + dy * dy + dz * dz >= MIN_DISTANCE_SQUARED * (hx * hx + hy * hy + hz * hz);
    }

    /** Returns the distance of a place from the center of an object's box along an axis, 0…2. */
    double fromCenter(int shape, int axis, double place) {
        return place - centers[3 * shape + axis];
    }

    /** Returns half of the side of an object's box along an axis, 0…2. */
    double halfSide(int shape, int axis) {
        return halfSides[3 * shape + axis];
    }
}
