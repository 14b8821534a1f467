package lightning.scene.node;

import java.util.Arrays;
import java.util.Locale;
import lightning.base.file.ContentDigest;
import lightning.base.text.DecimalNumber;
import lightning.base.text.RefusalException;
import lightning.scene.asset.Texture;
import org.jspecify.annotations.Nullable;

/**
 * Triangle mesh over shared vertices. Hands out its arrays without copying; nothing may write to them after construction.
 *
 * <p>A triangle is visible and lit from both sides; its front has counter-clockwise vertices. Triangles may be degenerate or duplicate and
 * may share an edge with any number of others.
 */
public final class Mesh implements ContentDigest.Content {
    /** Stands for a mesh whose file cannot be used: a point, which no ray meets. */
    public static final Mesh MISSING = new Mesh(new float[9], new int[] {0, 1, 2}, null, null, null);
    /** Positions, either sign, as in a scene. */
    public static final double MAX_COORDINATE = 1e12;
    /** Texture coordinates, either sign: above it a float no longer separates neighboring pixels. */
    public static final double MAX_TEXTURE_COORDINATE = 1e6;
    /** Linear vertex colors, factors of the material's color. */
    public static final double MAX_COLOR = 1;
    /** Tolerance of the squared length of a normal around 1; rounding to float needs less than 1e-6. */
    private static final double UNIT_TOLERANCE = 1e-5;
    /** Number of coordinates hashed to distinguish meshes of the same size. */
    private static final int HASH_SAMPLES = 64;

    private final float[] positions;
    private final int[] triangles;
    private final float @Nullable [] normals;
    private final float @Nullable [] textureCoordinates;
    private final float @Nullable [] colors;
    private final float @Nullable [] tangents;

    /** Creates a mesh without tangents. */
    public Mesh(float[] positions, int[] triangles, float @Nullable [] normals, float @Nullable [] coordinates, float @Nullable [] colors) {
        this(positions, triangles, normals, coordinates, colors, null);
    }

    /**
     * @param positions   x, y, z of each vertex, {@code float[3 * vertices]}, each of at most 1e12 in absolute value; owned by the mesh,
     *     not copied, like all other arrays
     * @param triangles   three vertices of each triangle, {@code int[3 * triangles]}
     * @param normals     x, y, z of each vertex's normal, of length 1, {@code float[3 * vertices]}; null if all triangles are flat
     * @param coordinates u, v of each vertex in a texture, v upwards, {@code float[2 * vertices]}, each of at most 1e6 in absolute value;
     *     null for none
     * @param colors      linear red, green, blue of each vertex, {@code float[3 * vertices]}, from 0 to 1
     * @param tangents    x, y, z of the direction in which u grows along the surface, of length 1, or 0 for none, and the sign of v's
     *     direction against normal × tangent, 1 or −1, {@code float[4 * vertices]}; null if a normal map uses the texture coordinates
     * @throws RefusalException if an array has the wrong length, a triangle names a missing vertex, a number is out of range or
     *     NaN, or there are tangents without normals; the message says which
     */
    public Mesh(float[] positions, int[] triangles, float @Nullable [] normals, float @Nullable [] coordinates, float @Nullable [] colors,
            float @Nullable [] tangents) {
        if (positions.length % 3 != 0) {
            throw new RefusalException("positions must be three numbers for each vertex, were " + positions.length + " numbers");
        }
        if (triangles.length % 3 != 0) {
            throw new RefusalException("triangles must have three vertices each, were " + triangles.length + " vertices");
        }
        this.positions = positions;
        this.triangles = triangles;
        this.normals = normals;
        this.textureCoordinates = coordinates;
        this.colors = colors;
        this.tangents = tangents;
        checkRange("position", positions, 3, -MAX_COORDINATE, MAX_COORDINATE);
        checkTriangles();
        if (normals != null) {
            checkLength("normals", normals, 3);
            checkUnitLength("normal", normals, 3, false);
        }
        if (tangents != null) {
            if (normals == null) {
                throw new RefusalException("tangents need normals, found none");
            }
            checkLength("tangents", tangents, 4);
            checkUnitLength("tangent", tangents, 4, true);
            checkHandedness(tangents);
        }
        if (coordinates != null) {
            checkLength("texture coordinates", coordinates, 2);
            checkRange("texture coordinate", coordinates, 2, -MAX_TEXTURE_COORDINATE, MAX_TEXTURE_COORDINATE);
        }
        if (colors != null) {
            checkLength("colors", colors, 3);
            checkRange("color", colors, 3, 0, MAX_COLOR);
        }
    }

    public int vertexCount() {
        return positions.length / 3;
    }

    public int triangleCount() {
        return triangles.length / 3;
    }

    /** Returns x, y, z of each vertex, {@code float[3 * vertexCount()]}; read-only. */
    public float[] positions() {
        return positions;
    }

    /** Returns three vertices of each triangle, {@code int[3 * triangleCount()]}; read-only. */
    public int[] triangles() {
        return triangles;
    }

    /** Returns x, y, z of each vertex's normal, of length 1, {@code float[3 * vertexCount()]}; read-only. */
    public float @Nullable [] normals() {
        return normals;
    }

    /** Returns u, v of each vertex, v upwards, {@code float[2 * vertexCount()]}; read-only. */
    public float @Nullable [] coordinates() {
        return textureCoordinates;
    }

    /** Returns linear red, green, blue of each vertex, {@code float[3 * vertexCount()]}; read-only. */
    public float @Nullable [] colors() {
        return colors;
    }

    /** Returns x, y, z of the direction in which u grows and 1 or −1, {@code float[4 * vertexCount()]}; read-only. */
    public float @Nullable [] tangents() {
        return tangents;
    }

    /** Compares all numbers bitwise: 0 and −0 differ. */
    @Override
    public boolean equals(@Nullable Object o) {
        return this == o || o instanceof Mesh m && Arrays.equals(positions, m.positions) && Arrays.equals(triangles, m.triangles)
                && Arrays.equals(normals, m.normals) && Arrays.equals(textureCoordinates, m.textureCoordinates)
                && Arrays.equals(colors, m.colors)
                && Arrays.equals(tangents, m.tangents);
    }

    @Override
    public void addTo(ContentDigest digest) {
        digest.add(positions);
        digest.add(triangles);
        digest.add(normals);
        digest.add(textureCoordinates);
        digest.add(colors);
        digest.add(tangents);
    }

    @Override
    public int hashCode() {
        int hash = 31 * positions.length + triangles.length;
        // Hashes only some numbers: many meshes have the same size, and a mesh has millions of numbers.
        for (int i = 0; i < positions.length; i += positions.length / HASH_SAMPLES + 1) {
            hash = 31 * hash + Float.floatToIntBits(positions[i]);
        }
        return hash;
    }

    @Override
    public String toString() {
        return "mesh of " + triangleCount() + " triangles over " + vertexCount() + " vertices";
    }

    private void checkLength(String name, float[] numbers, int stride) {
        if (numbers.length != stride * vertexCount()) {
            throw new RefusalException(name + " must be " + stride + " numbers for each of " + vertexCount() + " vertices, were "
                    + numbers.length + " numbers");
        }
    }

    private static void checkRange(String name, float[] numbers, int stride, double min, double max) {
        for (int i = 0; i < numbers.length; i++) {
            if (!(numbers[i] >= min && numbers[i] <= max)) {
                throw new RefusalException(
                        String.format(Locale.ROOT, "vertex %d: each number of its %s must be from %s to %s, was %s",
                                i / stride, name, DecimalNumber.format(min), DecimalNumber.format(max), text(numbers[i])));
            }
        }
    }

    private void checkTriangles() {
        int vertices = vertexCount();
        for (int i = 0; i < triangles.length; i++) {
            if (triangles[i] < 0 || triangles[i] >= vertices) {
                throw new RefusalException("triangle " + i / 3 + ": vertices must be from 0 to " + (vertices - 1) + ", was "
                        + triangles[i]);
            }
        }
    }

    private static void checkUnitLength(String name, float[] numbers, int stride, boolean allowZero) {
        for (int i = 0; i < numbers.length; i += stride) {
            double x = numbers[i];
            double y = numbers[i + 1];
            double z = numbers[i + 2];
            double square = x * x + y * y + z * z;
            if (!(Math.abs(square - 1) <= UNIT_TOLERANCE) && !(allowZero && square == 0)) {
                throw new RefusalException("vertex " + i / stride + ": its " + name + " must have length 1, was " + text(numbers[i])
                        + " " + text(numbers[i + 1]) + " " + text(numbers[i + 2]));
            }
        }
    }

    private static void checkHandedness(float[] tangents) {
        for (int i = 3; i < tangents.length; i += 4) {
            if (Math.abs(tangents[i]) != 1) {
                throw new RefusalException("vertex " + i / 4 + ": the fourth number of its tangent must be 1 or -1, was "
                        + text(tangents[i]));
            }
        }
    }

    private static String text(float v) {
        return DecimalNumber.format(Double.parseDouble(Float.toString(v)));
    }
}
