package lightning.render.shading.explanation;

import lightning.render.shading.AnisotropicHighlight;
import lightning.render.shading.HighlightFactor;
import lightning.render.shading.LightingEquation;
import lightning.render.shading.PrincipledMaterial;
import lightning.render.shading.PrincipledWeights;
import lightning.render.shading.SheenLayer;
import lightning.render.trace.MaterialTable;
import lightning.render.trace.SurfacePoint;
import lightning.scene.material.Material;
import org.jspecify.annotations.Nullable;

/**
 * Terms of a light at one point, with the bits of a layer.
 *
 * @param equation of the light, moved to the point
 * @param factor   of its highlights
 */
record SurfaceTerms(LightingEquation equation, SurfacePoint hit, MaterialTable materials, HighlightFactor factor) {
    private boolean isMetallic() {
        return materials.isMetallic(hit.material());
    }

    /** @param cosine of the light */
    float diffuse(float cosine) {
        return isMetallic() && !materials.isPrincipled(hit.material())
                ? equation.metallicDiffuse(hit.nx(), hit.ny(), hit.nz(), hit.vx(), hit.vy(), hit.vz()) : cosine;
    }

    float specular() {
        if (!isMetallic()) {
            return equation.specular(hit.nx(), hit.ny(), hit.nz(), hit.vx(), hit.vy(), hit.vz(), materials.shininess(hit.material()));
        }
        SheenLayer sheen = sheen();
        return sheen == null ? coatedSpecular() : sheen.below(coatedSpecular(), coatedGrazing());
    }

    private float coatedSpecular() {
        double alpha = Material.alpha(hit.roughness());
        float specular = factor.surface(baseSpecular(alpha), alpha);
        PrincipledMaterial coated = coated();
        return coated == null ? specular : specular * weights(coated).base();
    }

    float grazing() {
        if (!isMetallic()) {
            return 0;
        }
        SheenLayer sheen = sheen();
        return sheen == null ? coatedGrazing()
                : equation.sheen(hit.nx(), hit.ny(), hit.nz(), hit.vx(), hit.vy(), hit.vz(),
                        hit.mapped(materials.material(hit.material())).sheenRoughness());
    }

    private float coatedGrazing() {
        double width = Material.alpha(hit.roughness());
        float grazing = factor.surface(baseGrazing(width), width);
        PrincipledMaterial coated = coated();
        if (coated == null) {
            return grazing;
        }
        double alpha = Material.alpha(hit.mapped(coated.material()).coatRoughness());
        float[] n = hit.coatNormal();
        boolean isLit = equation.cosine(n[0], n[1], n[2]) > 0;
        return weights(coated).coatedGrazing(coated, grazing,
                factor.coat(isLit ? equation.metallicSpecular(n[0], n[1], n[2], hit.vx(), hit.vy(), hit.vz(), alpha) : 0, alpha),
                factor.coat(isLit ? equation.metallicGrazing(n[0], n[1], n[2], hit.vx(), hit.vy(), hit.vz(), alpha) : 0, alpha));
    }

    private @Nullable AnisotropicHighlight highlight() {
        PrincipledMaterial material = PrincipledMaterial.of(materials.material(hit.material()));
        return material == null ? null : material.highlight();
    }

    private float baseSpecular(double alpha) {
        AnisotropicHighlight highlight = highlight();
        return highlight == null ? metallicSpecular(alpha)
                : equation.anisotropicSpecular(hit.nx(), hit.ny(), hit.nz(), hit.vx(), hit.vy(), hit.vz(), hit.tangent(), highlight, alpha);
    }

    private float baseGrazing(double alpha) {
        AnisotropicHighlight highlight = highlight();
        return highlight == null ? metallicGrazing(alpha)
                : equation.anisotropicGrazing(hit.nx(), hit.ny(), hit.nz(), hit.vx(), hit.vy(), hit.vz(), hit.tangent(), highlight, alpha);
    }

    private float metallicSpecular(double alpha) {
        return equation.metallicSpecular(hit.nx(), hit.ny(), hit.nz(), hit.vx(), hit.vy(), hit.vz(), alpha);
    }

    private float metallicGrazing(double alpha) {
        return equation.metallicGrazing(hit.nx(), hit.ny(), hit.nz(), hit.vx(), hit.vy(), hit.vz(), alpha);
    }

    private @Nullable SheenLayer sheen() {
        PrincipledMaterial material = PrincipledMaterial.of(materials.material(hit.material()));
        return material == null ? null : material.sheen();
    }

    private @Nullable PrincipledMaterial coated() {
        PrincipledMaterial material = PrincipledMaterial.of(materials.material(hit.material()));
        return material == null || material.coat() == null ? null : material;
    }

    private PrincipledWeights weights(PrincipledMaterial material) {
        var weights = new PrincipledWeights();
        weights.moveTo(material, hit);
        return weights;
    }
}
