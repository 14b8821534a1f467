package lightning.render.gather;

import java.io.IOException;
import java.util.Arrays;
import lightning.render.column.ColumnReader;
import lightning.render.column.ColumnWriter;
import lightning.render.gather.point.WeightedPoints;
import lightning.render.gather.ray.FilmKernel;
import lightning.render.gather.ray.FilmLight;
import lightning.render.trace.HitRows;
import org.jspecify.annotations.Nullable;

/** Weights of the gather points near each row of a level: at most eight for each, fixed like the rows. Immutable. */
public final class RowWeights {
    static final int PER_ROW = 8;
    private static final int HALF_BYTE = 4;
    private static final int MAX_COUNT = 15;
    /** Rows whose light stays in the cache of a processor while it is written. */
    private static final int BATCH = 64;
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
     * @param light red, green and blue light of all gather points in each film, at most {@link FilmLight#MAX_FILMS}
     * @param first first of these three elements
     * @param to    receives red, green and blue of each row in each film, from the same element on
     */
    private void interpolate(float[][][] light, int first, FilmKernel kernel, float[][][] to) {
        FilmLight values = load(light, first);
        FilmLight means = FilmLight.black(light.length, BATCH);
        float[] sum = new float[FilmLight.MAX_STRIDE];
        int[] number = new int[PER_ROW];
        float[] share = new float[PER_ROW];
        float[] scale = new float[BATCH];
        int table = 0;
        int entry = 0;
        for (int row = 0; row < rows; row++) {
            int count = count(row);
            int total = 0;
            for (int k = 0; k < count; k++, entry++) {
                table += entry == near.endEntry(table) ? 1 : 0;
                int whole = near.weight()[entry] & 0xFF;
                number[k] = near.firstPoint(table) + (near.index()[entry] & 0xFF);
                share[k] = whole * WeightedPoints.SCALE;
                total += whole;
            }
            int place = row % BATCH;
            scale[place] = total == 0 ? 0 : 1 / (total * WeightedPoints.SCALE);
            if (count > 0) {
                kernel.weightedSum(values, number, share, count, sum);
                means.set(place, sum);
            }
            if (place == BATCH - 1 || row == rows - 1) {
                write(means, scale, place + 1, row - place, first, to);
            }
        }
    }

    /** Writes consecutive rows. @param start first of them */
    private static void write(FilmLight means, float[] scale, int count, int start, int first, float[][][] to) {
        float[] values = means.values();
        int stride = means.stride();
        for (int film = 0; film < means.films(); film++) {
            for (int c = 0; c < 3; c++) {
                float[] column = to[film][first + c];
                int at = 3 * film + c;
                for (int i = 0; i < count; i++) {
                    column[start + i] = values[at + stride * i] * scale[i];
                }
            }
        }
    }

    /**
     * Writes the indirect light of rows in some films, and, if there are reflection points, what the rows reflect of their surroundings.
     *
     * @param light of all points in each film, at most {@link FilmLight#MAX_FILMS}: red, green and blue, then the six columns of reflection
     *              points
     * @param to    receives as many columns for each
     */
    public void interpolate(float[][][] light, FilmKernel kernel, float[][][] to) {
        interpolate(light, 0, kernel, to);
        if (reflected != null) {
            reflected.interpolate(light, 3, kernel, to);
            reflected.interpolate(light, 6, kernel, to);
        }
    }

    /** Returns the light of the near points side by side. */
    private FilmLight load(float[][][] light, int first) {
        int[] points = near.points();
        FilmLight values = FilmLight.black(light.length, points.length);
        for (int film = 0; film < light.length; film++) {
            float[] red = light[film][first];
            float[] green = light[film][first + 1];
            float[] blue = light[film][first + 2];
            for (int i = 0; i < points.length; i++) {
                values.set(i, film, red[points[i]], green[points[i]], blue[points[i]]);
            }
        }
        return values;
    }

    /**
     * Writes the light of one row, with the bits of {@link #interpolate(float[][][], FilmKernel, float[][][])}, to red, green and blue, and, if there are
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
            int whole = near.weight()[i] & 0xFF;
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
