package lightning.scene.light;

import io.soabase.recordbuilder.core.RecordBuilder;
import lightning.scene.attribute.NumericKind;
import lightning.scene.value.SceneLimits;
import lightning.scene.value.ShapeGains;

/**
 * Effect of a light on surfaces and fog, apart from its own brightness.
 *
 * @param castsShadows false if no shape blocks or tints the light, so that it casts no shadow rays
 * @param diffuse      factor of its diffuse contributions, also in indirect light
 * @param specular     factor of its specular contributions
 * @param fog          factor of the light that fog scatters
 * @param gains        factors of all its contributions on single shapes and groups
 */
@RecordBuilder
public record Influence(boolean castsShadows, double diffuse, double specular, double fog, ShapeGains gains)
        implements InfluenceBuilder.With {
    static final NumericKind<Double> GAINS = NumericKind.number(0, SceneLimits.MAX_GAIN, 0.1);

    /** Shadows of all shapes, and all factors 1. */
    public static final Influence DEFAULT = new Influence(true, 1, 1, 1, ShapeGains.NONE);

    /** @throws IllegalArgumentException if a gain is out of range; the message says which */
    public Influence {
        GAINS.check("diffuse", diffuse);
        GAINS.check("specular", specular);
        GAINS.check("fog", fog);
    }

    /** Returns whether any factor may differ from 1. */
    public boolean isGained() {
        return diffuse != 1 || specular != 1 || fog != 1 || !gains.isNone();
    }

    /** Returns the largest factor of contributions. */
    double maxGain() {
        return Math.max(Math.max(diffuse, specular), fog);
    }
}
