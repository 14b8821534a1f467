package lightning.scene.value;

import java.util.Arrays;
import lightning.base.file.ContentDigest;

/**
 * Luminous intensities over two angles, relative to the maximum: 0…1. Immutable.
 *
 * <p>Half planes share a common axis; a direction is an angle in one of them. For {@link Type#C} the axis is that of the light, the plane's
 * angle is 0 … 360 degrees and the direction's 0 … 180 from the axis. For {@link Type#A} and {@link Type#B} both are −90 … 90 (ANSI/IESNA
 * LM-63-02, 3 and 5).
 */
public final class Photometry implements ContentDigest.Content {
    /** Axis shared by the planes: vertical, horizontal, or that of the light. */
    public enum Type {
        A,
        B,
        C
    }

    private final Type type;
    private final double[] vertical;
    private final double[] horizontal;
    private final float[] relative;

    /**
     * @param vertical   degrees, increasing
     * @param horizontal degrees, increasing; for type C from 0 to 0, 90, 180, 360, or from 90 to 270; for the others −90 or 0 to 90, or 0
     *     alone
     * @param candela    ≥ 0, finite, at least one above 0: all values of the first horizontal angle, then of the next; copied
     */
    public Photometry(Type type, double[] vertical, double[] horizontal, double[] candela) {
        if (candela.length != vertical.length * horizontal.length || vertical.length == 0) {
            throw new IllegalArgumentException(candela.length + " values at " + vertical.length + "×" + horizontal.length + " angles");
        }
        this.type = type;
        this.vertical = vertical.clone();
        this.horizontal = horizontal.clone();
        double max = Arrays.stream(candela).max().orElseThrow();
        relative = new float[candela.length];
        for (int i = 0; i < relative.length; i++) {
            relative[i] = (float) (candela[i] / max);
        }
    }

    public Type type() {
        return type;
    }

    /**
     * Returns the relative intensity in a direction, bilinear between the angles; 0 outside the vertical range.
     *
     * @param verticalAngle   vertical angle in degrees: type C 0…180, others −180…180
     * @param horizontalAngle horizontal angle in degrees: type C 0…360, others −180…180
     */
    public double sample(double verticalAngle, double horizontalAngle) {
        double v = type != Type.C && vertical[0] >= 0 ? Math.abs(verticalAngle) : verticalAngle;
        double h = foldHorizontal(horizontalAngle);
        if (!(v >= vertical[0] && v <= vertical[vertical.length - 1]) || type != Type.C && Math.abs(horizontalAngle) > 90) {
            return 0;
        }
        int below = indexBelow(vertical, v);
        int left = indexBelow(horizontal, h);
        double t = fraction(vertical, below, v);
        double first = column(left, below, t);
        double s = fraction(horizontal, left, h);
        return s == 0 ? first : first * (1 - s) + column(left + 1, below, t) * s;
    }

    private double column(int plane, int below, double t) {
        int i = plane * vertical.length + below;
        return t == 0 ? relative[i] : relative[i] * (1 - t) + relative[i + 1] * t;
    }

    /** Returns the measured horizontal angle that represents another by symmetry. */
    private double foldHorizontal(double angle) {
        double last = horizontal[horizontal.length - 1];
        if (type != Type.C) {
            return horizontal[0] >= 0 ? Math.abs(angle) : angle;
        }
        if (last == 270) {
            return angle < 90 ? 180 - angle : angle > 270 ? 540 - angle : angle;
        }
        double half = last <= 180 && angle > 180 ? 360 - angle : angle;
        return last <= 90 && half > 90 ? 180 - half : half;
    }

    /** Returns the index of the last angle that is not above {@code angle}; 0 for a single angle. */
    private static int indexBelow(double[] angles, double angle) {
        int index = Arrays.binarySearch(angles, angle);
        return Math.clamp(index >= 0 ? index : -index - 2, 0, angles.length - 1);
    }

    /** Returns the position of an angle between those at an index and the next, 0…1. */
    private static double fraction(double[] angles, int index, double angle) {
        return index + 1 == angles.length ? 0 : Math.clamp((angle - angles[index]) / (angles[index + 1] - angles[index]), 0, 1);
    }

    @Override
    public boolean equals(Object o) {
        return this == o || o instanceof Photometry p && type == p.type && Arrays.equals(vertical, p.vertical)
                && Arrays.equals(horizontal, p.horizontal) && Arrays.equals(relative, p.relative);
    }

    @Override
    public void addTo(ContentDigest digest) {
        digest.add(type.ordinal());
        digest.add(vertical);
        digest.add(horizontal);
        digest.add(relative);
    }

    @Override
    public int hashCode() {
        return 31 * Arrays.hashCode(vertical) + Arrays.hashCode(horizontal);
    }
}
