package lightning.render.image;

/** Tone mapping curves that compress highlights above display white, from linear values ≥ 0 to linear display light. */
final class ToneCurves {
    /** White point of the ACES fit: 0.08·v² − 0.56·v − 0.14 = 0. */
    static final double ACES_WHITE = (0.56 + StrictMath.sqrt(0.56 * 0.56 + 4 * 0.08 * 0.14)) / 0.16;

    private ToneCurves() {}

    /**
     * ACES: Narkowicz's fit of the reference and output transforms for sRGB displays (ACES Filmic Tone Mapping Curve, 2015), per
     * channel; linear 1 is shown at 0.80, and 7.25 is white.
     */
    static double aces(double v) {
        return v >= ACES_WHITE ? 1 : v * (2.51 * v + 0.03) / (v * (2.43 * v + 0.59) + 0.14);
    }
}
