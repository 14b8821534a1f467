package lightning.scene;

import io.soabase.recordbuilder.core.RecordBuilder;
import lightning.base.math.Rgb;

/**
 * What passes through a surface, and what a body made of the material does to light inside.
 *
 * @param color        the color that what is seen through the surface is multiplied by; black where nothing is
 * @param ior          the index of refraction, that of what is around being 1
 * @param thin         whether the surface is a pane: it bends no ray, and has no inside
 * @param tint         what is left of white after {@code tintDistance} inside
 * @param tintDistance scene units
 * @param shadows      which shadows shapes of the material throw, whether it is clear or not
 */
@RecordBuilder
public record Transmission(Rgb color, double ior, boolean thin, Rgb tint, double tintDistance, ShadowCasting shadows)
        implements TransmissionBuilder.With {
    /** A surface that nothing passes through. */
    public static final Transmission NONE =
            new Transmission(MaterialAttribute.TRANSMISSION_COLOR.initial(), MaterialAttribute.IOR.initial(),
                    MaterialAttribute.THIN.initial(), MaterialAttribute.TINT.initial(), MaterialAttribute.TINT_DISTANCE.initial(),
                    MaterialAttribute.SHADOWS.initial());

    public Transmission {
        MaterialAttribute.TRANSMISSION_COLOR.check(color);
        MaterialAttribute.IOR.check(ior);
        MaterialAttribute.TINT.check(tint);
        MaterialAttribute.TINT_DISTANCE.check(tintDistance);
    }

    /** Whether anything is seen through the surface. */
    public boolean isTransparent() {
        return (float) color.max() > 0;
    }

    /** Whether light loses anything on its way inside. */
    public boolean isTinted() {
        return isTransparent() && !thin && (float) tint.min() < 1;
    }

    /** Whether shapes of the material keep light back in all. */
    public boolean castsShadows() {
        return switch (shadows) {
            case FULL -> true;
            case TINTED -> !isTransparent();
            case NONE -> false;
        };
    }

    /** Whether light on its way to a point passes shapes of the material, and takes their color. */
    public boolean tintsShadows() {
        return shadows == ShadowCasting.TINTED && isTransparent();
    }

    /** Whether rays go on behind every surface as they do by another. */
    public boolean refractsLike(Transmission o) {
        return this == o || isTransparent() == o.isTransparent() && (!isTransparent() || ior == o.ior && thin == o.thin);
    }
}
