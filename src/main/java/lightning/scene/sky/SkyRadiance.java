package lightning.scene.sky;

import lightning.base.math.Rgb;

/**
 * Colors of a clear sky at the ground, in nits.
 *
 * <p>A ray collects the sun's light that molecules and aerosols scatter once, without the phase functions, which depend only on the ray's angle to
 * the sun, and what air has scattered before. These three colors vary slowly over the sky, so a coarse table of half of it is enough; the phases
 * are exact in each direction (Nishita et al., Display of the earth taking into account atmospheric scattering, 1993).
 */
final class SkyRadiance {
    private static final int ELEVATIONS = 48;
    private static final int AZIMUTHS = 16;
    private static final int STEPS = 40;
    /** Molecules, aerosols, and further scattering, three channels each. */
    private static final int TERMS = 9;

    /** Linear color of the sun's light on a surface that faces it, lux. */
    final Rgb sun;
    /** Linear color of the whole sky's light on the ground, without the sun, lux. */
    final Rgb skylight;
    private final float[] terms = new float[ELEVATIONS * AZIMUTHS * TERMS];
    private final double sunCos;
    private final double sunSin;

    /** @param elevation of the sun, radians */
    SkyRadiance(Atmosphere air, MultipleScattering multiple, double elevation) {
        sunCos = StrictMath.sin(elevation);
        sunSin = StrictMath.cos(elevation);
        double[] toSun = new double[Atmosphere.COLUMNS];
        double[] spectrum = new double[SolarSpectrum.BANDS];
        if (SunColumns.TABLE.write(Atmosphere.GROUND, sunCos, toSun)) {
            for (int b = 0; b < SolarSpectrum.BANDS; b++) {
                spectrum[b] = StrictMath.exp(-air.depth(b, toSun));
            }
        }
        sun = SolarSpectrum.color(spectrum);
        for (int i = 0; i < ELEVATIONS * AZIMUTHS; i++) {
            march(air, multiple, i / AZIMUTHS, i % AZIMUTHS);
        }
        skylight = integrate();
    }

    private void march(Atmosphere air, MultipleScattering multiple, int row, int column) {
        double share = (double) row / (ELEVATIONS - 1);
        double cos = StrictMath.sin(Math.PI / 2 * share * share);
        double ahead = Math.sqrt(1 - cos * cos) * StrictMath.cos(Math.PI * column / (AZIMUTHS - 1));
        double length = Atmosphere.toTop(Atmosphere.GROUND, cos);
        double[] density = new double[Atmosphere.COLUMNS];
        double[] columns = new double[Atmosphere.COLUMNS];
        double[] toSun = new double[Atmosphere.COLUMNS];
        double[] further = new double[SolarSpectrum.BANDS];
        double[][] sum = new double[TERMS / 3][SolarSpectrum.BANDS];
        for (int i = 0; i < STEPS; i++) {
            double u = (i + 0.5) / STEPS;
            double t = length * u * u;
            double step = length * 2 * u / STEPS;
            double r = Math.sqrt(t * t + 2 * Atmosphere.GROUND * cos * t + Atmosphere.GROUND * Atmosphere.GROUND);
            double sunThere = Math.clamp((Atmosphere.GROUND * sunCos + t * (ahead * sunSin + cos * sunCos)) / r, -1, 1);
            Atmosphere.writeDensities(r, density);
            boolean isLit = SunColumns.TABLE.write(r, sunThere, toSun);
            multiple.write(r, sunThere, further);
            Atmosphere.addColumns(columns, density, step / 2);
            for (int b = 0; b < SolarSpectrum.BANDS; b++) {
                double depth = air.depth(b, columns);
                double molecules = air.molecules[b] * density[0] * step;
                double aerosols = Atmosphere.ALBEDO * air.aerosols[b] * density[1] * step;
                if (isLit) {
                    double passed = StrictMath.exp(-depth - air.depth(b, toSun));
                    sum[0][b] += molecules * passed;
                    sum[1][b] += aerosols * passed;
                }
                sum[2][b] += (molecules + aerosols) * StrictMath.exp(-depth) * further[b];
            }
            Atmosphere.addColumns(columns, density, step / 2);
        }
        int at = (row * AZIMUTHS + column) * TERMS;
        for (int k = 0; k < sum.length; k++) {
            Rgb color = SolarSpectrum.color(sum[k]);
            terms[at + 3 * k] = (float) color.r();
            terms[at + 3 * k + 1] = (float) color.g();
            terms[at + 3 * k + 2] = (float) color.b();
        }
    }

    /**
     * Writes the color of the sky, without the sun, in nits.
     *
     * @param sin     sine of the direction's elevation, 0…1
     * @param azimuth from the sun's, −π…π
     */
    void write(double sin, double azimuth, double[] to) {
        double row = Math.sqrt(StrictMath.asin(Math.min(sin, 1)) * 2 / Math.PI) * (ELEVATIONS - 1);
        double column = Math.abs(azimuth) / Math.PI * (AZIMUTHS - 1);
        int y = Math.min((int) row, ELEVATIONS - 2);
        int x = Math.min((int) column, AZIMUTHS - 2);
        double s = Math.min(column - x, 1);
        double t = Math.min(row - y, 1);
        int at = (y * AZIMUTHS + x) * TERMS;
        int above = at + AZIMUTHS * TERMS;
        double cos = sin * sunCos + Math.sqrt(Math.max(0, 1 - sin * sin)) * sunSin * StrictMath.cos(azimuth);
        double rayleigh = 3 / (16 * Math.PI) * (1 + cos * cos);
        double mie = mie(cos);
        for (int c = 0; c < 3; c++) {
            double sum = 0;
            for (int k = 0; k < 3; k++) {
                int i = 3 * k + c;
                double term = (terms[at + i] * (1 - s) + terms[at + TERMS + i] * s) * (1 - t)
                        + (terms[above + i] * (1 - s) + terms[above + TERMS + i] * s) * t;
                sum += term * (k == 0 ? rayleigh : k == 1 ? mie : 1);
            }
            to[c] = sum;
        }
    }

    /** Returns the phase function of aerosols, per steradian (Cornette and Shanks, 1992). */
    private static double mie(double cos) {
        double g = Atmosphere.ANISOTROPY;
        double base = 1 + g * g - 2 * g * cos;
        return 3 / (8 * Math.PI) * (1 - g * g) / (2 + g * g) * (1 + cos * cos) / (base * Math.sqrt(base));
    }

    private Rgb integrate() {
        int rows = 64;
        int columns = 64;
        double[] color = new double[3];
        double[] sum = new double[3];
        for (int i = 0; i < rows * columns; i++) {
            // Equal parts of the projected hemisphere.
            write(Math.sqrt((i / columns + 0.5) / rows), Math.PI * (i % columns + 0.5) / columns, color);
            for (int c = 0; c < 3; c++) {
                sum[c] += color[c];
            }
        }
        double share = Math.PI / (rows * columns);
        return new Rgb(sum[0] * share, sum[1] * share, sum[2] * share);
    }
}
