package lightning.render.gather;

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

    SurfaceColumns surface() {
        return sources.surface;
    }

    int count() {
        return surface().count;
    }
}
