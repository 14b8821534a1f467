package lightning.scene.sky;

import lightning.base.math.CieXyz;
import lightning.base.math.Rgb;

/**
 * Spectrum of the sun outside of the air, and colors of spectra in bands.
 *
 * <p>Spectra have {@value #BANDS} bands of 20 nm from 400 nm. The sun's irradiance is the mean of the bands of ASTM G-173-03 (reference solar
 * spectral irradiances, extraterrestrial column). The color matching functions are the fits of Wyman, Sloan and Shirley (Simple analytic
 * approximations to the CIE XYZ color matching functions, 2013).
 */
final class SolarSpectrum {
    static final int BANDS = 16;
    private static final double FIRST = 400;
    private static final double WIDTH = 20;
    /** Lumens per watt at the peak of the luminous efficiency. */
    private static final double LUMENS = 683;
    /** Irradiance, W/(m² nm). */
    private static final double[] IRRADIANCE = {1.7291, 1.6506, 1.9734, 2.0213, 1.9459, 1.8733, 1.8808, 1.8509, 1.8343, 1.7981, 1.7249,
        1.6642, 1.5631, 1.5338, 1.4611, 1.3890};

    /** Color matching functions of the bands. */
    private static final double[] X = new double[BANDS];
    private static final double[] Y = new double[BANDS];
    private static final double[] Z = new double[BANDS];

    static {
        for (int i = 0; i < BANDS; i++) {
            double w = wavelength(i);
            X[i] = 1.056 * lobe(w, 599.8, 37.9, 31.0) + 0.362 * lobe(w, 442.0, 16.0, 26.7) - 0.065 * lobe(w, 501.1, 20.4, 26.2);
            Y[i] = 0.821 * lobe(w, 568.8, 46.9, 40.5) + 0.286 * lobe(w, 530.9, 16.3, 31.1);
            Z[i] = 1.217 * lobe(w, 437.0, 11.8, 36.0) + 0.681 * lobe(w, 459.0, 26.0, 13.8);
        }
    }

    private SolarSpectrum() {}

    /** Returns the middle of a band, nm. */
    static double wavelength(int band) {
        return FIRST + WIDTH * (band + 0.5);
    }

    /**
     * Returns the linear color of the sun's spectrum times a factor in each band; its luminance is in lux for an irradiance, or in nits for a
     * radiance. Colors outside of sRGB are clamped.
     *
     * @param factor {@code double[BANDS]}, ≥ 0
     */
    static Rgb color(double[] factor) {
        double x = 0;
        double y = 0;
        double z = 0;
        for (int i = 0; i < BANDS; i++) {
            double power = factor[i] * IRRADIANCE[i] * WIDTH * LUMENS;
            x += power * X[i];
            y += power * Y[i];
            z += power * Z[i];
        }
        return CieXyz.rgb(x, y, z);
    }

    private static double lobe(double wavelength, double mean, double below, double above) {
        double t = (wavelength - mean) / (wavelength < mean ? below : above);
        return StrictMath.exp(-0.5 * t * t);
    }
}
