package lightning.render.shading;

import java.util.stream.IntStream;
import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.scene.light.AreaShape;
import lightning.scene.light.LightType;
import lightning.scene.material.Material;
import lightning.scene.material.ShadingModel;
import org.jspecify.annotations.Nullable;

/**
 * Share of a GGX lobe that reflects an area light's face, without sampling it. The terms of the samples, whose lobes are widened
 * ({@link LightSource#highlightWidening}), are scaled by the ratio of this share to that of the widened lobe among the samples. So highlights have
 * the shape and the sharp edge of the face and no grain, and the samples decide only how Fresnel reflection, falloff and shadows vary over the face.
 *
 * <p>The facets' normals H of GGX, projected, are a cosine distribution that is stretched by 1/α along the normal (E. Heitz and others, Real-time
 * polygonal-light shading with linearly transformed cosines, 2016). The face is a polygon of directions, so its half vectors are nearly one, and the share of
 * facets that mirror it follows from Lambert's formula for the irradiance of a polygon.
 *
 * <p>Only principled materials use it, without anisotropy. One instance per thread.
 */
public final class FaceHighlight {
    /** Corners of the polygon of a face: four on each side of a rectangle. */
    private static final int CORNERS = 16;
    /** A polygon with so many corners on a circle of radius 1 and this one have the same area. */
    private static final double CORNER_RADIUS = Math.sqrt(Math.PI / (CORNERS / 2.0 * Transform.sinDegrees(360.0 / CORNERS)));
    /** Directions of the corners of a circle. */
    private static final double[] COS = IntStream.range(0, CORNERS).mapToDouble(i -> Transform.cosDegrees(360.0 * i / CORNERS)).toArray();
    private static final double[] SIN = IntStream.range(0, CORNERS).mapToDouble(i -> Transform.sinDegrees(360.0 * i / CORNERS)).toArray();

    /** Widths α up to which lobes are scaled, and from which on they are not: samples hit wide lobes well, and a quotient of two means would only add noise. */
    private static final double NARROW = 0.2;
    private static final double WIDE = 0.4;

    private final double[] cornerX = new double[CORNERS];
    private final double[] cornerY = new double[CORNERS];
    private final double[] cornerZ = new double[CORNERS];
    /** Half vectors in the frame of the normal, stretched, with those where the horizon cuts the polygon. */
    private final double[] hx = new double[2 * CORNERS];
    private final double[] hy = new double[2 * CORNERS];
    private final double[] hz = new double[2 * CORNERS];
    private @Nullable LightSource source;
    /** Whether the corners are directions and not positions. */
    private boolean isFar;
    /** Radius of a ball whose corners depend on the point; 0 for other faces. */
    private double ball;
    /** Area of a face, or its solid angle. */
    private double area;

    /** Returns whether a material shows faces in its highlights: it is principled, and its lobe is round. */
    public static boolean isShownBy(Material material) {
        return material.model() == ShadingModel.PRINCIPLED && !material.isAnisotropic();
    }

    /** Returns whether a light has a face with an area; that of a tube is not known. */
    public static boolean hasFace(LightSource light) {
        AreaShape shape = light.light().area();
        return light.isArea() && light.type() != LightType.TUBE && light.type() != LightType.OBJECT
                && (light.type() != LightType.RECT || shape.width() > 0 && shape.height() > 0);
    }

    /** Moves to an area light for which {@link #hasFace} holds. */
    public void aim(LightSource light) {
        if (light == source) {
            return;
        }
        source = light;
        AreaShape shape = light.light().area();
        isFar = light.type() == LightType.DIRECTIONAL;
        ball = 0;
        Vec3 right = (light.type().isSurface() ? shape : AreaShape.DEFAULT).right(light.axis());
        Vec3 top = right.cross(light.axis());
        switch (light.type()) {
            case RECT -> {
                area = shape.width() * shape.height();
                setRectangle(light.position(), right.times(0.5 * shape.width()), top.times(0.5 * shape.height()));
            }
            case DISC -> {
                area = Math.PI * shape.radius() * shape.radius();
                setCircle(light.position(), right, top, shape.radius());
            }
            case DIRECTIONAL -> {
                double cos = Transform.cosDegrees(shape.spread());
                area = 2 * Math.PI * (1 - cos);
                setCircle(light.position().times(cos), right, top, Math.sqrt(Math.max(0, 1 - cos * cos)));
            }
            case POINT, SPOT -> ball = shape.radius();
            case TUBE, OBJECT -> throw new IllegalArgumentException("the face of a tube or an object is not known");
        }
    }

    private void setRectangle(Vec3 center, Vec3 right, Vec3 top) {
        for (int i = 0; i < CORNERS; i++) {
            int side = 4 * i / CORNERS;
            double along = 2.0 * (i % (CORNERS / 4)) / (CORNERS / 4) - 1;
            double u = side == 0 ? along : side == 1 ? 1 : side == 2 ? -along : -1;
            double v = side == 0 ? -1 : side == 1 ? along : side == 2 ? 1 : -along;
            set(i, center.plus(right.times(u)).plus(top.times(v)));
        }
    }

    private void setCircle(Vec3 center, Vec3 right, Vec3 top, double radius) {
        for (int i = 0; i < CORNERS; i++) {
            set(i, center.plus(right.times(CORNER_RADIUS * radius * COS[i])).plus(top.times(CORNER_RADIUS * radius * SIN[i])));
        }
    }

    private void set(int i, Vec3 corner) {
        cornerX[i] = corner.x();
        cornerY[i] = corner.y();
        cornerZ[i] = corner.z();
    }

    /**
     * Returns the factor of the terms of some samples at a point, ≥ 0: for each α, a mean of terms times this is that of a lobe that is not widened.
     *
     * @param samples of the light
     * @param pattern of the row
     * @param first   first of the samples that are averaged, of which there are {@link AreaSamples#samples}
     * @param px      point in render space, as {@code py} and {@code pz}
     * @param nx      unit normal, as {@code ny} and {@code nz}
     * @param vx      unit direction of the ray that hit the point, as {@code vy} and {@code vz}
     * @param alpha   width of the lobe before it is widened, above 0
     */
    public float factor(AreaSamples samples, int pattern, int first, float px, float py, float pz, float nx, float ny, float nz, float vx,
            float vy, float vz, double alpha) {
        assert source != null;
        if (alpha >= WIDE) {
            return 1;
        }
        if (ball > 0 && !setBall(source.position(), px, py, pz)) {
            return 1;
        }
        double widened = 0;
        for (int s = first; s < first + samples.samples(); s++) {
            int i = samples.index(s, pattern);
            widened += share(source, samples.x[i], samples.y[i], samples.z[i], px, py, pz, nx, ny, nz, vx, vy, vz, alpha);
        }
        widened /= samples.samples() * Math.PI;
        double factor = widened > 0 ? polygonShare(px, py, pz, nx, ny, nz, vx, vy, vz, alpha) / widened : 1;
        double share = alpha <= NARROW ? 1 : (WIDE - alpha) / (WIDE - NARROW);
        return (float) Math.min(Float.MAX_VALUE, 1 + share * (factor - 1));
    }

    /** Returns a highlight's term times a factor, at most the largest term of a lobe of width α ({@link LightingEquation}). */
    public static float scaled(float term, float factor, double alpha) {
        return (float) Math.min((double) term * factor, 1 / (2 * alpha * alpha * alpha));
    }

    /** Sets the corners of a ball as it is seen; returns false inside it. */
    private boolean setBall(Vec3 center, float px, float py, float pz) {
        double x = center.x() - px;
        double y = center.y() - py;
        double z = center.z() - pz;
        double distance = Math.sqrt(x * x + y * y + z * z);
        if (!(ball < distance)) {
            return false;
        }
        double sin = ball / distance;
        double cos = Math.sqrt(1 - sin * sin);
        area = 2 * Math.PI * (sin * sin / (1 + cos));
        var toward = new Vec3(x / distance, y / distance, z / distance);
        Vec3 right = AreaShape.DEFAULT.right(toward);
        isFar = true;
        setCircle(toward.times(cos), right, right.cross(toward), sin);
        return true;
    }

    /** Returns the share of the widened lobe that reflects one sample's part of the face, times π and the number of samples. */
    private double share(LightSource light, double x, double y, double z, float px, float py, float pz, float nx, float ny, float nz,
            float vx, float vy, float vz, double alpha) {
        double square = 1;
        double seen = area;
        double lx = x;
        double ly = y;
        double lz = z;
        if (light.type() != LightType.DIRECTIONAL) {
            lx = x - px;
            ly = y - py;
            lz = z - pz;
            square = lx * lx + ly * ly + lz * lz;
            double inverse = 1 / Math.sqrt(square);
            lx *= inverse;
            ly *= inverse;
            lz *= inverse;
            if (ball == 0) {
                seen = -(lx * light.axis().x() + ly * light.axis().y() + lz * light.axis().z()) * area / square;
            }
        }
        double mx = lx - vx;
        double my = ly - vy;
        double mz = lz - vz;
        double lengths = mx * mx + my * my + mz * mz;
        double nh = nx * mx + ny * my + nz * mz;
        if (!(seen > 0 && nh > 0)) {
            return 0;
        }
        double c = Math.min(1, nh * nh / (((double) nx * nx + (double) ny * ny + (double) nz * nz) * lengths));
        double a = Math.min(1, alpha * alpha + light.highlightWidening() / square);
        double t = c * (a - 1) + 1;
        // The half vector turns by dω / (4·V·H), and V·H is half of the length of L + V.
        return a / (t * t) * Math.sqrt(c) * seen / (2 * Math.sqrt(lengths));
    }

    /** Returns the share of the lobe that reflects the face, 0…1. */
    private double polygonShare(float px, float py, float pz, float nx, float ny, float nz, float vx, float vy, float vz, double alpha) {
        double scale = 1 / alpha;
        // A frame of the normal (T. Duff and others, Building an orthonormal basis, revisited, 2017).
        double sign = Math.copySign(1, nz);
        double a = -1 / (sign + nz);
        double b = nx * ny * a;
        boolean isAbove = true;
        for (int i = 0; i < CORNERS; i++) {
            double x = cornerX[i];
            double y = cornerY[i];
            double z = cornerZ[i];
            if (!isFar) {
                x -= px;
                y -= py;
                z -= pz;
            }
            double inverse = 1 / Math.sqrt(x * x + y * y + z * z);
            x = x * inverse - vx;
            y = y * inverse - vy;
            z = z * inverse - vz;
            hx[i] = ((1 + sign * nx * nx * a) * x + sign * b * y - sign * nx * z) * scale;
            hy[i] = (b * x + (sign + ny * ny * a) * y - ny * z) * scale;
            hz[i] = nx * x + ny * y + nz * z;
            isAbove &= hz[i] > 0;
        }
        return polygonShare(isAbove ? CORNERS : clip());
    }

    /** Cuts off what is below the horizon; returns the number of corners left. */
    private int clip() {
        double lastX = hx[CORNERS - 1];
        double lastY = hy[CORNERS - 1];
        double lastZ = hz[CORNERS - 1];
        int count = 0;
        // Half vectors of a wide face are not exactly convex: the horizon may cut every side, so there is room for twice as many corners.
        double[] x = hx.clone();
        double[] y = hy.clone();
        double[] z = hz.clone();
        for (int i = 0; i < CORNERS; i++) {
            if (z[i] > 0 != lastZ > 0) {
                double t = lastZ / (lastZ - z[i]);
                hx[count] = lastX + t * (x[i] - lastX);
                hy[count] = lastY + t * (y[i] - lastY);
                hz[count++] = 0;
            }
            if (z[i] > 0) {
                hx[count] = x[i];
                hy[count] = y[i];
                hz[count++] = z[i];
            }
            lastX = x[i];
            lastY = y[i];
            lastZ = z[i];
        }
        return count;
    }

    /** Returns the irradiance of a polygon of stretched half vectors (J. Lambert, Photometria, 1760), of a whole sky of light 1/π. */
    private double polygonShare(int corners) {
        double sum = 0;
        for (int i = 0; i < corners; i++) {
            int j = i + 1 < corners ? i + 1 : 0;
            double x = hy[i] * hz[j] - hz[i] * hy[j];
            double y = hz[i] * hx[j] - hx[i] * hz[j];
            double z = hx[i] * hy[j] - hy[i] * hx[j];
            double length = Math.sqrt(x * x + y * y + z * z);
            if (length > 0) {
                sum += StrictMath.atan2(length, hx[i] * hx[j] + hy[i] * hy[j] + hz[i] * hz[j]) * z / length;
            }
        }
        return Math.abs(sum) / (2 * Math.PI);
    }
}
