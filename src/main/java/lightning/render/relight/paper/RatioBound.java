package lightning.render.relight.paper;

import lightning.base.math.Rgb;
import lightning.render.cache.LayerStamp;
import lightning.render.trace.MaterialTable;
import lightning.scene.light.Light;

/**
 * Error bound of a picture made by ratios.
 *
 * <p>Let u = 2⁻²⁴. Every float operation with a normal result errs by a factor in 1 ± u. The exact contribution is fl(w·F), where the film F
 * contains fl(t·f) with f rounded, and the stored one is fl(w·fl(t·f)): 3 roundings each. Each scaling of the stored one adds 2: the ratio and
 * the product. All quantities are ≥ 0. A float ratio of two values with n roundings between them is in 1 ± n·u/(1 − n·u) =: 1 ± γ(n) (Higham,
 * Accuracy and Stability, §3.1).
 *
 * <p>The equation only adds and multiplies values ≥ 0, so the relative error of a sum is at most that of its worst term. Factors of materials
 * have the same bits in both pictures. Each of the two pictures adds its own roundings between a contribution and the film: one for each level of
 * the balanced sum over the films; eight for the equation (the factor, the sum of highlights, the sum with diffuse, mirrored, refracted, blurred
 * and emitted light, the gain); five for each mirror it is seen in. A mean of samples adds one for each level of their balanced sum and two for
 * the division and for joining further samples. Hence for every value I of the film
 *
 * <pre>|I − exact| ≤ γ(N)·I/(1 − γ(N)) + A,   N = 6 + scalings·2 + 2·(⌈log₂ films⌉ + 8 + 5·mirrors + mean)</pre>
 *
 * <p>A result that is not normal errs by at most η = 2⁻¹⁵⁰ instead. This happens in three places:
 *
 * <ul>
 * <li>A new contribution has lost w·t·η when its falloff was rounded, w·η in t·f and η in w·(t·f), together at most 2η·(w + 1). As a share of
 * w it is 2η·(w + 1)/w. A later scaling also scales this loss.
 * <li>Scaling from weight w and falloff f to w′ and f′ adds at most η·(1 + w) by the ratio of the weights and its product, which the
 * second factor f′/f also scales, and η·(1 + w′) by that factor and its product.
 * <li>The exact contribution of w′ and f′ has lost 2η·(w′ + 1) itself, and each of the at most 16 operations on its film at each level loses η
 * before the film is multiplied by w′: 16η·w′ at each level.
 * </ul>
 *
 * <p>A loss before a scaling is scaled too, so it stays the same share of w′·f′. The last two losses together are a share of at most
 * 4η·(w + w′ + 4)/(w′·f), where f is the smallest old or new falloff. These shares only add up, however often a slider moves back and
 * forth. As long as only weights change, no falloff is needed: the shares are of w, and become shares of w·f when falloffs change. Some
 * rows of a layer may be newer than its stamp, because they entered a cone, their material changed, or their tile was recomputed. So before
 * each scaling the share is at least that of a new contribution for the light before the scaling.
 *
 * <p>A row whose falloff is below the smallest normal float counts as if it had that falloff: no later ratio of falloffs scales it, and
 * ratios of weights need no falloff. A channel whose weight w′ is below it was scaled once, from a normal weight, and is not scaled again:
 * beyond its shares it is off by at most w′ + η. Underflows in the rest of the equation are less than 64η. Both are within two smallest
 * normal floats per light. A is twice the sum over the lights, for diffuse and specular contributions, on each level of mirrors.
 *
 * <p>This assumes falloffs of at most 1; the loss of a light with a larger one is that share of its largest contribution.
 *
 * <p>It also assumes terms of at most 1. The specular and grazing terms of a metallic material are at most T
 * ({@link MaterialTable#maxTerm}). Each loss is at most T times that of a term of 1, so A is 1 + 2T times the sum.
 */
final class RatioBound {
    private static final double UNIT_ROUNDOFF = 0x1p-24;
    private static final double UNDERFLOW = 0x1p-150;
    /** Operations on a film at a level that may lose digits by underflow. */
    private static final int FILM_LOSSES = 16;

    private RatioBound() {}

    /**
     * Returns the stamp of a layer after it was scaled.
     *
     * @param weight     true if weights were scaled
     * @param falloff    true if falloffs were scaled
     * @param minFalloff the smallest old or new falloff of rows whose falloff was scaled
     */
    static ScaledStamp stampAfterScaling(LayerStamp stamp, Light light, boolean weight, boolean falloff, double minFalloff) {
        ScaledStamp before = ScaledStamp.of(stamp);
        int scalings = (weight ? 1 : 0) + (falloff ? 1 : 0);
        double loss = scalings == 0 ? 0 : 4 * UNDERFLOW * (weight(before.light()) + weight(light) + 4) / minWeight(light);
        double ofWeight = Math.max(before.weightLoss(), initialLoss(before.light())) + loss;
        return new ScaledStamp(light, before.roundings() + 2 * scalings,
                falloff ? before.contributionLoss() + ofWeight / minFalloff : before.contributionLoss(),
                falloff ? 0 : ofWeight);
    }

    /** Returns the loss of contributions that are computed and not scaled, as a share of the weight. */
    private static double initialLoss(Light light) {
        return 2 * UNDERFLOW * (weight(light) + 1) / minWeight(light);
    }

    private static double weight(Light light) {
        return light.weight().max();
    }

    /** Returns the smallest weight of a channel that is a normal float; +∞ if there is none. */
    private static double minWeight(Light light) {
        double min = Double.POSITIVE_INFINITY;
        Rgb weight = light.weight();
        for (double channel : new double[] {weight.r(), weight.g(), weight.b()}) {
            // Rounded like the contributions' weight.
            float w = (float) channel;
            min = w >= Float.MIN_NORMAL ? Math.min(min, w) : min;
        }
        return min;
    }

    /**
     * Returns the relative part γ(N)/(1 − γ(N)) over all layers of one level.
     *
     * @param mirrors maximum number of mirrors that the level is seen in
     * @param samples number of samples per pixel
     */
    static double relative(LayerStamp[] stamps, int mirrors, int samples) {
        int max = 0;
        for (LayerStamp stamp : stamps) {
            max = Math.max(max, stamp instanceof ScaledStamp scaled ? scaled.roundings() : 0);
        }
        int mean = samples == 1 ? 0 : treeDepth(samples) + 2;
        // Environments have two films each, ambient light and the rest one.
        double n = 6 + max + 2.0 * (treeDepth(2 * stamps.length + 2) + 8 + 5 * mirrors + mean);
        double gamma = n * UNIT_ROUNDOFF / (1 - n * UNIT_ROUNDOFF);
        return gamma / (1 - gamma);
    }

    /** Returns the depth of the balanced sum of this many terms: ⌈log₂ terms⌉. */
    private static int treeDepth(int terms) {
        return 32 - Integer.numberOfLeadingZeros(Math.max(0, terms - 1));
    }

    /** Returns the maximum sum of one light's terms over rows of these materials. */
    static double maxTermSum(MaterialTable materials) {
        return materials.hasMetallic() ? 1 + 2 * materials.maxTerm() : 2;
    }

    /**
     * Returns the absolute part A for a number of levels.
     *
     * @param terms maximum sum of one light's terms ({@link #maxTermSum})
     */
    static double absolute(LayerStamp[] stamps, int levels, double terms) {
        double sum = 0;
        for (LayerStamp stamp : stamps) {
            if (stamp != null) {
                ScaledStamp its = ScaledStamp.of(stamp);
                double lost = its.contributionLoss() + Math.max(its.weightLoss(), initialLoss(its.light()));
                sum += weight(its.light()) * Math.max(1, its.light().maxFalloff()) * lost + FILM_LOSSES * UNDERFLOW * weight(its.light())
                        + 2 * Float.MIN_NORMAL;
            }
        }
        return levels * terms * sum;
    }
}
