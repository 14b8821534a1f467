package lightning.image;

/** How light that lies between black and the display's white becomes 8 bits, correctly rounded. */
public enum DisplayCurve {
    /**
     * What displays expect (IEC 61966-2-1): {@code 12.92 · v} up to v = 0.0031308, else {@code 1.055 · v^(1/2.4) − 0.055}.
     */
    SRGB,
    /**
     * As computed in 1998: the linear value itself, {@code 255 · v}. Programs of that time sent it to the display as it was,
     * which shows mid tones darker and shadows deeper than they are.
     */
    LINEAR;

    private static final float WHITE = 255;

    /** The code, 0 to 255, of a linear value; below 0 and NaN count as 0, above 1 as 1. */
    int encode(float linear) {
        return switch (this) {
            case SRGB -> Srgb.encode(linear);
            // The conversion to int makes NaN and what is below 0 no code below 0: 0.5 below 0 already is 0.
            case LINEAR -> (int) Math.clamp((double) linear * WHITE + 0.5, 0, WHITE);
        };
    }
}
