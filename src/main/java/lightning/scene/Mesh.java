package lightning.scene;

import java.util.Arrays;
import java.util.Locale;
import lightning.base.text.DecimalNumber;

/**
 * Triangles over shared vertices. Its arrays are handed out as they are and never written after construction, by anyone.
 *
 * <p>A triangle is seen and lit from both sides. Its front is where its vertices go round counter-clockwise. Triangles may be
 * degenerate, may be there twice and may share an edge with any number of others.
 */
public final class Mesh {
    /** Positions, either sign, as those of a scene. */
    public static final double MAX_COORDINATE = 1e12;
    /** Texture coordinates, either sign: beyond it a float no longer tells neighboring pixels apart. */
    public static final double MAX_TEXTURE_COORDINATE = 1e6;
    /** Linear colors: factors on a material's. */
    public static final double MAX_COLOR = 1;
    /** How far the square of a normal's length may be from 1; rounding to float takes less than 1e-6. */
    private static final double UNIT_TOLERANCE = 1e-5;
    /** How many coordinates tell meshes of one size apart in tables. */
    private static final int HASH_SAMPLES = 64;

    private final float[] positions;
    private final int[] triangles;
    private final float[] normals;
    private final float[] textureCoordinates;
    private final float[] colors;
    private final float[] tangents;

    /** Without tangents. */
    public Mesh(float[] positions, int[] triangles, float[] normals, float[] coordinates, float[] colors) {
        this(positions, triangles, normals, coordinates, colors, null);
    }

    /**
     * @param positions   x, y, z of each vertex, {@code float[3 * vertices]}, each of at most 1e12 in absolute value; taken over,
     *                    not copied, like all other arrays
     * @param triangles   three vertices of each triangle, {@code int[3 * triangles]}
     * @param normals     x, y, z of each vertex's normal, of length 1, {@code float[3 * vertices]}; null where all triangles are flat
     * @param coordinates u, v of each vertex in a texture, v upwards, {@code float[2 * vertices]}, each of at most 1e6 in
     *                    absolute value; null where there are none
     * @param colors      linear red, green, blue of each vertex, {@code float[3 * vertices]}, from 0 to 1; null where there are none
     * @param tangents    x, y, z of a direction along the surface in which u grows, of length 1 or 0 where there is none, and 1, or −1 where
     *                    v grows against normal × tangent, {@code float[4 * vertices]}; null where a normal map goes by the texture coordinates
     * @throws IllegalArgumentException if an array has another length, a triangle names a vertex that there is not, or a number is
     *                                  out of its range or no number, or there are tangents without normals; the message says which
     */
    public Mesh(float[] positions, int[] triangles, float[] normals, float[] coordinates, float[] colors, float[] tangents) {
        if (positions.length % 3 != 0) {
            throw new IllegalArgumentException("positions must be three numbers for each vertex, were " + positions.length + " numbers");
        }
        if (triangles.length % 3 != 0) {
            throw new IllegalArgumentException("triangles must have three vertices each, were " + triangles.length + " vertices");
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
                throw new IllegalArgumentException("tangents need normals, found none");
            }
            checkLength("tangents", tangents, 4);
            checkUnitLength("tangent", tangents, 4, true);
            checkHandedness();
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

    /** x, y, z of each vertex, {@code float[3 * vertexCount()]}; not to be written. */
    public float[] positions() {
        return positions;
    }

    /** Three vertices of each triangle, {@code int[3 * triangleCount()]}; not to be written. */
    public int[] triangles() {
        return triangles;
    }

    /** x, y, z of each vertex's normal, of length 1, {@code float[3 * vertexCount()]}, or null; not to be written. */
    public float[] normals() {
        return normals;
    }

    /** u, v of each vertex, v upwards, {@code float[2 * vertexCount()]}, or null; not to be written. */
    public float[] coordinates() {
        return textureCoordinates;
    }

    /** Linear red, green, blue of each vertex, {@code float[3 * vertexCount()]}, or null; not to be written. */
    public float[] colors() {
        return colors;
    }

    /** x, y, z of a direction in which u grows and 1 or −1, {@code float[4 * vertexCount()]}, or null; not to be written. */
    public float[] tangents() {
        return tangents;
    }

    /** Whether all numbers are the same, 0 and −0 told apart. */
    @Override
    public boolean equals(Object o) {
        return this == o || o instanceof Mesh m && Arrays.equals(positions, m.positions) && Arrays.equals(triangles, m.triangles)
                && Arrays.equals(normals, m.normals) && Arrays.equals(textureCoordinates, m.textureCoordinates)
                && Arrays.equals(colors, m.colors)
                && Arrays.equals(tangents, m.tangents);
    }

    @Override
    public int hashCode() {
        int hash = 31 * positions.length + triangles.length;
        // A few of the numbers: meshes of one size are many, and a mesh has millions.
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
            throw new IllegalArgumentException(name + " must be " + stride + " numbers for each of " + vertexCount() + " vertices, were "
                    + numbers.length + " numbers");
        }
    }

    private static void checkRange(String name, float[] numbers, int stride, double min, double max) {
        for (int i = 0; i < numbers.length; i++) {
            if (!(numbers[i] >= min && numbers[i] <= max)) {
                throw new IllegalArgumentException(
                        String.format(Locale.ROOT, "vertex %d: each number of its %s must be from %s to %s, was %s",
                                i / stride, name, DecimalNumber.format(min), DecimalNumber.format(max), text(numbers[i])));
            }
        }
    }

    private void checkTriangles() {
        int vertices = vertexCount();
        for (int i = 0; i < triangles.length; i++) {
            if (triangles[i] < 0 || triangles[i] >= vertices) {
                throw new IllegalArgumentException("triangle " + i / 3 + ": vertices must be from 0 to " + (vertices - 1) + ", was "
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
                throw new IllegalArgumentException("vertex " + i / stride + ": its " + name + " must have length 1, was " + text(numbers[i])
                        + " " + text(numbers[i + 1]) + " " + text(numbers[i + 2]));
            }
        }
    }

    private void checkHandedness() {
        for (int i = 3; i < tangents.length; i += 4) {
            if (Math.abs(tangents[i]) != 1) {
                throw new IllegalArgumentException("vertex " + i / 4 + ": the fourth number of its tangent must be 1 or -1, was "
                        + text(tangents[i]));
            }
        }
    }

    private static String text(float v) {
        return DecimalNumber.format(Double.parseDouble(Float.toString(v)));
    }
}
