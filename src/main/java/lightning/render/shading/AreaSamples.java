package lightning.render.shading;

import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.scene.AreaShape;
import lightning.scene.Light;
import lightning.scene.LightType;

/**
 * The points of a light that is larger than a point, in render space, or the unit vectors towards a directional one: its light
 * is the mean of theirs.
 *
 * <p>Sample s of n is a place in the unit square: ((s + ½)/n + a, s·0.618… + b), both modulo 1, where 0.618… is the golden section.
 * One of {@link #ROTATIONS} pairs (a, b) is a row's <em>turn</em> (Cranley and Patterson 1976 call it a rotation), told by a hash of its
 * point: neighbors look at different samples, and the same picture always at the same ones. Turn t has (t·0.754…, t·0.569…), the two
 * powers of the reciprocal of the plastic number (Roberts 2018). The square is then laid
 *
 * <ul>
 * <li>on a rectangle as it is;
 * <li>on a disc by (√u, 2πv), polar;
 * <li>on the ball that a point or spot light is by its height 1 − 2u along y and the longitude 2πv (Archimedes);
 * <li>on the cap of directions by the cosine 1 − u·(1 − cos spread) and the longitude.
 * </ul>
 */
public final class AreaSamples {
    /** How many patterns of samples there are. */
    public static final int ROTATIONS = 16;

    private static final double GOLDEN = 0.6180339887498949;
    private static final double PLASTIC = 0.7548776662466927;
    private static final double PLASTIC_SQUARED = 0.5698402909980532;

    private final int count;
    /** That of turn t's sample s at {@code TURNS·s + t}; not to be written. */
    public final double[] x;
    public final double[] y;
    public final double[] z;
    private final double extent;
    private final Vec3 min;
    private final Vec3 max;

    private AreaSamples(Vec3 center, Vec3[] offsets) {
        count = offsets.length / ROTATIONS;
        x = new double[offsets.length];
        y = new double[offsets.length];
        z = new double[offsets.length];
        double farthest = 0;
        Vec3 minPoint = new Vec3(Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY);
        Vec3 maxPoint = minPoint.negated();
        for (int i = 0; i < offsets.length; i++) {
            Vec3 at = center.plus(offsets[i]);
            x[i] = at.x();
            y[i] = at.y();
            z[i] = at.z();
            farthest = Math.max(farthest, offsets[i].length());
            minPoint = new Vec3(Math.min(minPoint.x(), at.x()), Math.min(minPoint.y(), at.y()), Math.min(minPoint.z(), at.z()));
            maxPoint = new Vec3(Math.max(maxPoint.x(), at.x()), Math.max(maxPoint.y(), at.y()), Math.max(maxPoint.z(), at.z()));
        }
        extent = farthest;
        min = minPoint;
        max = maxPoint;
    }

    /**
     * That of a light which {@link Light#isArea}.
     *
     * @param source its center; for a directional light the unit vector towards it
     * @param axis   the unit direction in which it shines
     */
    static AreaSamples of(Light light, Vec3 source, Vec3 axis) {
        AreaShape area = light.area();
        int n = area.samples();
        // What is round looks the same whatever its up.
        Vec3 right = (light.type() == LightType.RECT ? area : AreaShape.DEFAULT).right(axis);
        Vec3 top = right.cross(axis);
        Vec3[] offsets = new Vec3[n * ROTATIONS];
        for (int t = 0; t < ROTATIONS; t++) {
            for (int s = 0; s < n; s++) {
                double u = fraction((s + 0.5) / n + t * PLASTIC);
                double v = fraction(s * GOLDEN + t * PLASTIC_SQUARED);
                offsets[ROTATIONS * s + t] = switch (light.type()) {
                    case RECT -> right.times((u - 0.5) * area.width()).plus(top.times((v - 0.5) * area.height()));
                    case DISC -> onCircle(right, top, area.radius() * Math.sqrt(u), v);
                    case POINT, SPOT -> onCircle(new Vec3(1, 0, 0), new Vec3(0, 0, 1), area.radius() * 2 * Math.sqrt(u * (1 - u)), v)
                            .plus(new Vec3(0, area.radius() * (1 - 2 * u), 0));
                    case DIRECTIONAL -> {
                        double cos = 1 - u * (1 - Transform.cosDegrees(area.spread()));
                        Vec3 toward = source.times(cos).plus(onCircle(right, top, Math.sqrt(Math.max(0, 1 - cos * cos)), v));
                        yield toward.normalized().minus(source);
                    }
                };
            }
        }
        return new AreaSamples(source, offsets);
    }

    private static Vec3 onCircle(Vec3 right, Vec3 top, double radius, double rotation) {
        return right.times(radius * Transform.cosDegrees(360 * rotation)).plus(top.times(radius * Transform.sinDegrees(360 * rotation)));
    }

    private static double fraction(double v) {
        return v - Math.floor(v);
    }

    /** The turn of a row: the upper bits of a hash of its point's, each coordinate's sign of zero left out. */
    static int rotation(float px, float py, float pz) {
        int h = Float.floatToRawIntBits(px + 0f) * 0x9E3779B1 + Float.floatToRawIntBits(py + 0f) * 0x85EBCA77
                + Float.floatToRawIntBits(pz + 0f) * 0xC2B2AE3D;
        h = (h ^ h >>> 15) * 0x2C1B3C6D;
        return (h ^ h >>> 12) * 0x297A2D39 >>> 28;
    }

    /** Which place rows of a turn have of sample {@code s}. */
    public static int index(int s, double rotation) {
        return ROTATIONS * s + (int) rotation;
    }

    /** How many there are for a row. */
    public int samples() {
        return count;
    }

    /** Where a row of a turn sees sample {@code s}. */
    Vec3 position(int rotation, int s) {
        int i = ROTATIONS * s + rotation;
        return new Vec3(x[i], y[i], z[i]);
    }

    /** How far any of them is from the center at most. */
    public double extent() {
        return extent;
    }

    /** The least coordinates of all. */
    Vec3 low() {
        return min;
    }

    /** The greatest coordinates of all. */
    Vec3 high() {
        return max;
    }
}
