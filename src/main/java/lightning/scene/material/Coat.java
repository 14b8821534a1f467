package lightning.scene.material;

import io.soabase.recordbuilder.core.RecordBuilder;

/**
 * Clear layer over a principled material, as lacquer or car paint has: it reflects white light, and the surface below receives the rest.
 *
 * @param weight    share of the surface that it covers, 0…1
 * @param roughness 0 is smooth; its square is the width α of the highlight
 * @param ior       index of refraction, ≥ 1
 */
@RecordBuilder
public record Coat(double weight, double roughness, double ior) implements CoatBuilder.With {
    /** No coat. */
    public static final Coat NONE = new Coat(0, 0.03, 1.5);

    /** Returns whether it changes a picture. */
    public boolean isVisible() {
        return weight > 0 && ior > 1;
    }

    /** Returns the reflectance at normal incidence, 0…1. */
    public double f0() {
        double ratio = (ior - 1) / (ior + 1);
        return ratio * ratio;
    }

    /** Returns the width α of its highlights. */
    public double alpha() {
        return Material.alpha(roughness);
    }
}
