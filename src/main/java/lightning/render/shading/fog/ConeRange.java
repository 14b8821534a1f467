package lightning.render.shading.fog;

import lightning.base.math.Vec3;
import lightning.render.fog.FogGrid;
import lightning.render.fog.FogPath;
import lightning.render.fog.FogRay;
import lightning.render.shading.LightSource;
import lightning.scene.light.LightType;

/**
 * Samples along a ray that a spot's cone may contain; the others are certainly outside.
 *
 * <p>Let a be the lamp, u its axis, o the origin of the ray, q the point of the ray next to the lamp less a, and s the distance from there along the ray's direction d, so that
 * a point of the ray is p = a + q + s·d. With a cosine c it is inside the cone if (p − a)·u ≥ c·|p − a|, for c &gt; 0: if (p − a)·u ≥ 0 and
 * A·s² + 2B·s + C ≥ 0 with A = (d·u)² − c², B = (d·u)(q·u), C = (q·u)² − c²·|q|².
 *
 * <p>The cone here is wider: its c is smaller by {@link #MARGIN}. The range is used only if |o| + |a − o| is at most {@value #MAX_RATIO}·|q|. Then the
 * rounding of p to floats turns its direction from the lamp by at most √3·2⁻²⁴·(1 + 2·{@value #MAX_RATIO}) &lt; 2.1·10⁻⁵ radians, less than the margin. A
 * point inside the true cone has a value of the polynomial of more than 10⁻⁶·|p − a|², since c is at least {@link #MIN_COSINE}; the coefficients are off by
 * less than 10⁻¹²·|q|², |q| and 1. |A| is at least {@link #MIN_CURVATURE}, so roots are off by much less than the step to such a point. One more sample on
 * either side covers the rounding of places.
 */
final class ConeRange {
    private static final double MARGIN = 1e-4;
    private static final double MIN_COSINE = 0.02;
    private static final double MIN_CURVATURE = 1e-4;
    private static final double MAX_RATIO = 100;

    private final boolean isCone;
    private final Vec3 lamp;
    private final Vec3 axis;
    private final double cosine;
    /** First sample that may be inside. */
    int from;
    /** One more than the last; {@link #from} or less for none. */
    int to;

    ConeRange(LightSource source) {
        isCone = source.type() == LightType.SPOT && !source.isArea() && source.cosAngle() > MIN_COSINE;
        lamp = source.position();
        axis = source.axis();
        cosine = source.cosAngle() - MARGIN;
    }

    /** Sets the range for a ray. */
    void find(FogPath path, FogRay ray) {
        from = 0;
        to = FogGrid.SAMPLES;
        if (!isCone) {
            return;
        }
        double lx = lamp.x() - ray.ox;
        double ly = lamp.y() - ray.oy;
        double lz = lamp.z() - ray.oz;
        double reach = Math.sqrt(ray.ox * ray.ox + ray.oy * ray.oy + ray.oz * ray.oz) + Math.sqrt(lx * lx + ly * ly + lz * lz);
        double nearest = lx * ray.dx + ly * ray.dy + lz * ray.dz;
        double qx = nearest * ray.dx - lx;
        double qy = nearest * ray.dy - ly;
        double qz = nearest * ray.dz - lz;
        double square = qx * qx + qy * qy + qz * qz;
        double du = ray.dx * axis.x() + ray.dy * axis.y() + ray.dz * axis.z();
        double qu = qx * axis.x() + qy * axis.y() + qz * axis.z();
        double a = du * du - cosine * cosine;
        if (!(reach * reach <= MAX_RATIO * MAX_RATIO * square) || Math.abs(a) < MIN_CURVATURE) {
            return;
        }
        double b = du * qu;
        double c = qu * qu - cosine * cosine * square;
        double discriminant = b * b - a * c;
        if (discriminant < 0) {
            // Outside all along if the ray is flatter than the cone; otherwise it would meet the lamp.
            to = a < 0 ? 0 : to;
            return;
        }
        double root = Math.sqrt(discriminant);
        double low = Math.min((-b - root) / a, (-b + root) / a);
        double high = Math.max((-b - root) / a, (-b + root) / a);
        if (a < 0) {
            // Between the roots, on one side of the lamp.
            set(path, nearest + low, qu + 0.5 * (low + high) * du < 0 ? Double.NEGATIVE_INFINITY : nearest + high);
        } else if (du > 0) {
            set(path, nearest + high, Double.POSITIVE_INFINITY);
        } else {
            set(path, Double.NEGATIVE_INFINITY, nearest + low);
        }
    }

    private void set(FogPath path, double first, double last) {
        if (last < 0 || last < first) {
            to = 0;
            return;
        }
        from = Math.max(0, (int) Math.floor(path.place(Math.max(0, first)) * FogGrid.SAMPLES) - 1);
        to = Math.min(FogGrid.SAMPLES, (int) Math.ceil(path.place(last) * FogGrid.SAMPLES) + 1);
    }
}
