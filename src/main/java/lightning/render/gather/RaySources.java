package lightning.render.gather;

/**
 * Points that cast rays: gather points or surfels.
 *
 * @param surface    places and normals
 * @param levelStart first gather point in cells of each size, {@link Integer#MAX_VALUE} for later ones; null for surfels
 */
record RaySources(SurfaceColumns surface, int[] levelStart) {
    // An array in a record: written by its creator alone.

    /** Returns the seed of a point's directions. */
    long seed(int p) {
        float x = surface.px[p];
        float y = surface.py[p];
        float z = surface.pz[p];
        return levelStart == null ? RaySeed.ofSurfel(x, y, z) : RaySeed.ofPoint(x, y, z, level(p));
    }

    private int level(int p) {
        int level = 0;
        while (level + 1 < levelStart.length && p >= levelStart[level + 1]) {
            level++;
        }
        return level;
    }

    /** Writes the directions of a point's rays to elements {@code at …}. */
    void writeDirections(int p, DirectionTable directions, double[] toX, double[] toY, double[] toZ, int at) {
        directions.write(seed(p), surface.nx[p], surface.ny[p], surface.nz[p], toX, toY, toZ, at);
    }
}
