package lightning.render.trace.tree;

import java.util.function.IntPredicate;
import lightning.base.math.Vec3;
import lightning.render.trace.primitive.PrimitiveTable;
import lightning.render.trace.solid.SolidGeometry;

/**
 * Ways from the points of a box to places on a light, and which primitives certainly block all of them.
 *
 * <p>Certain means that the distance which rays compute lies before the end of each way, roundings included. At a share t of a way from a point o to an end e
 * is (1 − t)·o + t·e; of one in a direction v it is o + t·v. Of all ways these points lie in the box, scaled and moved, and grown by t times a ball in which
 * ends or directions lie. Where all of that lies inside a convex solid by a margin, and the ball of the ends outside it by a margin, each way
 * comes out of the solid before it ends. {@link SolidGeometry#insideDepth} is concave inside a solid, so that over a box it is least at a corner, and changes by no more than a
 * point moves, so that a ball takes its radius off.
 *
 * <p><b>Computed distances</b>, in own units, with u = 2⁻⁵³. Where all sizes that the map adds up are at most 2²⁰ together ({@link #MAX_MAGNITUDE}), o, v and e = o + v
 * as rays compute them, and all that is computed here, are off by less than 2⁻²⁴. So of the {@link #MARGIN} of 2⁻¹¹ more than δ = 2⁻¹² is left: the exact line
 * through the computed o along the computed v is inside by δ at t, and outside by δ at 1. Let ρ = |o| ≤ 2²⁰ and ℓ = |v|, and p ≤ 1 − δ be how far the line passes by the middle.
 *
 * <ul>
 * <li><b>Sphere.</b> D = ℓ² − |o × v|² = ℓ²·(1 − p²) is at least ℓ²·δ, and computed to within ℓ²·(6uρ + 9u²ρ² + 8u): its root is real, and off by less than
 * ℓ·7u(ρ + 2)/√δ. b is off by less than 3.1uρℓ, c by 4.1u(ρ² + 1). The square of |q| = |b| + √D is at least D, and at least ℓ²·(ρ² + 1 − 2p²), more than ¾ρ²ℓ² for
 * ρ ≥ 2. The chord's ends are at most (ρ + 1)/ℓ away, so that c/q and q/a are ends of it to within 2⁻²⁰/ℓ. It begins δ/ℓ before t at least, and ends as
 * much after t and before 1. Where b ≥ 0 and c > 0 the distance is its beginning c/q, above 0 as c is; where b ≥ 0 and c ≤ 0 its end q/a. Where b &lt; 0 the exact b is no more than its
 * error, so that the chord begins √δ/(2ℓ) behind o at least, and c, the product of both ends and ℓ², is below −δ/65 and computed to be below 0: the distance is the end c/q. |c·a| ≤ q²
 * holds but for a share of 2⁻³⁰.
 * <li><b>Cylinder with discs.</b> The same in x and z alone, with ρ and ℓ there, gives when the way is within the side, to within 2⁻²⁰/ℓ. Where it counts as parallel
 * to the axis it moves sideways by less than 2⁻⁷⁰ from o to t, so that c &lt; 0 and it is always within. Between the planes of the discs it is from −oy/dy to (1 − oy)/dy or the other way round, which
 * are off by 3u(ρ + 1)/|dy| and lie δ/|dy| before and after t; where 1/dy is not finite, oy is that at t. So t lies in both intervals as computed. What is outside by δ at 1 is
 * so of the side or of a disc: one of both ends before 1.
 * </ul>
 *
 * <p>All of this is homogeneous in v; directions are let in from 2⁻²²⁰ to 2²⁰⁰ ({@link #MAX_DIRECTION}), where no product overflows or vanishes. A light in a solid is not told, nor are meshes, shapes
 * with holes and those on which eye or light lie, whose distances are others. Reused; not shared between threads.
 */
public final class FullOcclusionTest {
    private static final double MARGIN = 0x1p-11;
    private static final double MAX_MAGNITUDE = 0x1p20;
    private static final double MAX_DIRECTION = 0x1p200;

    /** The box's middle, half of its sides, and its largest coordinates. */
    private final double[] middle = new double[3];
    private final double[] half = new double[3];
    private final double[] maxAbs = new double[3];
    /** The ball's middle, and its largest coordinates. */
    private final double[] end = new double[3];
    private final double[] maxAbsEnd = new double[3];
    private double endRadius;
    private boolean endsAtPoints;
    private IntPredicate canHoldEnd;

    /**
     * Takes ways.
     *
     * @param points     where they begin
     * @param center     the middle of a ball in which all points lie where they end, or all their directions; render space
     * @param endRadius     its radius; roundings of such a point do not count
     * @param toPoints   which of both
     * @param canHoldEnd whether such a point may lie on a primitive
     */
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

    /** Whether primitive {@code s} is in all ways, for certain. */
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

    /** Whether all corners of the box, made smaller and moved about a point of own space, lie at a depth. */
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

    /** Whether numbers are such that the margin is more than their roundings; {@code minDirectionLength} is no more than the length of any direction. */
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

    /** More than the absolute values of all that is added up where a point or direction of no larger coordinates is mapped. */
    private static double magnitude(double[] m, int i, double[] p) {
        double sum = 0;
        for (int row = i; row < i + 12; row += 4) {
            sum += Math.abs(m[row]) * p[0] + Math.abs(m[row + 1]) * p[1] + Math.abs(m[row + 2]) * p[2];
        }
        return sum;
    }

    /** How many times as long a step can be in own units as in the scene: by Gershgorin's circles about the map times its transpose. */
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
