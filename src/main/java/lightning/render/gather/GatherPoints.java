package lightning.render.gather;

import java.io.IOException;
import lightning.render.column.ColumnReader;
import lightning.render.column.ColumnWriter;

/**
 * Points at which light is gathered.
 *
 * @param sources        places and normals
 * @param inverseLengths sum of the {@link InverseLengths} of each point's rays
 * @param radius         distance from each point at which its weight is 0, scene units
 * @param groups         finds points within their radius
 * @param filter         means over neighbors
 */
record GatherPoints(RaySources sources, long[] inverseLengths, float[] radius, PointGroups groups, PointFilter filter) {
    // Arrays in a record: written once by their creator, never after.

    /** Writes all but the groups, which are made again. */
    void writeTo(ColumnWriter out) throws IOException {
        sources.writeTo(out);
        out.writeArray(inverseLengths);
        out.writeArray(radius);
        filter.writeTo(out);
    }

    static GatherPoints readFrom(ColumnReader in, CellKeys keys) throws IOException {
        RaySources sources = RaySources.readFrom(in, keys);
        long[] inverseLengths = in.readLongs();
        float[] radius = in.readFloats();
        return new GatherPoints(sources, inverseLengths, radius, new PointGroups(sources.surface, radius), PointFilter.readFrom(in));
    }

    SurfaceColumns surface() {
        return sources.surface;
    }

    int count() {
        return surface().count;
    }
}
