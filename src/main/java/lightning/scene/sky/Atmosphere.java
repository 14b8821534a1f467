package lightning.scene.sky;

/**
 * Air around the earth: molecules, aerosols and ozone.
 *
 * <p>Lengths are in meters, coefficients per meter. Molecules scatter by 1.24062·10⁻⁶ λ⁻⁴ at the ground, λ in µm, and thin out by e each 8 km
 * (Rayleigh). Aerosols have an optical depth of β λ^−1.3, with β = 0.04608 T − 0.04586 for turbidity T (Preetham, Shirley and Smits, A practical
 * analytic model for daylight, 1999), thin out by e each 1.2 km, and scatter 9/10 of the light that they take. Ozone absorbs, in a layer
 * around 25 km of 300 Dobson units. Its cross sections are those of Serdyuchenko et al. (2014) at 233 K, as means of bands.
 */
final class Atmosphere {
    static final double GROUND = 6_360_000;
    static final double TOP = 6_460_000;
    /** Share of the light that aerosols take and scatter. */
    static final double ALBEDO = 0.9;
    /** Mean cosine of the angle by which aerosols scatter. */
    static final double ANISOTROPY = 0.8;
    /** Number of columns: molecules, aerosols, ozone. */
    static final int COLUMNS = 3;

    private static final double MOLECULES_HEIGHT = 8000;
    private static final double AEROSOLS_HEIGHT = 1200;
    private static final double OZONE_HEIGHT = 25_000;
    private static final double OZONE_EXTENT = 15_000;
    /** Largest number of ozone molecules per cubic meter: 300 Dobson units in a triangular layer. */
    private static final double OZONE = 300 * 2.687e20 / OZONE_EXTENT;
    /** Cross sections of ozone, 10⁻²⁶ m². */
    private static final double[] OZONE_SECTIONS =
            {0.2145, 0.6986, 1.949, 4.2965, 8.384, 15.41, 24.47, 32.955, 44.69, 45.495, 46.62, 34.775,
                24.5, 16.625, 10.7565, 7.0105};

    /** Scattering by molecules at the ground, {@code double[BANDS]}. */
    final double[] molecules = new double[SolarSpectrum.BANDS];
    /** Extinction by aerosols at the ground, {@code double[BANDS]}. */
    final double[] aerosols = new double[SolarSpectrum.BANDS];
    private final double[] ozone = new double[SolarSpectrum.BANDS];

    /** @param turbidity 1 for pure air, 2 to 3 for a clear day, 10 for haze */
    Atmosphere(double turbidity) {
        double beta = 0.04608 * turbidity - 0.04586;
        for (int i = 0; i < SolarSpectrum.BANDS; i++) {
            double micrometers = SolarSpectrum.wavelength(i) / 1000;
            molecules[i] = 1.24062e-6 / (micrometers * micrometers * micrometers * micrometers);
            aerosols[i] = beta * StrictMath.pow(micrometers, -1.3) / AEROSOLS_HEIGHT;
            ozone[i] = OZONE_SECTIONS[i] * 1e-26 * OZONE;
        }
    }

    /** Writes the densities at a distance from the earth's center, relative to those at the ground or the layer's middle. */
    static void writeDensities(double r, double[] to) {
        double height = Math.max(r - GROUND, 0);
        to[0] = StrictMath.exp(-height / MOLECULES_HEIGHT);
        to[1] = StrictMath.exp(-height / AEROSOLS_HEIGHT);
        to[2] = Math.max(0, 1 - Math.abs(height - OZONE_HEIGHT) / OZONE_EXTENT);
    }

    /** Adds a piece of a path to the columns along it. */
    static void addColumns(double[] columns, double[] densities, double length) {
        for (int c = 0; c < COLUMNS; c++) {
            columns[c] += densities[c] * length;
        }
    }

    /**
     * Returns the optical depth of a path in a band.
     *
     * @param columns integrals of the densities along the path, m
     */
    double depth(int band, double[] columns) {
        return molecules[band] * columns[0] + aerosols[band] * columns[1] + ozone[band] * columns[2];
    }

    /** Returns the distance to the top of the air, from a point inside at {@code r} along a ray with this cosine to the vertical. */
    static double toTop(double r, double cos) {
        return Math.max(0, -r * cos + Math.sqrt(Math.max(0, r * r * (cos * cos - 1) + TOP * TOP)));
    }

    /** Returns the distance to the ground; infinite if the ray misses it. */
    static double toGround(double r, double cos) {
        double d = r * r * (cos * cos - 1) + GROUND * GROUND;
        return cos >= 0 || d < 0 ? Double.POSITIVE_INFINITY : Math.max(0, -r * cos - Math.sqrt(d));
    }
}
