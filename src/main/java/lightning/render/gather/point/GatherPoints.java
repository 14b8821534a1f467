package lightning.render.gather.point;

import java.io.IOException;
import lightning.render.column.ColumnReader;
import lightning.render.column.ColumnWriter;
import lightning.render.gather.cell.CellKeys;
import lightning.render.gather.cell.SurfaceColumns;
import lightning.render.gather.ray.RaySources;

/**
 * Points at which light is gathered.
 *
 * @param sources        places and normals
 * @param inverseLengths sum of the {@link lightning.render.gather.ray.InverseLengths} of each point's rays
 * @param radius         distance from each point at which its weight is 0, scene units
 * @param groups         finds points within their radius
 * @param barriers       separate points from places behind walls
 * @param filter         means over neighbors
 */
public record GatherPoints(RaySources sources, long[] inverseLengths, float[] radius, PointGroups groups, Barriers barriers,
        PointFilter filter) {
    // Arrays in a record: written once by their creator, never after.

    /** Writes all but the groups, which are made again. */
    public void writeTo(ColumnWriter out) throws IOException {
        sources.writeTo(out);
        out.writeArray(inverseLengths);
        out.writeArray(radius);
        barriers.writeTo(out);
        filter.writeTo(out);
    }

    public static GatherPoints readFrom(ColumnReader in, CellKeys keys) throws IOException {
        RaySources sources = RaySources.readFrom(in, keys);
        long[] inverseLengths = in.readLongs();
        float[] radius = in.readFloats();
        return new GatherPoints(sources, inverseLengths, radius, new PointGroups(sources.surface, radius), Barriers.readFrom(in),
                PointFilter.readFrom(in));
    }

    /** Returns {@link PointWeight#distance} from a place, made much larger if a barrier separates the point from it. */
    public float distance(int p, float x, float y, float z, float nx, float ny, float nz) {
        return PointWeight.distance(surface(), p, barriers, x, y, z, nx, ny, nz);
    }

    public SurfaceColumns surface() {
        return sources.surface;
    }

    public int count() {
        return surface().count;
    }
}
