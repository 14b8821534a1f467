package lightning.render.trace;

/**
 * Which texture colors rows have.
 *
 * @param colors colors of textures and of vertices, which multiply the main color
 * @param glow   colors of glow maps, which multiply the glow
 */
public record TexelColumns(boolean colors, boolean glow) {
    public static final TexelColumns NONE = new TexelColumns(false, false);
    public static final TexelColumns COLORS = new TexelColumns(true, false);
    private static final TexelColumns GLOW = new TexelColumns(false, true);
    private static final TexelColumns BOTH = new TexelColumns(true, true);

    private static TexelColumns of(boolean colors, boolean glow) {
        return glow ? colors ? BOTH : GLOW : colors ? COLORS : NONE;
    }

    /** Returns what rows of material {@code m} have. */
    static TexelColumns of(MaterialTable materials, int m) {
        return of(materials.isTextured(m), materials.glowMap(m) != null);
    }

    /** Returns what the runs of some rows have. */
    static TexelColumns of(MaterialTable materials, HitRows rows) {
        TexelColumns found = NONE;
        for (int r = 0; r < rows.runCount; r++) {
            found = found.or(of(materials, rows.runMaterial[r]));
        }
        return found;
    }

    /** Returns what rows of any material may have, besides the colors that each of them may have. */
    public static TexelColumns ofAny(MaterialTable materials) {
        return of(true, materials.hasGlowMaps());
    }

    /** Returns what either has. */
    public TexelColumns or(TexelColumns o) {
        return of(colors || o.colors, glow || o.glow);
    }

    /** Returns what both have. */
    TexelColumns and(TexelColumns o) {
        return of(colors && o.colors, glow && o.glow);
    }

    /** Returns the bytes of a row. */
    public int bytesPerRow() {
        return (colors ? HitRows.ColumnGroup.TEXEL.bytesPerRow() : 0) + (glow ? HitRows.ColumnGroup.GLOW_TEXEL.bytesPerRow() : 0);
    }

    /** Returns whether rows have neither. */
    public boolean isNone() {
        return !colors && !glow;
    }
}
