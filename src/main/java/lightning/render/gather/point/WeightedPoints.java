package lightning.render.gather.point;

import java.io.IOException;
import java.util.Arrays;
import lightning.render.column.ColumnReader;
import lightning.render.column.ColumnWriter;
import org.jspecify.annotations.Nullable;

/**
 * Lists of weighted gather points in little more than two bytes per entry. Lists follow each other, and consecutive entries share a table
 * of up to 256 points. Immutable.
 *
 * @param points     points of all tables, one table after the other
 * @param firstEntry first entry of each table, and the number of all entries
 * @param firstPoint first point of each table, and the number of all points
 * @param index      index of each entry's point in its table, unsigned
 * @param weight     weight of each entry, unsigned
 */
public record WeightedPoints(int[] points, int[] firstEntry, int[] firstPoint, byte[] index, byte[] weight) {
    /** Factor of weights while they are added up, so that no sum of the brightest light overflows. A power of two, so it rounds nothing. */
    public static final float SCALE = 0x1p-24f;
    /** Largest weight. */
    public static final int MAX_WEIGHT = 255;
    /** Smallest weight that is kept: less than 1.6 % of the largest one changes nothing that is seen, but takes memory and time. */
    private static final int MIN_WEIGHT = 4;
    /** Maximum number of points in a table. */
    public static final int TABLE_SIZE = 256;

    public void writeTo(ColumnWriter out) throws IOException {
        out.writeArray(points);
        out.writeArray(firstEntry);
        out.writeArray(firstPoint);
        out.writeArray(index);
        out.writeArray(weight);
    }

    public static WeightedPoints readFrom(ColumnReader in) throws IOException {
        return new WeightedPoints(in.readInts(), in.readInts(), in.readInts(), in.readBytes(), in.readBytes());
    }

    /** Returns these lists with other numbers of the points; null if one has none. */
    @Nullable
    public WeightedPoints renumbered(int[] newNumber) {
        int[] renumbered = new int[points.length];
        for (int i = 0; i < points.length; i++) {
            renumbered[i] = newNumber[points[i]];
            if (renumbered[i] < 0) {
                return null;
            }
        }
        return new WeightedPoints(renumbered, firstEntry, firstPoint, index, weight);
    }

    /**
     * Returns a weight as a whole number; 0 if it is left out.
     *
     * @param scale {@link #MAX_WEIGHT} relative to the largest weight of the list
     */
    public static int whole(float weight, float scale) {
        int rounded = (int) (weight * scale + 0.5f);
        return rounded < MIN_WEIGHT ? 0 : Math.min(MAX_WEIGHT, rounded);
    }

    /** Returns the point of an entry. */
    public int point(int entry) {
        int table = 0;
        while (firstEntry[table + 1] <= entry) {
            table++;
        }
        return points[firstPoint[table] + (index[entry] & 0xFF)];
    }

    /** Builds lists entry by entry. */
    public static final class Builder {
        private int[] points = new int[TABLE_SIZE];
        private int pointCount;
        private int[] firstEntry = {0};
        private int[] firstPoint = {0};
        private int tables = 1;
        /** Position of each point in {@link #points}, by its identifier. Valid if it lies in the last table and the identifier fits. */
        private final int[] position;
        private final int[] identifier = new int[TABLE_SIZE];
        private final byte[] index;
        private final byte[] weight;
        private int entries;

        /**
         * @param identifiers number of identifiers of points
         * @param maxEntries  maximum number of entries
         */
        public Builder(int identifiers, int maxEntries) {
            position = new int[identifiers];
            index = new byte[maxEntries];
            weight = new byte[maxEntries];
        }

        /** Returns the number of entries added so far. */
        int entries() {
            return entries;
        }

        /**
         * Adds an entry.
         *
         * @param id    identifier of its point
         * @param value weight, 1…{@link #MAX_WEIGHT}
         */
        public void add(int id, int point, int value) {
            int at = position[id] - firstPoint[tables - 1];
            if (at < 0 || at >= pointCount - firstPoint[tables - 1] || identifier[at] != id) {
                at = addPoint(id, point);
            }
            index[entries] = (byte) at;
            weight[entries++] = (byte) value;
        }

        private int addPoint(int id, int point) {
            if (pointCount - firstPoint[tables - 1] == TABLE_SIZE) {
                firstEntry = append(firstEntry, tables, entries);
                firstPoint = append(firstPoint, tables, pointCount);
                tables++;
            }
            points = append(points, pointCount, point);
            position[id] = pointCount;
            int at = pointCount++ - firstPoint[tables - 1];
            identifier[at] = id;
            return at;
        }

        private static int[] append(int[] array, int count, int value) {
            int[] longer = count < array.length ? array : Arrays.copyOf(array, 2 * count);
            longer[count] = value;
            return longer;
        }

        public WeightedPoints build() {
            return new WeightedPoints(Arrays.copyOf(points, pointCount), Arrays.copyOf(append(firstEntry, tables, entries), tables + 1),
                    Arrays.copyOf(append(firstPoint, tables, pointCount), tables + 1),
                    entries == index.length ? index : Arrays.copyOf(index, entries),
                    entries == weight.length ? weight : Arrays.copyOf(weight, entries));
        }
    }

    int tableCount() {
        return firstPoint.length - 1;
    }

    /** Returns the table of an entry. */
    int tableOf(int entry) {
        int found = Arrays.binarySearch(firstEntry, 0, tableCount(), entry);
        return found >= 0 ? found : -found - 2;
    }

    /** Returns the entry after the last one of a table. */
    public int endEntry(int table) {
        return firstEntry[table + 1];
    }

    public int firstPoint(int table) {
        return firstPoint[table];
    }

    /** Returns the bytes of all columns. */
    public long bytes() {
        return 4L * points.length + 8L * firstEntry.length + index.length + weight.length;
    }
}
