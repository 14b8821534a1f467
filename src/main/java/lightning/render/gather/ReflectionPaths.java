package lightning.render.gather;

import java.io.IOException;
import lightning.render.column.ColumnReader;
import lightning.render.column.ColumnWriter;
import org.jspecify.annotations.Nullable;

/** Paths of blurred reflections: from surfels and the sky to reflection points to rows. Immutable. */
public final class ReflectionPaths {
    private final ReflectionPoints points;
    private final ReflectionLinks links;
    private final ReflectionGroup[] groups;
    private final PointFilter filter;
    private final float[] steps;
    /** For each part of a surfel the surfel that it belongs to. */
    private final int[] surfelOfDetail;

    /** @param steps width of the cells of directions by material; 0 for materials that do not blur reflections */
    ReflectionPaths(ReflectionPoints points, ReflectionLinks links, ReflectionGroup[] groups, PointFilter filter, float[] steps,
            int[] surfelOfDetail) {
        this.points = points;
        this.links = links;
        this.groups = groups;
        this.filter = filter;
        this.steps = steps;
        this.surfelOfDetail = surfelOfDetail;
    }

    void writeTo(ColumnWriter out) throws IOException {
        points.writeTo(out);
        links.writeTo(out);
        filter.writeTo(out);
        out.writeArray(steps);
        out.writeArray(surfelOfDetail);
    }

    static ReflectionPaths readFrom(ColumnReader in, CellKeys keys) throws IOException {
        ReflectionPoints points = ReflectionPoints.readFrom(in, keys);
        ReflectionLinks links = ReflectionLinks.readFrom(in);
        PointFilter filter = PointFilter.readFrom(in);
        float[] steps = in.readFloats();
        return new ReflectionPaths(points, links, ReflectionGroup.of(points, steps), filter, steps, in.readInts());
    }

    /** Returns the number of reflection points. */
    public int count() {
        return points.count();
    }

    /** Returns what the rays meet. */
    public ReflectionLinks links() {
        return links;
    }

    /** Returns for each part of a surfel, which are the last surfels, the surfel that it belongs to. Callers must not modify it. */
    public int[] surfelOfDetail() {
        return surfelOfDetail;
    }

    /** Returns the points of a material; null if it does not blur reflections. */
    @Nullable
    ReflectionGroup group(int material) {
        return material < steps.length && steps[material] > 0 ? groups[material] : null;
    }

    /**
     * Writes the means over the neighbors of points {@code first … end − 1}; parameters as {@link GatherStructure#filter}.
     */
    public void filter(float[] from, float[][] to, int first, int end) {
        filter.apply(from, to, first, end);
    }

    long bytes() {
        return points.bytes() + links.bytes() + filter.bytes() + 68L * points.count() + 4L * surfelOfDetail.length;
    }
}
