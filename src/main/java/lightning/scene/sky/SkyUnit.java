package lightning.scene.sky;

/** Unit of a sky's brightness. */
public enum SkyUnit {
    /** A value of 1 is 10 000 nits, so that white paper in the sun of noon has about 3. */
    RELATIVE(10_000),
    /** A value of 1 is 1 nit, as for lights with photometric units. */
    NIT(1);

    private final double nits;

    SkyUnit(double nits) {
        this.nits = nits;
    }

    /** Returns the luminance of a value of 1, nits. */
    double nits() {
        return nits;
    }
}
