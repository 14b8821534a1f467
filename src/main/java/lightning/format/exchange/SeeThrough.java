package lightning.format.exchange;

import lightning.base.math.Rgb;
import lightning.scene.Clarity;
import lightning.scene.Limits;
import lightning.scene.Material;
import lightning.scene.MaterialAttribute;
import lightning.scene.ShadowsThrown;

/** Makes materials clear by what other programs say of them. */
final class SeeThrough {
    /** Glass needs this many bounces at least: in, through, out, and what mirrors on the way. */
    private static final int DEPTH = 6;

    private final Pieces pieces;

    SeeThrough(Pieces pieces) {
        this.pieces = pieces;
    }

    /**
     * The material with a share of itself gone, through which {@code color} of what is behind is seen. What is left of its own colour is that
     * share, which {@link Clarity} by itself gives only a colourless one.
     *
     * @param share    0 … 1, how much passes
     * @param color    0 … 1, what that is multiplied by
     * @param ior      the index of refraction; brought into its range
     * @param thin     whether it is a pane
     * @param metallic how much of it is a metal, which nothing passes
     */
    Material made(Material opaque, double share, Rgb color, double ior, boolean thin, double metallic) {
        Rgb clear = color.times(share * (1 - metallic));
        if (!((float) clear.max() > 0)) {
            return opaque;
        }
        pieces.picture = pieces.picture.withDepth(Math.max(pieces.picture.depth(), DEPTH));
        pieces.notes.add("emission of materials that light goes through, weakened here", opaque.ambient().isBlack() ? 0 : 1);
        double left = clear.max() < 1 ? (1 - share) / (1 - clear.max()) : 0;
        Material body = metallic > 0 ? opaque : opaque.withBody(opaque.body().times(Math.min(left, 1)));
        return body.withClarity(new Clarity(clear, ior >= 1 ? Math.min(ior, Limits.MAX_IOR) : 1, thin,
                MaterialAttribute.TINT.initial(), MaterialAttribute.TINT_DISTANCE.initial(),
                ShadowsThrown.TINTED));
    }

    /** The share {@code 1 − alpha} gone as if it were a veil: what is behind is seen straight, and nothing is mirrored. */
    Material veil(Material opaque, double alpha) {
        return made(opaque, 1 - alpha, Rgb.WHITE, 1, true, 0);
    }
}
