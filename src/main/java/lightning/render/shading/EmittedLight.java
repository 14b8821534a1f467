package lightning.render.shading;

import java.util.Optional;
import lightning.render.trace.HitRows.ColumnGroup;
import lightning.render.trace.TexelColumns;

/** Kinds of light that a surface sends even if no light reaches it. An image of the material may multiply each. */
public enum EmittedLight {
    /** Light of the scene's ambience. */
    AMBIENT,
    /** Glow of the material and of its bulb. */
    GLOW(ColumnGroup.GLOW_TEXEL);

    private static final EmittedLight[] KINDS = values();

    private final Optional<ColumnGroup> map;

    EmittedLight() {
        map = Optional.empty();
    }

    EmittedLight(ColumnGroup map) {
        this.map = Optional.of(map);
    }

    /** Returns the columns with the colors of its image; empty if no image can multiply it. */
    public Optional<ColumnGroup> map() {
        return map;
    }

    /** Returns whether an image multiplies it on rows with some texels. */
    public boolean isMapped(TexelColumns texels) {
        return map.isPresent() && texels.has(map.get());
    }

    /**
     * Returns one channel of this light before its image.
     *
     * @param ka       k<sub>ambient</sub>
     * @param ambience ambience of the scene
     * @param glow     glow of the material and of its bulb
     */
    public float amount(float ka, float ambience, float glow) {
        return switch (this) {
            case AMBIENT -> ka * ambience;
            case GLOW -> glow;
        };
    }

    /**
     * Returns one channel of all light that no image multiplies. An absent kind changes no bit of the sum, which is at least +0.
     *
     * @param texels images of the material
     */
    public static float unmapped(TexelColumns texels, float ka, float ambience, float glow) {
        float sum = 0;
        for (EmittedLight kind : KINDS) {
            sum += kind.isMapped(texels) ? 0 : kind.amount(ka, ambience, glow);
        }
        return sum;
    }
}
