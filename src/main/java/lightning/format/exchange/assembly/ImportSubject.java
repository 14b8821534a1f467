package lightning.format.exchange.assembly;

import java.util.stream.IntStream;
import java.util.stream.Stream;
import lightning.base.math.Vec3;

/**
 * Contents of an imported file.
 *
 * @param min lowest corner of the bounding box of all objects, scene units
 * @param max highest corner
 * @param hasCamera if the file has a camera that was imported
 * @param hasLights if the file has lights that were imported
 */
public record ImportSubject(Vec3 min, Vec3 max, boolean hasCamera, boolean hasLights) {
    public Vec3 center() {
        return min.plus(max).times(0.5);
    }

    /** Returns half the diagonal; 1 for a point. */
    public double radius() {
        double radius = max.minus(min).length() / 2;
        return radius > 0 ? radius : 1;
    }

    /** Returns the eight corners of the bounding box. */
    public Stream<Vec3> corners() {
        return IntStream.range(0, 8).mapToObj(i -> new Vec3((i & 1) == 0 ? min.x() : max.x(), (i & 2) == 0 ? min.y() : max.y(),
                (i & 4) == 0 ? min.z() : max.z()));
    }
}
