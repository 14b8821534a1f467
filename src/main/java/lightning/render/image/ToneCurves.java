package lightning.render.image;

/** Tone mapping curves that compress highlights above display white, from linear values ≥ 0 to linear display light. */
final class ToneCurves {
    /** White point of the filmic curve. */
    static final double FILMIC_WHITE = 5.6;
    /** White point of the ACES fit: 0.08·v² − 0.56·v − 0.14 = 0. */
    static final double ACES_WHITE = (0.56 + StrictMath.sqrt(0.56 * 0.56 + 4 * 0.08 * 0.14)) / 0.16;

    private ToneCurves() {}

    /**
     * Filmic: Hable's curve with a long shoulder (Filmic Tonemapping Operators, filmicworlds.com, 2010), with its constants and
     * exposure of 2; linear 5.6 is white.
     */
    static double filmic(double v) {
        return v >= FILMIC_WHITE ? 1 : hable(2 * v) / hable(2 * FILMIC_WHITE);
    }

    private static double hable(double x) {
        double a = 0.15;
        double b = 0.50;
        double c = 0.10;
        double d = 0.20;
        double e = 0.02;
        double f = 0.30;
        return (x * (a * x + c * b) + d * e) / (x * (a * x + b) + d * f) - e / f;
    }

    /**
     * ACES: Narkowicz's fit of the reference and output transforms for sRGB displays (ACES Filmic Tone Mapping Curve, 2015), per
     * channel; linear 1 is shown at 0.80, and 7.25 is white.
     */
    static double aces(double v) {
        return v >= ACES_WHITE ? 1 : v * (2.51 * v + 0.03) / (v * (2.43 * v + 0.59) + 0.14);
    }
}
