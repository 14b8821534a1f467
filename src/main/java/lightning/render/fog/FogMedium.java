package lightning.render.fog;

import lightning.base.math.PowerFunction;
import lightning.base.math.Vec3;
import lightning.scene.Scene;
import lightning.scene.value.Fog;
import org.jspecify.annotations.Nullable;

/**
 * Extinction of a scene's fog, in render space.
 *
 * <p>The density at height y is {@code density} up to {@code top}, and {@code density}·e<sup>−decay·(y − top)</sup> above. The optical
 * depth of a segment is the integral of the density along it, in closed form; e<sup>−depth</sup> of the light passes (Bouguer, Lambert and
 * Beer).
 *
 * @param density extinction per scene unit, &gt; 0
 * @param top     height up to which the density is full
 * @param decay   decrease of the density's logarithm per scene unit above, ≥ 0
 * @param low     corner of the box that contains the fog, smallest coordinates; null for fog everywhere
 * @param high    corner with the largest coordinates; null for fog everywhere
 */
public record FogMedium(double density, double top, double decay, @Nullable Vec3 low, @Nullable Vec3 high) {
    private static final double LOG2_E = 1.4426950408889634;
    /** If the density's logarithm changes by less along a segment, its middle stands for it: an error below 1e-7 of the depth. */
    private static final double MIN_CHANGE = 1e-3;

    /** Returns the fog of a scene; null if its air is clear. */
    public static @Nullable FogMedium of(Scene scene) {
        Fog fog = scene.world().fog();
        if (!fog.isPresent()) {
            return null;
        }
        Vec3 center = fog.center().minus(scene.camera().origin());
        Vec3 half = fog.size().times(0.5);
        return new FogMedium(fog.density(), fog.height() - scene.camera().origin().y(), fog.falloff(),
                fog.hasBox() ? center.minus(half) : null, fog.hasBox() ? center.plus(half) : null);
    }

    /** Returns whether it dims light from infinitely far away: its density falls with height, or it is in a box. */
    public boolean hasBounds() {
        return low != null || decay > 0;
    }

    /** Returns the share of light that passes a depth, 0…1. */
    public static double transmittance(double depth) {
        return PowerFunction.exponential(-depth * LOG2_E);
    }

    /**
     * Returns the optical depth of a segment, ≥ 0; may be infinite.
     *
     * @param length length of the segment, scene units; may be infinite
     * @param ox     x of its start, as {@code oy} and {@code oz}; render space
     * @param dx     x of its unit direction, as {@code dy} and {@code dz}
     */
    public double depth(double ox, double oy, double oz, double dx, double dy, double dz, double length) {
        double from = 0;
        double to = length;
        if (low != null && high != null) {
            from = Math.max(enter(ox, dx, low.x(), high.x()),
                    Math.max(enter(oy, dy, low.y(), high.y()), enter(oz, dz, low.z(), high.z())));
            to = Math.min(length, Math.min(leave(ox, dx, low.x(), high.x()),
                    Math.min(leave(oy, dy, low.y(), high.y()), leave(oz, dz, low.z(), high.z()))));
        }
        if (!(to > from)) {
            return 0;
        }
        return decay == 0 ? density * (to - from) : density * decaying(oy - top, dy, from, to);
    }

    /** Returns the density at a point in render space, per scene unit, ≥ 0. */
    public double densityAt(double x, double y, double z) {
        boolean isInside = low == null || high == null
                || x >= low.x() && x <= high.x() && y >= low.y() && y <= high.y() && z >= low.z() && z <= high.z();
        return isInside ? decay == 0 ? density : density * share(y - top) : 0;
    }

    /** Returns the integral of the density over the density up to the top. */
    private double decaying(double height, double dy, double from, double to) {
        double start = height + dy * from;
        if (to == Double.POSITIVE_INFINITY) {
            return dy > 0 ? (1 / decay - primitive(start)) / dy : dy == 0 && share(start) == 0 ? 0 : Double.POSITIVE_INFINITY;
        }
        double end = height + dy * to;
        if (Math.abs(end - start) * decay < MIN_CHANGE) {
            return share(0.5 * (start + end)) * (to - from);
        }
        return Math.max(0, (primitive(end) - primitive(start)) / dy);
    }

    /** Returns the density over the density up to the top, at a height above the top. */
    private double share(double height) {
        return height <= 0 ? 1 : transmittance(decay * height);
    }

    /** Returns the integral of {@link #share} from the top to a height. */
    private double primitive(double height) {
        return height <= 0 ? height : (1 - transmittance(decay * height)) / decay;
    }

    /** Returns where a ray enters a slab: 0 if it starts inside, infinity if it misses the slab. */
    private static double enter(double o, double d, double min, double max) {
        double plane = d > 0 ? min : max;
        return o >= min && o <= max ? 0 : d == 0 ? Double.POSITIVE_INFINITY : Math.max(0, (plane - o) / d);
    }

    /** Returns where a ray leaves a slab. */
    private static double leave(double o, double d, double min, double max) {
        return d == 0 ? Double.POSITIVE_INFINITY : ((d > 0 ? max : min) - o) / d;
    }
}
