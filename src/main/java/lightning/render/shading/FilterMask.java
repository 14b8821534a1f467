package lightning.render.shading;

import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.scene.light.Light;
import lightning.scene.light.LightFilter;
import lightning.scene.light.LightFlag;
import org.jspecify.annotations.Nullable;

/**
 * Factor of a light's flag and filter at a point, 0…1, in render space.
 *
 * <p>With s as {@code softness} and q as the distance from the center over half the size, a soft edge passes t²(3 − 2t), where
 * t = (1 − q)/s is clamped to 0…1. A flag takes {@code density} times the product of the edges along its two sides from light that crosses it. A
 * filter takes {@code density} times the product of its three edges at the point; a sphere has one, with q as the length of all three. A ramp
 * takes t²(3 − 2t) with t from 0 at the top of its box to 1 at its bottom.
 */
final class FilterMask {
    private final @Nullable Place flag;
    private final @Nullable Place filter;
    private final LightFlag flagged;
    private final LightFilter filtered;
    private final boolean isDirectional;
    private final double[] local = new double[3];

    /** Box with half sizes {@code half} around a center, and the rows of the matrix that maps its axes to those of the scene, transposed. */
    private record Place(Vec3 center, Transform toLocal, double halfX, double halfY, double halfZ) {
        static Place of(Vec3 center, Vec3 rotation, Vec3 size) {
            return new Place(center, Transform.rotation(rotation).transposed(), size.x() / 2, size.y() / 2, size.z() / 2);
        }

        void write(double x, double y, double z, double[] to) {
            double dx = x - center.x();
            double dy = y - center.y();
            double dz = z - center.z();
            to[0] = toLocal.m00() * dx + toLocal.m01() * dy + toLocal.m02() * dz;
            to[1] = toLocal.m10() * dx + toLocal.m11() * dy + toLocal.m12() * dz;
            to[2] = toLocal.m20() * dx + toLocal.m21() * dy + toLocal.m22() * dz;
        }
    }

    private FilterMask(Light light, Vec3 origin, boolean directional) {
        flagged = light.flag();
        filtered = light.filter();
        isDirectional = directional;
        flag = flagged.on() ? Place.of(flagged.position().minus(origin), flagged.rotation(), new Vec3(flagged.width(), flagged.height(), 0))
                : null;
        filter = filtered.isActive() ? Place.of(filtered.position().minus(origin), filtered.rotation(), filtered.size()) : null;
    }

    /** Returns whether a light has a flag or a filter. */
    static boolean isActive(Light light) {
        return light.flag().on() || light.filter().isActive();
    }

    /**
     * Returns the mask of a light, or null if it has neither.
     *
     * @param origin origin of render space in the scene
     */
    static @Nullable FilterMask of(Light light, Vec3 origin, boolean directional) {
        return isActive(light) ? new FilterMask(light, origin, directional) : null;
    }

    /** Returns the factor at a point for light from a position, or from a direction of a directional light. */
    double factor(double px, double py, double pz, double sx, double sy, double sz) {
        return (flag == null ? 1 : flagFactor(flag, px, py, pz, sx, sy, sz)) * (filter == null ? 1 : filterFactor(filter, px, py, pz));
    }

    private double flagFactor(Place place, double px, double py, double pz, double sx, double sy, double sz) {
        place.write(px, py, pz, local);
        double x = local[0];
        double y = local[1];
        double z = local[2];
        place.write(isDirectional ? px + sx : sx, isDirectional ? py + sy : sy, isDirectional ? pz + sz : sz, local);
        double rise = local[2] - z;
        // Share of the way from the point to the light at which it meets the card's plane.
        double t = -z / rise;
        if (!(t > 0) || !isDirectional && !(t < 1)) {
            return 1;
        }
        return 1 - flagged.density() * edge(x + t * (local[0] - x), place.halfX, flagged.softness())
                * edge(y + t * (local[1] - y), place.halfY, flagged.softness());
    }

    private double filterFactor(Place place, double px, double py, double pz) {
        place.write(px, py, pz, local);
        double softness = filtered.softness();
        double taken = switch (filtered.shape()) {
            case NONE -> 0;
            case BOX -> edge(local[0], place.halfX, softness) * edge(local[1], place.halfY, softness)
                    * edge(local[2], place.halfZ, softness);
            case SPHERE -> {
                double x = local[0] / place.halfX;
                double y = local[1] / place.halfY;
                double z = local[2] / place.halfZ;
                yield edge(Math.sqrt(x * x + y * y + z * z), 1, softness);
            }
            case RAMP -> {
                double below = (place.halfY - local[1]) / (2 * place.halfY);
                yield Double.isNaN(below) ? local[1] < 0 ? 1 : 0 : smooth(below);
            }
        };
        return 1 - filtered.density() * (filtered.inverted() ? 1 - taken : taken);
    }

    /** Returns 1 inside an edge, 0 outside, and a smooth passage between. */
    private static double edge(double distance, double half, double softness) {
        double q = Math.abs(distance) / half;
        return !(q < 1) ? 0 : softness == 0 ? 1 : smooth((1 - q) / softness);
    }

    private static double smooth(double v) {
        double t = Math.clamp(v, 0, 1);
        return t * t * (3 - 2 * t);
    }
}
