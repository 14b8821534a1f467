package lightning.render.shading;

import lightning.render.trace.SurfacePoint;
import lightning.scene.material.Material;

/**
 * Factors by which one point's highlights of some samples of an area light are scaled ({@link FaceHighlight}).
 *
 * @param isActive whether the terms are scaled
 * @param surface  factor of the lobe below the coat
 * @param coat     factor of the lobe of the coat; 1 without a coat
 */
public record HighlightFactor(boolean isActive, float surface, float coat) {
    /** Terms that are not scaled. */
    public static final HighlightFactor NONE = new HighlightFactor(false, 1, 1);

    /**
     * Returns the factors at a point.
     *
     * @param pattern of the point
     * @param s       one of the samples
     */
    public static HighlightFactor of(LightSource light, AreaSamples samples, int pattern, int s, SurfacePoint hit, Material material) {
        if (!FaceHighlight.isShownBy(material) || !FaceHighlight.hasFace(light)) {
            return NONE;
        }
        FaceHighlight face = new FaceHighlight();
        face.aim(light);
        int first = s / samples.samples() * samples.samples();
        return new HighlightFactor(true, factor(face, samples, pattern, first, hit, new float[] {hit.nx(), hit.ny(), hit.nz()},
                Material.alpha(hit.roughness())),
                !material.coat().isVisible() || !material.isPrincipled() ? 1
                        : factor(face, samples, pattern, first, hit, hit.coatNormal(),
                                Material.alpha(hit.mapped(material).coatRoughness())));
    }

    private static float factor(FaceHighlight face, AreaSamples samples, int pattern, int first, SurfacePoint hit, float[] n,
            double alpha) {
        return face.factor(samples, pattern, first, hit.px(), hit.py(), hit.pz(), n[0], n[1], n[2], hit.vx(), hit.vy(),
                hit.vz(),
                alpha);
    }

    /** Returns a term of the lobe below the coat. */
    public float surface(float term, double alpha) {
        return isActive ? FaceHighlight.scaled(term, surface, alpha) : term;
    }

    /** Returns a term of the lobe of the coat. */
    public float coat(float term, double alpha) {
        return isActive ? FaceHighlight.scaled(term, coat, alpha) : term;
    }
}
