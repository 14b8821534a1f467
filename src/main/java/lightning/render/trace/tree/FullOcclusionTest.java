package lightning.render.trace.tree;

import java.util.function.IntPredicate;
import lightning.base.Initializer;
import lightning.base.math.Vec3;
import lightning.render.trace.primitive.PrimitiveTable;
import lightning.render.trace.solid.SolidGeometry;

/**
 * Conservative test for primitives that certainly block all shadow rays from a box of points to a ball of points on a light.
 *
 * <p>A primitive passes only if the distance that rays compute is before the end of each ray, rounding included. At parameter
 * t, the points of all rays lie in the box, scaled and translated, and extended by a ball around the ends or directions. If all
 * of these are inside a convex solid by a margin, and the ball of ends is outside by a margin, then each ray leaves the solid
 * before it ends. {@link SolidGeometry#insideDepth} is concave inside a solid, so over a box its minimum is at a corner. It
 * changes by at most the distance that a point moves, so a ball subtracts its radius.
 *
 * <p>Lights inside a solid, meshes, solids with cutouts, and primitives that contact the eye or the light are never reported.
 * Proof of the {@link #MARGIN}: docs/numerics.md, "Proof: full occlusion". Reused; not thread-safe.
 */
public final class FullOcclusionTest {
    private static final double MARGIN = 0x1p-11;
    private static final double MAX_MAGNITUDE = 0x1p20;
    private static final double MAX_DIRECTION = 0x1p200;

    /** Center of the box, half of its sides, and its largest absolute coordinates. */
    private final double[] middle = new double[3];
    private final double[] half = new double[3];
    private final double[] maxAbs = new double[3];
    /** Center of the ball, and its largest absolute coordinates. */
    private final double[] end = new double[3];
    private final double[] maxAbsEnd = new double[3];
    private double endRadius;
    private boolean endsAtPoints;
    private IntPredicate canHoldEnd;

    /**
     * Sets the shadow rays.
     *
     * @param points bounds of their origins
     * @param center center of a ball that contains all end points, or all directions; render space
     * @param endRadius radius of the ball, without rounding errors of such a point
     * @param toPoints true for end points, false for directions
     * @param canHoldEnd primitives that may contain such an end point
     */
    @Initializer
    public void setRays(PointBox points, Vec3 center, double endRadius, boolean toPoints, IntPredicate canHoldEnd) {
        end[0] = center.x();
        end[1] = center.y();
        end[2] = center.z();
        for (int axis = 0; axis < 3; axis++) {
            double low = points.low(axis);
            double high = points.high(axis);
            middle[axis] = 0.5 * (low + high);
            half[axis] = 0.5 * (high - low);
            maxAbs[axis] = Math.max(Math.abs(low), Math.abs(high));
            maxAbsEnd[axis] = Math.abs(end[axis]) + endRadius;
        }
        this.endRadius = endRadius;
        endsAtPoints = toPoints;
        this.canHoldEnd = canHoldEnd;
    }

    /** Returns whether primitive {@code s} certainly blocks all shadow rays. */
    public boolean isFullOccluder(PrimitiveTable primitives, int s) {
        if (primitives.mesh(s) != null || primitives.isEyeOnSurface(s) || primitives.hasCutout(s) || canHoldEnd.test(s)) {
            return false;
        }
        double[] m = primitives.data;
        int i = primitives.dataStart[s];
        SolidGeometry form = primitives.kind(s).geometry();
        double ox = transform(m, i, middle) + m[i + 3];
        double oy = transform(m, i + 4, middle) + m[i + 7];
        double oz = transform(m, i + 8, middle) + m[i + 11];
        double vx = transform(m, i, end);
        double vy = transform(m, i + 4, end);
        double vz = transform(m, i + 8, end);
        double radius = endRadius == 0 ? 0 : endRadius * maxScale(m, i);
        if (endsAtPoints) {
            vx += m[i + 3];
            vy += m[i + 7];
            vz += m[i + 11];
            if (!(form.insideDepth(m, i, vx, vy, vz) <= -(MARGIN + radius))) {
                return false;
            }
            vx -= ox;
            vy -= oy;
            vz -= oz;
        }
        double t = form.chordMidpoint(m, i, ox, oy, oz, vx, vy, vz);
        return t > 0 && t < (endsAtPoints ? 1 : SolidGeometry.MISS)
                && isInside(form, m, i, ox + t * vx, oy + t * vy, oz + t * vz, endsAtPoints ? 1 - t : 1, MARGIN + t * radius)
                && isAboveRounding(m, i, t, Math.max(Math.abs(vx), Math.max(Math.abs(vy), Math.abs(vz))) - radius);
    }

    /** Returns whether all corners of the box, scaled and translated to a point of local space, are inside at a depth. */
    private boolean isInside(SolidGeometry form, double[] m, int i, double x, double y, double z, double scale, double depth) {
        if (!(form.insideDepth(m, i, x, y, z) >= depth)) {
            return false;
        }
        for (int corner = 0; corner < 4; corner++) {
            double a = scale * half[0];
            double b = scale * ((corner & 1) == 0 ? half[1] : -half[1]);
            double c = scale * ((corner & 2) == 0 ? half[2] : -half[2]);
            double dx = m[i] * a + m[i + 1] * b + m[i + 2] * c;
            double dy = m[i + 4] * a + m[i + 5] * b + m[i + 6] * c;
            double dz = m[i + 8] * a + m[i + 9] * b + m[i + 10] * c;
            if (!(form.insideDepth(m, i, x + dx, y + dy, z + dz) >= depth && form.insideDepth(m, i, x - dx, y - dy, z - dz) >= depth)) {
                return false;
            }
        }
        return true;
    }

    /**
     * Returns whether the margin exceeds the rounding errors of these numbers; {@code minDirectionLength} is a lower bound on
     * the length of any direction.
     */
    private boolean isAboveRounding(double[] m, int i, double t, double minDirectionLength) {
        double begin = magnitude(m, i, maxAbs) + Math.abs(m[i + 3]) + Math.abs(m[i + 7]) + Math.abs(m[i + 11]);
        double end = magnitude(m, i, maxAbsEnd);
        return endsAtPoints ? 2 * begin + end <= MAX_MAGNITUDE
                : begin + t * end <= MAX_MAGNITUDE && end <= MAX_DIRECTION && end >= 1 / MAX_DIRECTION
                        && minDirectionLength >= 0x1p-20 * end;
    }

    private static double transform(double[] m, int i, double[] p) {
        return m[i] * p[0] + m[i + 1] * p[1] + m[i + 2] * p[2];
    }

    /**
     * Returns an upper bound on the absolute values that are added when a point or direction up to these coordinates is
     * transformed.
     */
    private static double magnitude(double[] m, int i, double[] p) {
        double sum = 0;
        for (int row = i; row < i + 12; row += 4) {
            sum += Math.abs(m[row]) * p[0] + Math.abs(m[row + 1]) * p[1] + Math.abs(m[row + 2]) * p[2];
        }
        return sum;
    }

    /**
     * Returns an upper bound on the local length of a unit step in the scene, by Gershgorin's circles of the transform times
     * its transpose.
     */
    private static double maxScale(double[] m, int i) {
        double xx = m[i] * m[i] + m[i + 1] * m[i + 1] + m[i + 2] * m[i + 2];
        double yy = m[i + 4] * m[i + 4] + m[i + 5] * m[i + 5] + m[i + 6] * m[i + 6];
        double zz = m[i + 8] * m[i + 8] + m[i + 9] * m[i + 9] + m[i + 10] * m[i + 10];
        double xy = Math.abs(m[i] * m[i + 4] + m[i + 1] * m[i + 5] + m[i + 2] * m[i + 6]);
        double yz = Math.abs(m[i + 4] * m[i + 8] + m[i + 5] * m[i + 9] + m[i + 6] * m[i + 10]);
        double zx = Math.abs(m[i + 8] * m[i] + m[i + 9] * m[i + 1] + m[i + 10] * m[i + 2]);
        return Math.sqrt(Math.max(xx + xy + zx, Math.max(yy + yz + xy, zz + zx + yz)));
    }
}
