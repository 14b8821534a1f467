package lightning.render.gather.reflection;

import java.io.IOException;
import lightning.render.column.ColumnReader;
import lightning.render.column.ColumnWriter;

/**
 * What a repetition after an edit must know of paths of reflections ({@link ReflectionMemo}).
 *
 * @param seed           of the directions of each point
 * @param inverseLengths sum of the {@link lightning.render.gather.ray.InverseLengths} of each point
 * @param firstCopy      number of the first copy of each point; the copies of the next point follow
 * @param firstRay       for each surfel the ray whose hit it is; −1 if that is no ray of a reflection
 * @param partKeys       keys of the parts of surfels
 */
public record ReflectionOrigins(long[] seed, long[] inverseLengths, int[] firstCopy, int[] firstRay, long[] partKeys) {
    // Arrays in a record: written once by their creator, never after.

    void writeTo(ColumnWriter out) throws IOException {
        out.writeArray(seed);
        out.writeArray(inverseLengths);
        out.writeArray(firstCopy);
        out.writeArray(firstRay);
        out.writeArray(partKeys);
    }

    static ReflectionOrigins readFrom(ColumnReader in) throws IOException {
        return new ReflectionOrigins(in.readLongs(), in.readLongs(), in.readInts(), in.readInts(), in.readLongs());
    }

    long bytes() {
        return 20L * seed.length + 4L * firstRay.length + 8L * partKeys.length;
    }
}
