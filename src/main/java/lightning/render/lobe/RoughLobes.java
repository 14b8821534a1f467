package lightning.render.lobe;

import lightning.scene.material.Coat;
import lightning.scene.material.Material;
import org.jspecify.annotations.Nullable;

/**
 * Lobes by which a principled material blurs its surroundings. Smooth ones reflect a mirrored ray and are not among them.
 *
 * @param alpha     width α of the surface below the coat, with the mean of its map; 0 if it is smooth
 * @param coatAlpha width α of the coat; 0 if it is smooth or there is none
 * @param coat      coat, smooth or not; null for none
 */
public record RoughLobes(double alpha, double coatAlpha, @Nullable Coat coat) {

    /** Returns the lobes of a material; null if it reflects nothing or sharply. */
    public static @Nullable RoughLobes of(Material m) {
        return !m.reflectsRoughly() ? null
                : new RoughLobes(m.isSmooth() ? 0 : Material.alpha(m.meanRoughness()),
                        m.coat().isVisible() && !m.hasSmoothCoat() ? m.coat().alpha() : 0,
                        m.coat().isVisible() ? m.coat() : null);
    }

    /** Returns whether both the surface and its coat blur. */
    public boolean areTwo() {
        return alpha > 0 && coatAlpha > 0;
    }

    /** Returns the width α of the narrower lobe. */
    public double narrowest() {
        return alpha == 0 ? coatAlpha : coatAlpha == 0 ? alpha : Math.min(alpha, coatAlpha);
    }

    /** Returns whether a ray belongs to the coat: every second one if there are two lobes. */
    public boolean isOfCoat(int ray) {
        return areTwo() ? (ray & 1) == 1 : alpha == 0;
    }
}
