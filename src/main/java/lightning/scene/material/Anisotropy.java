package lightning.scene.material;

import io.soabase.recordbuilder.core.RecordBuilder;

/**
 * Direction in which a principled surface is rougher than across it, as brushed metal is: it stretches highlights and reflections.
 *
 * <p>The widths follow B. Burley, Physically-based shading at Disney, 2012: α/aspect along the tangent and α·aspect across it, with aspect² = 1 −
 * 0.9·strength. So their mean is the α of the roughness.
 *
 * @param strength 0 for a surface that is equally rough in all directions, 1 for one that is ten times as rough along the tangent
 * @param rotation of the direction from the tangent, degrees, counterclockwise as seen by the viewer
 */
@RecordBuilder
public record Anisotropy(double strength, double rotation) implements AnisotropyBuilder.With {
    /** None. */
    public static final Anisotropy NONE = new Anisotropy(0, 0);

    private static final double STRETCH = 0.9;

    private double aspect() {
        return Math.sqrt(ratio(strength));
    }

    /** Returns the width along the direction, at most 1. @param alpha α of the roughness */
    public double along(double alpha) {
        return Math.min(1, alpha / aspect());
    }

    /** Returns the width across the direction, at least that of the smallest roughness. @param alpha α of the roughness */
    public double across(double alpha) {
        return Math.max(Material.alpha(0), alpha * aspect());
    }

    /** Returns the width across the direction divided by that along it. @param strength 0 … 1 */
    public static double ratio(double strength) {
        return 1 - STRETCH * strength;
    }

    /**
     * Returns the strength of a surface with a ratio of its widths.
     *
     * @param ratio width across the direction divided by that along it, 0…1; a smaller one than this model has counts as its smallest
     */
    public static double strength(double ratio) {
        return Math.clamp((1 - ratio) / STRETCH, 0, 1);
    }
}
