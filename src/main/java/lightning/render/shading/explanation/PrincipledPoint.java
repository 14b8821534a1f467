package lightning.render.shading.explanation;

import lightning.render.shading.PrincipledMaterial;
import lightning.render.shading.PrincipledWeights;
import lightning.render.trace.SurfacePoint;
import lightning.scene.material.Material;
import org.jspecify.annotations.Nullable;

/**
 * A point of a principled material, with the weights of its terms.
 *
 * @param at       the point
 * @param material its material
 * @param weights  moved to the point
 */
record PrincipledPoint(SurfacePoint at, PrincipledMaterial material, PrincipledWeights weights) {

    /** Returns a point of a material; null if that is not principled. */
    static @Nullable PrincipledPoint of(Material material, SurfacePoint at) {
        PrincipledMaterial principled = PrincipledMaterial.of(material);
        if (principled == null) {
            return null;
        }
        var weights = new PrincipledWeights();
        weights.moveTo(principled, at);
        return new PrincipledPoint(at, principled, weights);
    }

    /**
     * Returns one channel of the color.
     *
     * @param emitted   emitted light
     * @param diffuse   lights' diffuse sum and gathered light
     * @param specular  lights' specular sum
     * @param grazing   lights' grazing sum
     * @param reflected light from the surroundings, as in {@link PointReport}; null for none
     * @param mirrored  color of the mirrored ray
     */
    float color(int c, float emitted, float diffuse, float specular, float grazing, float @Nullable [] reflected, float mirrored) {
        float first = reflected == null ? 0 : reflected[c];
        float second = reflected == null ? 0 : reflected[3 + c];
        return weights.color(material, c, emitted, at.diffuse()[c], diffuse, at.specular()[c],
                material.colors().square(c, at.mapped(material.material()), at.texel()[c]),
                weights.specular(material, specular, first, mirrored), weights.grazing(material, grazing, first, second, mirrored),
                weights.passing(material, c, second));
    }
}
