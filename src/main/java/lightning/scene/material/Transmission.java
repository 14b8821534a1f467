package lightning.scene.material;

import io.soabase.recordbuilder.core.RecordBuilder;
import lightning.base.math.Rgb;

/**
 * Transparency of a material, and absorption inside it.
 *
 * @param color        factor of the transmitted light; black for an opaque surface
 * @param ior          index of refraction, relative to the surroundings
 * @param thin         true for a thin sheet, which does not refract and has no interior
 * @param tint         color of white light after {@code tintDistance} inside
 * @param tintDistance scene units
 * @param shadows      shadows cast by shapes with the material, transparent or not
 */
@RecordBuilder
public record Transmission(Rgb color, double ior, boolean thin, Rgb tint, double tintDistance, ShadowCasting shadows)
        implements TransmissionBuilder.With {
    /** Opaque surface. */
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

    /** Returns whether the surface is transparent. */
    public boolean isTransparent() {
        return (float) color.max() > 0;
    }

    /** Returns whether light is absorbed inside. */
    public boolean isTinted() {
        return isTransparent() && !thin && (float) tint.min() < 1;
    }

    /** Returns whether shapes with the material block light. */
    public boolean castsShadows() {
        return switch (shadows) {
            case FULL, ONLY -> true;
            case TINTED -> !isTransparent();
            case NONE -> false;
        };
    }

    /** Returns whether rays other than shadow rays meet shapes with the material. */
    public boolean isSeen() {
        return shadows != ShadowCasting.ONLY;
    }

    /** Returns whether shapes with the material tint the light that passes them on its way to a shading point. */
    public boolean tintsShadows() {
        return shadows == ShadowCasting.TINTED && isTransparent();
    }

    /** Returns whether both refract every ray in the same way. */
    public boolean refractsLike(Transmission o) {
        return this == o || isTransparent() == o.isTransparent() && (!isTransparent() || ior == o.ior && thin == o.thin);
    }
}
