package lightning.render.trace.primitive;

/** Shading normal that differs from the geometric normal, of length 1. Reused. */
final class ShadingNormal {
    double x;
    double y;
    double z;

    /** Normalizes a direction of any length and sets it as the normal; returns false if that is impossible. */
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
     * Bends the normal toward the viewer until the reflected ray rises by at least {@link SurfaceHit#MIN_SINE} from the surface, or as
     * steeply as the viewer's own ray if that is flatter (after Keller et al. 2017, The Iray Light Transport Simulation and
     * Rendering System, appendix A.3). The result also faces the viewer.
     *
     * @param gx geometric normal, of length 1, on the visible side
     * @param dx direction of the ray, of any length
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
        double minHeight = Math.min(SurfaceHit.MIN_SINE, viewerHeight);
        if (twice < 0 && reflectedHeight >= minHeight) {
            // The normal points into the surface and reflects like its opposite. Continue from where it is seen edge-on.
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
