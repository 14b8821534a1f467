package lightning.render.gather;

import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import lightning.render.column.ColumnReader;
import lightning.render.column.ColumnWriter;

/**
 * Numbers of rays that find the paths of gathered light and of blurred reflections.
 *
 * @param candidates  rays from the camera and its mirrors, which find the surfaces among which points are chosen
 * @param points      rays of gather points, those aimed at glowing objects and through the rims of openings included
 * @param reflections rays of reflection points
 * @param surfels     rays cast once more, for the rows of surfels
 * @param bounces     rays of surfels, by bounce: the first gather light for the second bounce
 */
public record GatherRays(long candidates, long points, long reflections, long surfels, List<Long> bounces) {
    private static final int KINDS = 4;
    public static final GatherRays NONE = new GatherRays(0, 0, 0, 0, List.of());

    public GatherRays {
        bounces = List.copyOf(bounces);
    }

    public long total() {
        return candidates + points + reflections + surfels + bounces.stream().mapToLong(Long::longValue).sum();
    }

    public GatherRays plus(GatherRays o) {
        return plus(o, 1);
    }

    public GatherRays minus(GatherRays o) {
        return plus(o, -1);
    }

    private GatherRays plus(GatherRays o, int sign) {
        List<Long> sums = IntStream.range(0, Math.max(bounces.size(), o.bounces.size()))
                .mapToObj(i -> bounce(i) + sign * o.bounce(i)).toList();
        return new GatherRays(candidates + sign * o.candidates, points + sign * o.points, reflections + sign * o.reflections,
                surfels + sign * o.surfels, sums);
    }

    void writeTo(ColumnWriter out) throws IOException {
        out.writeArray(
                Stream.concat(Stream.of(candidates, points, reflections, surfels), bounces.stream()).mapToLong(Long::longValue).toArray());
    }

    static GatherRays readFrom(ColumnReader in) throws IOException {
        long[] counts = in.readLongs();
        if (counts.length < KINDS) {
            throw new IOException("expected " + KINDS + " numbers of rays, found " + counts.length);
        }
        return new GatherRays(counts[0], counts[1], counts[2], counts[3], Arrays.stream(counts, KINDS, counts.length).boxed().toList());
    }

    private long bounce(int i) {
        return i < bounces.size() ? bounces.get(i) : 0;
    }
}
