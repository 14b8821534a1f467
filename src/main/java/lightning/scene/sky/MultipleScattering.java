package lightning.scene.sky;

import java.util.Arrays;

/**
 * Light that air has scattered at least twice, or the ground and the air, by height and by the sun's height: the series of all orders, as if
 * every further one were scattered evenly (Hillaire, A scalable and production ready sky and atmosphere rendering technique, 2020, equations 5 to 10).
 */
final class MultipleScattering {
    private static final int HEIGHTS = 12;
    private static final int SUNS = 20;
    private static final int ZENITHS = 8;
    private static final int AZIMUTHS = 4;
    private static final int STEPS = 16;
    /** Least cosine of the sun's angle to the vertical that the table has. */
    private static final double LEAST_COSINE = -0.35;

    private final float[] light = new float[HEIGHTS * SUNS * SolarSpectrum.BANDS];
    private final Atmosphere air;
    private final double[] ground;
    private final double[] density = new double[Atmosphere.COLUMNS];
    private final double[] columns = new double[Atmosphere.COLUMNS];
    private final double[] toSun = new double[Atmosphere.COLUMNS];
    private final double[] second = new double[SolarSpectrum.BANDS];
    private final double[] again = new double[SolarSpectrum.BANDS];

    /** @param ground share of light that the ground reflects, {@code double[BANDS]}, 0…1 */
    MultipleScattering(Atmosphere air, double[] ground) {
        this.air = air;
        this.ground = ground;
        for (int h = 0; h < HEIGHTS; h++) {
            double share = (double) h / (HEIGHTS - 1);
            double r = Atmosphere.GROUND + (Atmosphere.TOP - Atmosphere.GROUND) * share * share;
            for (int sun = 0; sun < SUNS; sun++) {
                fill(r, LEAST_COSINE + (1 - LEAST_COSINE) * sun / (SUNS - 1), (h * SUNS + sun) * SolarSpectrum.BANDS);
            }
        }
    }

    private void fill(double r, double sunCos, int at) {
        Arrays.fill(second, 0);
        Arrays.fill(again, 0);
        double sunSin = Math.sqrt(Math.max(0, 1 - sunCos * sunCos));
        for (int i = 0; i < ZENITHS; i++) {
            double cos = 1 - 2 * (i + 0.5) / ZENITHS;
            double sin = Math.sqrt(1 - cos * cos);
            for (int j = 0; j < AZIMUTHS; j++) {
                // The sky is the same on both sides of the sun.
                double azimuth = Math.PI * (j + 0.5) / AZIMUTHS;
                march(r, cos, sin * StrictMath.cos(azimuth), sunCos, sunSin);
            }
        }
        for (int i = 0; i < SolarSpectrum.BANDS; i++) {
            double directions = ZENITHS * AZIMUTHS;
            light[at + i] = (float) (second[i] / directions / (1 - again[i] / directions));
        }
    }

    /**
     * Adds the light of one direction, and the share of it that is scattered again.
     *
     * @param cos   cosine of the direction's angle to the vertical
     * @param ahead its part toward the sun's azimuth
     */
    private void march(double r, double cos, double ahead, double sunCos, double sunSin) {
        double toGround = Atmosphere.toGround(r, cos);
        double length = Math.min(toGround, Atmosphere.toTop(r, cos));
        double step = length / STEPS;
        Arrays.fill(columns, 0);
        for (int i = 0; i < STEPS; i++) {
            double t = (i + 0.5) * step;
            double there = Math.sqrt(t * t + 2 * r * cos * t + r * r);
            Atmosphere.writeDensities(there, density);
            double sunThere = Math.clamp((r * sunCos + t * (ahead * sunSin + cos * sunCos)) / there, -1, 1);
            boolean isLit = SunColumns.TABLE.write(there, sunThere, toSun);
            Atmosphere.addColumns(columns, density, step / 2);
            for (int b = 0; b < SolarSpectrum.BANDS; b++) {
                double scattered = (air.molecules[b] * density[0] + Atmosphere.ALBEDO * air.aerosols[b] * density[1]) * step;
                double depth = air.depth(b, columns);
                again[b] += scattered * StrictMath.exp(-depth);
                if (isLit) {
                    second[b] += scattered * StrictMath.exp(-depth - air.depth(b, toSun)) / (4 * Math.PI);
                }
            }
            Atmosphere.addColumns(columns, density, step / 2);
        }
        if (toGround == length) {
            double sunThere = (r * sunCos + length * (ahead * sunSin + cos * sunCos)) / Atmosphere.GROUND;
            if (sunThere > 0 && SunColumns.TABLE.write(Atmosphere.GROUND, Math.min(sunThere, 1), toSun)) {
                for (int b = 0; b < SolarSpectrum.BANDS; b++) {
                    second[b] += ground[b] / Math.PI * sunThere * StrictMath.exp(-air.depth(b, columns) - air.depth(b, toSun));
                }
            }
        }
    }

    /** Writes the light at a point for a sun of irradiance 1, {@code double[BANDS]}: radiance, the same from all directions. */
    void write(double r, double sunCos, double[] to) {
        double h = Math.sqrt(Math.clamp((r - Atmosphere.GROUND) / (Atmosphere.TOP - Atmosphere.GROUND), 0, 1)) * (HEIGHTS - 1);
        double s = Math.clamp((sunCos - LEAST_COSINE) / (1 - LEAST_COSINE), 0, 1) * (SUNS - 1);
        int h0 = Math.min((int) h, HEIGHTS - 2);
        int s0 = Math.min((int) s, SUNS - 2);
        int at = (h0 * SUNS + s0) * SolarSpectrum.BANDS;
        int above = at + SUNS * SolarSpectrum.BANDS;
        for (int b = 0; b < SolarSpectrum.BANDS; b++) {
            double low = light[at + b] * (1 - (s - s0)) + light[at + SolarSpectrum.BANDS + b] * (s - s0);
            double high = light[above + b] * (1 - (s - s0)) + light[above + SolarSpectrum.BANDS + b] * (s - s0);
            to[b] = low * (1 - (h - h0)) + high * (h - h0);
        }
    }
}
