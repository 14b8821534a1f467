package lightning.format.exchange.assembly;

import lightning.base.math.Rgb;
import lightning.scene.material.Material;
import lightning.scene.material.MaterialAttribute;
import lightning.scene.material.ShadowCasting;
import lightning.scene.material.Transmission;
import lightning.scene.value.SceneLimits;

/** Converter of other programs' transparency to transmissive materials. */
public record TransmissionImport(SceneAssembler assembler) {
    /** Minimum reflection depth for glass: in, through, out, and one reflection. */
    private static final int MIN_DEPTH = 6;

    /**
     * Returns a material with a share replaced by transmission tinted with {@code color}. The rest keeps the
     * material's own color; {@link Transmission} alone supports that only for colorless ones.
     *
     * @param transmission transmitted share, 0 … 1
     * @param color transmission tint, 0 … 1
     * @param ior index of refraction, clamped to its range
     * @param isThin true for a thin sheet
     * @param metallic metallic share, which transmits nothing
     */
    public Material withTransmission(Material opaque, double transmission, Rgb color, double ior, boolean isThin, double metallic) {
        Rgb transmitted = color.times(transmission * (1 - metallic));
        if (!((float) transmitted.max() > 0)) {
            return opaque;
        }
        assembler.picture = assembler.picture.withDepth(Math.max(assembler.picture.depth(), MIN_DEPTH));
        assembler.notes.add("emission of transparent materials, weakened", opaque.ambient().isBlack() && opaque.glow().isBlack() ? 0 : 1);
        assembler.notes.add("transparent metals, which reflect only lights", opaque.metalness() > 0 ? 1 : 0);
        double remaining = transmitted.max() < 1 ? (1 - transmission) / (1 - transmitted.max()) : 0;
        Material body = metallic > 0 ? opaque : opaque.withAlbedo(opaque.albedo().times(Math.min(remaining, 1)));
        return body.withTransmission(new Transmission(transmitted, ior >= 1 ? Math.min(ior, SceneLimits.MAX_IOR) : 1, isThin,
                MaterialAttribute.TINT.initial(), MaterialAttribute.TINT_DISTANCE.initial(),
                ShadowCasting.TINTED));
    }

    /** Replaces the share {@code 1 − alpha} by a veil: the background is visible without refraction or reflection. */
    public Material withOpacity(Material opaque, double alpha) {
        return withTransmission(opaque, 1 - alpha, Rgb.WHITE, 1, true, 0);
    }
}
