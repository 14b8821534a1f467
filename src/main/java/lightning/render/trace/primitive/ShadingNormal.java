package lightning.render.trace.primitive;

/** A normal by which a point is shaded though the surface there has another; of length 1. Reused for one after the other. */
final class ShadingNormal {
    /** The sine of half a degree, about: as flat as a bent normal lets a mirrored ray leave. */
    private static final double MIN_SINE = 0x1p-7;

    double x;
    double y;
    double z;

    /** Makes a direction of any length the normal; whether it is one. */
    boolean setNormalized(double toX, double toY, double toZ) {
        double length = Math.sqrt(toX * toX + toY * toY + toZ * toZ);
        boolean valid = length > 0 && length < Double.POSITIVE_INFINITY;
        if (valid) {
            x = toX / length;
            y = toY / length;
            z = toZ / length;
        }
        return valid;
    }

    /**
     * Bends it towards the viewer until the mirrored ray rises by at least {@link #MIN_SINE} from the surface, or as steeply as the
     * viewer's own ray where that is flatter (after Keller et al. 2017, The Iray Light Transport Simulation and Rendering System,
     * appendix A.3). So it faces the viewer, too.
     *
     * @param gx the surface's own normal, of length 1, on the side that is seen
     * @param dx the direction of the ray, of any length
     */
    void bend(double gx, double gy, double gz, double dx, double dy, double dz) {
        double back = -1 / Math.sqrt(dx * dx + dy * dy + dz * dz);
        double vx = dx * back;
        double vy = dy * back;
        double vz = dz * back;
        double twice = 2 * (x * vx + y * vy + z * vz);
        double rx = twice * x - vx;
        double ry = twice * y - vy;
        double rz = twice * z - vz;
        double reflectedHeight = rx * gx + ry * gy + rz * gz;
        double viewerHeight = vx * gx + vy * gy + vz * gz;
        double minHeight = Math.min(MIN_SINE, viewerHeight);
        if (twice < 0 && reflectedHeight >= minHeight) {
            // It leads into the surface, and mirrors as its opposite does. Bent on from where it is seen from its side.
            rx = -vx;
            ry = -vy;
            rz = -vz;
            reflectedHeight = -viewerHeight;
        }
        if (reflectedHeight < minHeight) {
            rx += (minHeight - reflectedHeight) * gx;
            ry += (minHeight - reflectedHeight) * gy;
            rz += (minHeight - reflectedHeight) * gz;
            double unit = 1 / Math.sqrt(rx * rx + ry * ry + rz * rz);
            if (!setNormalized(vx + rx * unit, vy + ry * unit, vz + rz * unit)) {
                setNormalized(gx, gy, gz);
            }
        }
    }
}
