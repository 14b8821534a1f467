package lightning.format.exchange;

import lightning.base.math.Rgb;
import lightning.scene.Material;
import lightning.scene.MaterialAttribute;
import lightning.scene.SceneLimits;
import lightning.scene.ShadowCasting;
import lightning.scene.Transmission;

/** Makes materials clear by what other programs say of them. */
final class TransmissionImport {
    /** Glass needs this many bounces at least: in, through, out, and what mirrors on the way. */
    private static final int MIN_DEPTH = 6;

    private final SceneAssembler assembler;

    TransmissionImport(SceneAssembler assembler) {
        this.assembler = assembler;
    }

    /**
     * The material with a share of itself gone, through which {@code color} of what is behind is seen. What is left of its own color is that
     * share, which {@link Transmission} by itself gives only a colorless one.
     *
     * @param transmission    0 … 1, how much passes
     * @param color    0 … 1, what that is multiplied by
     * @param ior      the index of refraction; brought into its range
     * @param isThin     whether it is a pane
     * @param metallic how much of it is a metal, which nothing passes
     */
    Material withTransmission(Material opaque, double transmission, Rgb color, double ior, boolean isThin, double metallic) {
        Rgb transmitted = color.times(transmission * (1 - metallic));
        if (!((float) transmitted.max() > 0)) {
            return opaque;
        }
        assembler.picture = assembler.picture.withDepth(Math.max(assembler.picture.depth(), MIN_DEPTH));
        assembler.notes.add("emission of materials that light goes through, weakened here", opaque.ambient().isBlack() ? 0 : 1);
        double remaining = transmitted.max() < 1 ? (1 - transmission) / (1 - transmitted.max()) : 0;
        Material body = metallic > 0 ? opaque : opaque.withAlbedo(opaque.albedo().times(Math.min(remaining, 1)));
        return body.withTransmission(new Transmission(transmitted, ior >= 1 ? Math.min(ior, SceneLimits.MAX_IOR) : 1, isThin,
                MaterialAttribute.TINT.initial(), MaterialAttribute.TINT_DISTANCE.initial(),
                ShadowCasting.TINTED));
    }

    /** The share {@code 1 − alpha} gone as if it were a veil: what is behind is seen straight, and nothing is mirrored. */
    Material withOpacity(Material opaque, double alpha) {
        return withTransmission(opaque, 1 - alpha, Rgb.WHITE, 1, true, 0);
    }
}
