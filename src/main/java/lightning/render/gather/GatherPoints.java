package lightning.render.gather;

/**
 * Points at which light is gathered.
 *
 * @param surface places and normals
 * @param radius  distance from each point at which its weight is 0, scene units
 * @param groups  finds points within their radius
 * @param filter  means over neighbors
 */
record GatherPoints(SurfaceColumns surface, float[] radius, PointGroups groups, PointFilter filter) {
    // An array in a record: written once by its creator, never after.

    int count() {
        return surface.count;
    }
}
