package lightning.render.gather;

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

    /** Returns the bytes of the paths to gather points. */
    long pointBytes() {
        return ofPoints.bytes();
    }

    /** Returns the bytes of the other paths. */
    long surfelBytes() {
        return ofSurfels.bytes() + 4L * surfels.length;
    }
}
