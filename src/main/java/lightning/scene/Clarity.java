package lightning.scene;

import io.soabase.recordbuilder.core.RecordBuilder;
import lightning.base.math.Rgb;

/**
 * What passes through a surface, and what a body made of the material does to light inside.
 *
 * @param clear        the colour that what is seen through the surface is multiplied by; black where nothing is
 * @param ior          the index of refraction, that of what is around being 1
 * @param thin         whether the surface is a pane: it bends no ray, and has no inside
 * @param tint         what is left of white after {@code tintDistance} inside
 * @param tintDistance scene units
 * @param shadows      which shadows shapes of the material throw, whether it is clear or not
 */
@RecordBuilder
public record Clarity(Rgb clear, double ior, boolean thin, Rgb tint, double tintDistance, ShadowsThrown shadows)
        implements ClarityBuilder.With {
    /** A surface that nothing passes through. */
    public static final Clarity NONE = new Clarity(MaterialAttribute.CLEAR.initial(), MaterialAttribute.IOR.initial(),
            MaterialAttribute.THIN.initial(), MaterialAttribute.TINT.initial(), MaterialAttribute.TINT_DISTANCE.initial(),
            MaterialAttribute.SHADOWS.initial());

    public Clarity {
        MaterialAttribute.CLEAR.check(clear);
        MaterialAttribute.IOR.check(ior);
        MaterialAttribute.TINT.check(tint);
        MaterialAttribute.TINT_DISTANCE.check(tintDistance);
    }

    /** Whether anything is seen through the surface. */
    public boolean isClear() {
        return (float) clear.max() > 0;
    }

    /** Whether light loses anything on its way inside. */
    public boolean isTinted() {
        return isClear() && !thin && (float) tint.min() < 1;
    }

    /** Whether shapes of the material keep light back in all. */
    public boolean throwsShadows() {
        return switch (shadows) {
            case FULL -> true;
            case TINTED -> !isClear();
            case NONE -> false;
        };
    }

    /** Whether light on its way to a point passes shapes of the material, and takes their colour. */
    public boolean tintsLight() {
        return shadows == ShadowsThrown.TINTED && isClear();
    }

    /** Whether rays go on behind every surface as they do by another. */
    public boolean leadsRaysAs(Clarity o) {
        return this == o || isClear() == o.isClear() && (!isClear() || ior == o.ior && thin == o.thin);
    }
}
