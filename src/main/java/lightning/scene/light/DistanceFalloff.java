package lightning.scene.light;

import io.soabase.recordbuilder.core.RecordBuilder;
import lightning.scene.value.Attenuation;

/**
 * How a light loses strength with distance.
 *
 * @param falloff     law of the falloff
 * @param attenuation terms of the custom law, per scene unit to the power 0, 1 and 2
 */
@RecordBuilder
public record DistanceFalloff(Falloff falloff, Attenuation attenuation) implements DistanceFalloffBuilder.With {
    /** Initial values of a light: none. */
    public static final DistanceFalloff DEFAULT = new DistanceFalloff(Falloff.CUSTOM, Attenuation.NONE);

    /** Returns the terms that act. */
    public Attenuation terms() {
        return switch (falloff) {
            case CUSTOM -> attenuation;
            case INVERSE_SQUARE -> Attenuation.INVERSE_SQUARE;
        };
    }
}
