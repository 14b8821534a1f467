package lightning.relight;

import lightning.cache.LayerStamp;
import lightning.scene.Light;
import lightning.scene.Scene;

/**
 * How far a picture made by ratios may be from the exact one.
 *
 * <p>Let u = 2⁻²⁴. Every float operation with a normal result errs by a factor in 1 ± u. The exact
 * contribution is fl(w·fl(t·f)), f itself rounded: 3 roundings. The stored one began with 3 as well, and
 * each scaling added 2: the ratio and the product. All quantities are ≥ 0 and a float ratio of two
 * values with n roundings between them lies in 1 ± n·u/(1 − n·u) =: 1 ± γ(n) (Higham, Accuracy and
 * Stability, §3.1). The equation adds and multiplies values ≥ 0 only, so a relative error passes
 * through it unchanged, and each of the two pictures adds its own roundings: one for each level of the
 * balanced sum over the lights and seven to close the equation (ka·ambience and 1 − kr are the same in
 * both), once for each mirror level. Hence for every value I of the film
 *
 * <pre>|I − exact| ≤ γ(N)·I/(1 − γ(N)) + A,   N = 6 + scalings·2 + 2·(⌈log₂ lights⌉ + 7)·(levels)</pre>
 *
 * <p>Where a result is not normal it errs by at most η = 2⁻¹⁵⁰ instead. A scaling by at most R of
 * contributions with weight w to weight w′ turns an error a into at most
 * a·R + 2η·(w + w′ + 4)·(R + 1): the falloff's product, the ratio itself and the two products underflow
 * at most once each, times what they are multiplied by. Diffuse and specular factors are at most 1, so
 * A is twice the sum over the lights and 64η for closing the equation, once for each mirror level.
 */
final class RatioBound {
    private static final double UNIT = 0x1p-24;
    private static final double TINY = 0x1p-150;

    private RatioBound() {}

    /**
     * The stamp of a layer after it was scaled.
     *
     * @param scalings how many ratios were multiplied in
     * @param largest  the largest factor by which a contribution was multiplied
     */
    static LayerStamp scaled(LayerStamp before, Light light, int scalings, double largest) {
        double weights = weight(before.light()) + weight(light);
        double absolute = before.absolute() * largest + 2 * TINY * (weights + 4) * (largest + 1);
        return new LayerStamp(light, before.roundings() + 2 * scalings, absolute);
    }

    private static double weight(Light light) {
        return light.color().max() * light.intensity();
    }

    /** The relative part γ(N)/(1 − γ(N)) over all layers of a scene; 0 where nothing was scaled. */
    static double relative(LayerStamp[] stamps, Scene scene) {
        int most = 0;
        for (LayerStamp stamp : stamps) {
            most = Math.max(most, stamp == null ? 0 : stamp.roundings());
        }
        if (most == 0) {
            return 0;
        }
        int sum = 32 - Integer.numberOfLeadingZeros(Math.max(0, stamps.length - 1));
        double n = 6 + most + 2.0 * (sum + 7) * (scene.picture().depth() + 1);
        double gamma = n * UNIT / (1 - n * UNIT);
        return gamma / (1 - gamma);
    }

    /** The absolute part A. */
    static double absolute(LayerStamp[] stamps, Scene scene) {
        double sum = 0;
        boolean scaled = false;
        for (LayerStamp stamp : stamps) {
            sum += stamp == null ? 0 : stamp.absolute();
            scaled |= stamp != null && stamp.roundings() > 0;
        }
        return scaled ? (scene.picture().depth() + 1) * (2 * sum + 64 * TINY) : 0;
    }
}
