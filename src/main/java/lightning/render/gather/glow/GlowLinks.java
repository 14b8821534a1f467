package lightning.render.gather.glow;

import java.io.IOException;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import lightning.render.column.ColumnReader;
import lightning.render.column.ColumnWriter;
import lightning.render.gather.ray.RaySums;

/** Shares of the light of small glowing objects that points receive. Immutable. */
public final class GlowLinks {
    /** Maximum bytes of an element while links are built: in a part, while the part grows, and in the links. */
    public static final int BUILD_BYTES = 3 * (2 + 3 * 4);
    static final GlowLinks NONE = new GlowLinks(List.of());

    /** First element of each point, and the number of elements; empty without points. */
    private final int[] start;
    /** Objects in {@link GlowShapes}, ascending for each point. */
    private final char[] shape;
    /** Weights of red, green and blue; the three arrays are one if no ray was tinted. */
    private final float[][] weight;

    /**
     * Elements of some points.
     *
     * @param first  first of the points
     * @param count  number of elements of each point
     * @param shape  object of each element
     * @param weight weights of the elements: red, green, blue
     */
    public record Part(int first, int[] count, char[] shape, float[][] weight) {
        // Arrays in a record: written once by their creator, never after.

        boolean isTinted() {
            return !Arrays.equals(weight[0], weight[1]) || !Arrays.equals(weight[0], weight[2]);
        }
    }

    private GlowLinks(List<Part> parts) {
        int points = parts.stream().mapToInt(part -> part.count.length).sum();
        int elements = parts.stream().mapToInt(part -> part.shape.length).sum();
        start = new int[points == 0 ? 0 : points + 1];
        shape = new char[elements];
        weight = new float[3][];
        boolean isTinted = parts.stream().anyMatch(Part::isTinted);
        for (int c = 0; c < 3; c++) {
            weight[c] = c > 0 && !isTinted ? weight[0] : new float[elements];
        }
        int at = 0;
        for (Part part : parts) {
            System.arraycopy(part.shape, 0, shape, at, part.shape.length);
            for (int c = 0; c < 3; c++) {
                System.arraycopy(part.weight[c], 0, weight[c], at, part.shape.length);
            }
            for (int i = 0; i < part.count.length; i++) {
                start[part.first + i] = at;
                at += part.count[i];
            }
        }
        if (points > 0) {
            start[points] = at;
        }
    }

    private GlowLinks(int[] start, char[] shape, float[][] weight) {
        this.start = start;
        this.shape = shape;
        this.weight = weight;
    }

    void writeTo(ColumnWriter out) throws IOException {
        out.writeArray(start);
        out.writeArray(shape);
        out.writeFloatArrays(weight[0] == weight[1] ? new float[][] {weight[0]} : weight);
    }

    static GlowLinks readFrom(ColumnReader in) throws IOException {
        int[] start = in.readInts();
        char[] shape = in.readChars();
        float[][] weight = in.readFloatArrays();
        return new GlowLinks(start, shape, weight.length == 1 ? new float[][] {weight[0], weight[0], weight[0]} : weight);
    }

    /** @param parts of all points, in any order */
    public static GlowLinks of(List<Part> parts) {
        return parts.isEmpty() ? NONE : new GlowLinks(parts.stream().sorted(Comparator.comparingInt(Part::first)).toList());
    }

    /**
     * Adds the light that a point receives, in the order of the objects.
     *
     * @param glow light of each object: red, green and blue of all
     * @param film that it is a part of
     */
    public void add(int point, float[][] glow, int film, RaySums to) {
        if (start.length == 0) {
            return;
        }
        for (int i = start[point]; i < start[point + 1]; i++) {
            for (int c = 0; c < 3; c++) {
                to.add(film, c, weight[c][i] * glow[c][shape[i]]);
            }
        }
    }

    /** Returns the first element of a point. */
    int first(int point) {
        return start[point];
    }

    /** Returns the number of elements of a point. */
    int count(int point) {
        return start[point + 1] - start[point];
    }

    /** Writes elements {@code from … from + count − 1} to some shapes and to red, green and blue weights. */
    void copy(int from, int count, char[] shapes, float[][] weights, int at) {
        System.arraycopy(shape, from, shapes, at, count);
        for (int c = 0; c < 3; c++) {
            System.arraycopy(weight[c], from, weights[c], at, count);
        }
    }

    /** Returns the bytes of the links. */
    public long bytes() {
        return 4L * start.length + (2L + (weight[0] == weight[1] ? 4 : 12)) * shape.length;
    }
}
