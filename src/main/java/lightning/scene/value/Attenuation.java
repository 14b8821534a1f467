package lightning.scene.value;

/** Distance attenuation of a light: min(1 / (constant + linear·d + quadratic·d²), 1) at distance d, where 1/0 counts as 1 (paper §2.2). */
public record Attenuation(double constant, double linear, double quadratic) {
    /** No attenuation: the factor is 1 at every distance. */
    public static final Attenuation NONE = new Attenuation(1, 0, 0);

    /** Terms of the inverse-square law. */
    public static final Attenuation INVERSE_SQUARE = new Attenuation(0, 0, 1);

    public Attenuation {
        SceneLimits.checkRange("attenuation constant", constant, 0, SceneLimits.MAX_ATTENUATION);
        SceneLimits.checkRange("attenuation linear", linear, 0, SceneLimits.MAX_ATTENUATION);
        SceneLimits.checkRange("attenuation quadratic", quadratic, 0, SceneLimits.MAX_ATTENUATION);
        // Removes the sign of zero: 1/−0 is −∞, which would be less than 1.
        constant += 0.0;
        linear += 0.0;
        quadratic += 0.0;
    }

    /** Returns whether the factor is 1 at every distance. */
    public boolean isNone() {
        return linear == 0 && quadratic == 0 && constant <= 1;
    }
}
