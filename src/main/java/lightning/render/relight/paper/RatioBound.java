package lightning.render.relight.paper;

import lightning.base.math.Rgb;
import lightning.render.cache.LayerStamp;
import lightning.render.trace.MaterialTable;
import lightning.scene.Light;

/**
 * How far a picture made by ratios may be from the exact one.
 *
 * <p>Let u = 2⁻²⁴. Every float operation with a normal result errs by a factor in 1 ± u. The exact
 * contribution is fl(w·fl(t·f)), f itself rounded: 3 roundings. The stored one began with 3 as well, and
 * each scaling added 2: the ratio and the product. All quantities are ≥ 0 and a float ratio of two
 * values with n roundings between them lies in 1 ± n·u/(1 − n·u) =: 1 ± γ(n) (Higham, Accuracy and
 * Stability, §3.1). The equation adds and multiplies values ≥ 0 only, so a sum is off by no larger share than
 * the worst of its terms, and each of the two pictures adds its own roundings on the way of a contribution to
 * the film: one for each step down the balanced sum over the lights; five to close the equation (kd or
 * ks·, + ambient, ·(1 − kr), + specular, + Cr); and two for each mirror that it is seen in (kr·, +); and where a pixel
 * is the mean of samples, one for each step down their balanced sum and one for the division. Hence for every value I
 * of the film
 *
 * <pre>|I − exact| ≤ γ(N)·I/(1 − γ(N)) + A,   N = 6 + scalings·2 + 2·(⌈log₂ lights⌉ + 5 + 2·mirrors + mean)</pre>
 *
 * <p>Where a result is not normal it errs by at most η = 2⁻¹⁵⁰ instead. Three times this is so:
 *
 * <ul>
 * <li>A contribution that was just computed has lost digits already: w·t times η where its falloff was rounded, w·η in t·f and
 * η in w·(t·f), together at most 2η·(w + 1). It has the same bits as the exact one; but once it is scaled, the loss is
 * scaled along, and the exact one's is not. As a share of w this is 2η·(w + 1)/w.
 * <li>Scaling it from weight w and falloff f to w′ and f′ adds at most η·(1 + w) by the ratio of the weights and the product
 * with it, which the second factor f′/f scales along, and η·(1 + w′) by that factor and its product.
 * <li>The exact contribution of w′ and f′ has lost 2η·(w′ + 1) of its own.
 * </ul>
 *
 * <p>What was lost before a scaling is scaled along, so it stays the same share of w′·f′. The last two together are a share of
 * at most 4η·(w + w′ + 4)/(w′·f) with the least f of the old and new falloffs, and only add up, however often a slider
 * goes up and down. As long as only weights change, no falloff need be known: then the shares are of w, and become shares
 * of w·f when falloffs change. Some rows of a layer may be younger than its stamp tells: they entered a cone, their
 * material changed, or their tile was computed anew. So before each scaling the share is at least that of a contribution
 * just computed for the light as it was.
 *
 * <p>Rows whose falloff is below the least normal float count as if it were that: no ratio of falloffs scales them any more,
 * and of weights no falloff need be known. A channel whose weight w′ is below it was scaled once, from a normal weight, and
 * is scaled no more either: beyond its shares it is off by at most w′ + η. What closes the equation underflows by less than
 * 64η. Both are within two least normal floats for each light. A is twice the sum over the lights, for diffuse and
 * specular contributions, on each level of mirrors.
 *
 * <p>So far no term is above 1. Of a metallic material the specular and the grazing one are at most T
 * ({@link MaterialTable#maxTerm}); each loss above is at most that of a term of 1, T times, so that A is 1 + 2T times the sum.
 */
final class RatioBound {
    private static final double UNIT_ROUNDOFF = 0x1p-24;
    private static final double UNDERFLOW = 0x1p-150;

    private RatioBound() {}

    /**
     * The stamp of a layer after it was scaled.
     *
     * @param weight       whether weights were scaled
     * @param falloff      whether falloffs were scaled
     * @param minFalloff the least falloff, old or new, of rows whose falloff was scaled
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

    /** What contributions lose that are computed and not scaled, as a share of the weight. */
    private static double initialLoss(Light light) {
        return 2 * UNDERFLOW * (weight(light) + 1) / minWeight(light);
    }

    private static double weight(Light light) {
        return light.weight().max();
    }

    /** The least weight of a channel that is a normal float; +∞ where there is none. */
    private static double minWeight(Light light) {
        double min = Double.POSITIVE_INFINITY;
        Rgb weight = light.weight();
        for (double channel : new double[] {weight.r(), weight.g(), weight.b()}) {
            // Rounded as the contributions' weight is.
            float w = (float) channel;
            min = w >= Float.MIN_NORMAL ? Math.min(min, w) : min;
        }
        return min;
    }

    /**
     * The relative part γ(N)/(1 − γ(N)) over all layers of one level; 0 where nothing was scaled.
     *
     * @param mirrors in how many mirrors the level is seen at most
     * @param samples of how many samples a pixel is the mean
     */
    static double relative(LayerStamp[] stamps, int mirrors, int samples) {
        int max = 0;
        for (LayerStamp stamp : stamps) {
            max = Math.max(max, stamp instanceof ScaledStamp scaled ? scaled.roundings() : 0);
        }
        if (max == 0) {
            return 0;
        }
        int mean = samples == 1 ? 0 : treeDepth(samples) + 1;
        double n = 6 + max + 2.0 * (treeDepth(stamps.length) + 5 + 2 * mirrors + mean);
        double gamma = n * UNIT_ROUNDOFF / (1 - n * UNIT_ROUNDOFF);
        return gamma / (1 - gamma);
    }

    /** The depth of the balanced sum of so many terms: ⌈log₂ terms⌉. */
    private static int treeDepth(int terms) {
        return 32 - Integer.numberOfLeadingZeros(Math.max(0, terms - 1));
    }

    /** What the terms of one light over rows of these materials at most add up to. */
    static double maxTermSum(MaterialTable materials) {
        return materials.hasMetallic() ? 1 + 2 * materials.maxTerm() : 2;
    }

    /**
     * The absolute part A of as many levels as given.
     *
     * @param terms what the terms of one light at most add up to ({@link #maxTermSum})
     */
    static double absolute(LayerStamp[] stamps, int levels, double terms) {
        double sum = 0;
        for (LayerStamp stamp : stamps) {
            if (stamp instanceof ScaledStamp scaled && scaled.roundings() > 0) {
                sum += weight(scaled.light()) * (scaled.contributionLoss() + scaled.weightLoss()) + 2 * Float.MIN_NORMAL;
            }
        }
        return levels * terms * sum;
    }
}
