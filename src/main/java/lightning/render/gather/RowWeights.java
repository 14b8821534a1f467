package lightning.render.gather;

import java.io.IOException;
import java.util.Arrays;
import lightning.render.column.ColumnReader;
import lightning.render.column.ColumnWriter;
import lightning.render.gather.point.WeightedPoints;
import lightning.render.trace.HitRows;
import org.jspecify.annotations.Nullable;

/** Weights of the gather points near each row of a level: at most eight for each, fixed like the rows. Immutable. */
public final class RowWeights {
    static final int PER_ROW = 8;
    private static final int HALF_BYTE = 4;
    private static final int MAX_COUNT = 15;
    /** Maximum bytes of a row: its weights, their number, and its part of the list of points. */
    public static final long MAX_BYTES_PER_ROW = PER_ROW * (2 + Integer.BYTES) + 1;

    private final GatherStructure structure;
    /** Number of weights of each row, two rows in a byte: the first one in the lower half. */
    private final byte[] counts;
    private final int rows;
    private final WeightedPoints near;
    /** Weights of reflection points for the same rows; null if the structure has none. */
    private final @Nullable RowWeights reflected;

    /**
     * Creates the weights of some rows.
     *
     * @param structure that the points belong to
     * @param points    points that any row uses
     * @param index     index among these, {@code short[8 * rows]}
     * @param weight    unsigned weights, {@code byte[8 * rows]}. The largest of each row is 255, if there is any point; nothing follows a
     *                  weight of 0.
     * @param reflected weights of reflection points for the same rows
     */
    RowWeights(GatherStructure structure, int[] points, short[] index, byte[] weight, @Nullable RowWeights reflected) {
        this.structure = structure;
        this.reflected = reflected;
        rows = weight.length / PER_ROW;
        counts = new byte[(rows + 1) / 2];
        int entries = 0;
        for (int row = 0; row < rows; row++) {
            int n = 0;
            while (n < PER_ROW && weight[PER_ROW * row + n] != 0) {
                n++;
            }
            counts[row / 2] |= (byte) (n << HALF_BYTE * (row % 2));
            entries += n;
        }
        WeightedPoints.Builder builder = new WeightedPoints.Builder(points.length, entries);
        for (int row = 0; row < rows; row++) {
            for (int i = PER_ROW * row, end = i + count(row); i < end; i++) {
                builder.add(index[i] & 0xFFFF, points[index[i] & 0xFFFF], weight[i] & 0xFF);
            }
        }
        near = builder.build();
    }

    private RowWeights(GatherStructure structure, int rows, byte[] counts, WeightedPoints near, @Nullable RowWeights reflected) {
        this.reflected = reflected;
        this.structure = structure;
        this.rows = rows;
        this.counts = counts;
        this.near = near;
    }

    private int count(int row) {
        return counts[row / 2] >> HALF_BYTE * (row % 2) & MAX_COUNT;
    }

    /** Writes all but the structure. */
    public void writeTo(ColumnWriter out) throws IOException {
        out.writeInt(rows);
        out.writeArray(counts);
        near.writeTo(out);
        if (structure.reflections() != null && reflected != null) {
            reflected.writeTo(out);
        }
    }

    /**
     * Reads weights.
     *
     * @param structure that the points belong to
     * @throws IOException if the data is truncated
     */
    public static RowWeights readFrom(ColumnReader in, GatherStructure structure) throws IOException {
        int rows = in.readInt();
        byte[] counts = in.readBytes();
        WeightedPoints near = WeightedPoints.readFrom(in);
        RowWeights reflected = structure.reflections() == null ? null
                : new RowWeights(structure, in.readInt(), in.readBytes(), WeightedPoints.readFrom(in), null);
        return new RowWeights(structure, rows, counts, near, reflected);
    }

    /** Returns the structure that the points belong to. */
    public GatherStructure structure() {
        return structure;
    }

    /** Returns whether any of the points is marked; reflection points come after gather points. */
    public boolean touches(boolean[] marked) {
        return touches(marked, 0) || reflected != null && reflected.touches(marked, structure.pointCount());
    }

    private boolean touches(boolean[] marked, int offset) {
        for (int p : near.points()) {
            if (marked[offset + p]) {
                return true;
            }
        }
        return false;
    }

    /** Returns the weights of reflection points for the same rows; null if there are none. */
    public @Nullable RowWeights reflected() {
        return reflected;
    }

    /**
     * Writes the indirect light of rows: for each the weighted mean of the points' light.
     *
     * @param light red, green and blue light of all gather points
     * @param to    receives red, green and blue of each row
     */
    public void interpolate(float[][] light, float[][] to) {
        float[] values = new float[4 * WeightedPoints.TABLE_SIZE];
        byte[] index = near.index;
        byte[] weight = near.weight;
        int table = -1;
        int tableEnd = 0;
        int i = 0;
        for (int row = 0; row < rows; row++) {
            float red = 0;
            float green = 0;
            float blue = 0;
            int total = 0;
            for (int end = i + count(row); i < end;) {
                if (i == tableEnd) {
                    load(++table, light, values);
                    tableEnd = near.endEntry(table);
                }
                for (int stop = Math.min(end, tableEnd); i < stop; i++) {
                    int whole = weight[i] & 0xFF;
                    float w = whole * WeightedPoints.SCALE;
                    int at = 4 * (index[i] & 0xFF);
                    red += w * values[at];
                    green += w * values[at + 1];
                    blue += w * values[at + 2];
                    total += whole;
                }
            }
            float scale = total == 0 ? 0 : 1 / (total * WeightedPoints.SCALE);
            to[0][row] = red * scale;
            to[1][row] = green * scale;
            to[2][row] = blue * scale;
        }
    }

    /**
     * Writes what rows reflect of their surroundings, if the structure has reflection points.
     *
     * @param light that of all points; elements 3 to 8 are those of reflection points
     * @param to    receives the six columns
     */
    public void interpolateReflected(float[][] light, float[][] to) {
        if (reflected != null) {
            reflected.interpolate(Arrays.copyOfRange(light, 3, 6), to);
            reflected.interpolate(Arrays.copyOfRange(light, 6, 9), Arrays.copyOfRange(to, 3, 6));
        }
    }

    private void load(int table, float[][] light, float[] to) {
        int first = near.firstPoint(table);
        int end = near.firstPoint(table + 1);
        for (int c = 0; c < 3; c++) {
            for (int i = first; i < end; i++) {
                to[4 * (i - first) + c] = light[c][near.points()[i]];
            }
        }
    }

    /**
     * Writes the light of one row, with the bits of {@link #interpolate(float[][], float[][])}, to red, green and blue, and, if there are
     * reflection points, what it reflects to six more elements.
     */
    public void interpolate(float[][] light, int row, float[] to) {
        interpolate(light, 0, row, to);
        if (reflected != null) {
            reflected.interpolate(light, 3, row, to);
            reflected.interpolate(light, 6, row, to);
        }
    }

    /** @param at first of three columns and elements */
    private void interpolate(float[][] light, int at, int row, float[] to) {
        int first = 0;
        for (int before = 0; before < row; before++) {
            first += count(before);
        }
        int total = 0;
        Arrays.fill(to, at, at + 3, 0);
        for (int i = first; i < first + count(row); i++) {
            int point = near.point(i);
            int whole = near.weight[i] & 0xFF;
            for (int c = at; c < at + 3; c++) {
                to[c] += whole * WeightedPoints.SCALE * light[c][point];
            }
            total += whole;
        }
        for (int c = at; c < at + 3; c++) {
            to[c] *= total == 0 ? 0 : 1 / (total * WeightedPoints.SCALE);
        }
    }

    /** Returns for each row the point that alone has a weight there; −1 if there are several. */
    int[] onlyPoints() {
        int[] only = new int[rows];
        int entry = 0;
        for (int row = 0; row < only.length; row++) {
            only[row] = count(row) == 1 ? near.point(entry) : -1;
            entry += count(row);
        }
        return only;
    }

    /**
     * Returns these weights with other numbers of the gather points; null if one has none.
     *
     * @param weigher finds the reflection points of the rows, of which nothing is known without their rays
     */
    @Nullable
    RowWeights renumbered(GatherStructure to, int[] newNumber, HitRows its, RowWeigher weigher) {
        WeightedPoints renumbered = near.renumbered(newNumber);
        return renumbered == null ? null : new RowWeights(to, rows, counts, renumbered, weigher.weighReflections(its));
    }

    /** Returns the bytes of all columns. */
    public long bytes() {
        return counts.length + near.bytes() + (reflected == null ? 0 : reflected.bytes());
    }
}
