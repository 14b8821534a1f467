package lightning.scene;

/**
 * How a light fades with distance d: min(1 / (constant + linear·d + quadratic·d²), 1), where 1/0
 * counts as 1 (paper §2.2).
 */
public record Attenuation(double constant, double linear, double quadratic) {
    /** No fading: the factor is 1 at every distance. */
    public static final Attenuation NONE = new Attenuation(1, 0, 0);

    public Attenuation {
        SceneLimits.checkRange("attenuation constant", constant, 0, SceneLimits.MAX_ATTENUATION);
        SceneLimits.checkRange("attenuation linear", linear, 0, SceneLimits.MAX_ATTENUATION);
        SceneLimits.checkRange("attenuation quadratic", quadratic, 0, SceneLimits.MAX_ATTENUATION);
        // A zero without sign: 1/−0 is −∞, which would be less than 1.
        constant += 0.0;
        linear += 0.0;
        quadratic += 0.0;
    }

    /** Whether the factor is 1 at every distance. */
    public boolean isNone() {
        return linear == 0 && quadratic == 0 && constant <= 1;
    }
}
