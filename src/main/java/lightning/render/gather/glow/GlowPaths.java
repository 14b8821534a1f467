package lightning.render.gather.glow;

import java.io.IOException;
import lightning.render.column.ColumnReader;
import lightning.render.column.ColumnWriter;

/**
 * Paths from small glowing objects to points and surfels. Immutable.
 *
 * @param shapes    the objects
 * @param ofPoints  shares of their light that gather points receive
 * @param ofSurfels shares of their light that the first surfels receive; later surfels have no rays
 * @param surfels   surfels on these objects, ascending; rays that do not count their glow have numbers of their own
 */
public record GlowPaths(GlowShapes shapes, GlowLinks ofPoints, GlowLinks ofSurfels, int[] surfels) {
    // Arrays in a record: written once by their creator, never after.

    /** Writes all but the objects. */
    public void writeTo(ColumnWriter out) throws IOException {
        ofPoints.writeTo(out);
        ofSurfels.writeTo(out);
        out.writeArray(surfels);
    }

    public static GlowPaths readFrom(ColumnReader in, GlowShapes shapes) throws IOException {
        return new GlowPaths(shapes, GlowLinks.readFrom(in), GlowLinks.readFrom(in), in.readInts());
    }

    /** Returns the bytes of the paths to gather points. */
    public long pointBytes() {
        return ofPoints.bytes();
    }

    /** Returns the bytes of the other paths. */
    public long surfelBytes() {
        return ofSurfels.bytes() + 4L * surfels.length;
    }
}
