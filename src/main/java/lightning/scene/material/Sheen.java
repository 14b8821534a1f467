package lightning.scene.material;

import io.soabase.recordbuilder.core.RecordBuilder;
import lightning.base.math.Rgb;

/**
 * Fibers over a principled material, as velvet and dust have: they send light back near the outline, and the surface below receives the rest.
 *
 * @param color     share of the light that they scatter, 0…1 per channel; black for none
 * @param roughness 0 for fibers that stand upright, 1 for fibers in all directions
 */
@RecordBuilder
public record Sheen(Rgb color, double roughness) implements SheenBuilder.With {
    /** No sheen. */
    public static final Sheen NONE = new Sheen(Rgb.BLACK, 0.5);

    /** Returns whether it changes a picture. */
    public boolean isVisible() {
        return (float) color.max() > 0;
    }
}
