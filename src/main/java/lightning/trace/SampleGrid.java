package lightning.trace;

/** Where the samples of a pixel lie that has several: in the middles of the cells of a regular grid. */
final class SampleGrid {
    private SampleGrid() {}

    /** How far column or line {@code cell} of a grid lies from the left or upper side of its pixel, in pixels. */
    static double offset(int cell, int grid) {
        return (2 * cell + 1) / (2.0 * grid);
    }
}
