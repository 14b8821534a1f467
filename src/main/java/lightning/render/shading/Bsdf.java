package lightning.render.shading;

import lightning.render.trace.PrincipledColors;
import lightning.render.trace.SurfacePoint;
import lightning.scene.material.Coat;
import lightning.scene.material.Material;
import lightning.scene.material.Transmission;
import org.jspecify.annotations.Nullable;

/**
 * Scattering function of a material, by its shading model. Its {@link #terms} are the scalar form of the lobes: {@link TermKernel} evaluates them
 * for columns of rows, with the same bits. {@link SurfaceFactors} has what the terms are multiplied by.
 */
public sealed interface Bsdf {
    /** Returns the terms of a light at a point that faces it. @param cosine N·L */
    Terms terms(LightingEquation light, SurfacePoint at, float cosine, HighlightFactor factor);

    /**
     * Terms of one light at one point, without its weight and falloff.
     *
     * @param diffuse  term of Idiff
     * @param specular term of Ispec
     * @param grazing  term of Igraz; 0 without one
     */
    record Terms(float diffuse, float specular, float grazing) {}

    /** Returns the scattering function of a material. A clear principled one is shaded as a metallic material. */
    static Bsdf of(Material m) {
        Bsdf surface = switch (m.model()) {
            case PHONG -> new Phong(m.shininess());
            case METALLIC -> new Metal(m.alpha());
            case PRINCIPLED -> m.isClear() ? new Metal(m.alpha()) : Principled.of(m);
        };
        return m.isClear() ? new Clear(surface, m.transmission(), new InteriorTint(m.transmission()),
                SurfaceFactors.bodyShare(m.transmission())) : surface;
    }

    /** Returns the scattering function without light that passes. */
    default Bsdf surface() {
        return this;
    }

    /** Returns whether it has highlights of microfacets, whose grazing terms no color multiplies. */
    default boolean hasFacets() {
        return !(surface() instanceof Phong);
    }

    /** Returns whether its diffuse term is less than the cosine. */
    default boolean losesDiffuse() {
        return surface() instanceof Metal;
    }

    /** Model of the paper (§2.2): diffuse light and a highlight around the mirrored ray. */
    record Phong(double shininess) implements Bsdf {
        @Override
        public Terms terms(LightingEquation light, SurfacePoint at, float cosine, HighlightFactor factor) {
            return new Terms(cosine, light.specular(at.nx(), at.ny(), at.nz(), at.vx(), at.vy(), at.vz(), shininess), 0);
        }
    }

    /**
     * Metallic and roughness of glTF 2.0 without gathered reflections.
     *
     * @param alpha width of its highlights
     */
    record Metal(double alpha) implements Bsdf {
        @Override
        public Terms terms(LightingEquation light, SurfacePoint at, float cosine, HighlightFactor factor) {
            double facets = light.facets(at.nx(), at.ny(), at.nz(), at.vx(), at.vy(), at.vz(), alpha);
            double schlick = light.schlick(at.vx(), at.vy(), at.vz());
            return new Terms(light.metallicDiffuse(at.nx(), at.ny(), at.nz(), at.vx(), at.vy(), at.vz()),
                    factor.surface((float) (facets * (1 - schlick)), alpha), factor.surface((float) (facets * schlick), alpha));
        }
    }

    /**
     * Opaque or frosted principled material.
     *
     * @param material            the material
     * @param isSmooth            whether its surface reflects a mirrored ray
     * @param highlight           highlights below the coat; null if they are isotropic
     * @param coat                coat; null for none
     * @param isCoatSmooth        whether the coat reflects a mirrored ray
     * @param hasRoughnessMap     whether its rows differ in roughness
     * @param hasCoatRoughnessMap whether its rows differ in the roughness of their coat
     * @param hasCoatNormals      whether its coat has other normals than the surface
     * @param hasColorMap         whether its rows differ in metalness, or in the reflectance of a nonmetal
     * @param colors              its colors at any metalness
     * @param sheen               fibers; null for none
     * @param passing             color of the light that passes a frosted one: red, green, blue; null for others
     */
    record Principled(Material material, boolean isSmooth, @Nullable AnisotropicHighlight highlight, @Nullable Coat coat,
            boolean isCoatSmooth, boolean hasRoughnessMap, boolean hasCoatRoughnessMap, boolean hasCoatNormals, boolean hasColorMap,
            PrincipledColors colors, @Nullable SheenLayer sheen, float @Nullable [] passing) implements Bsdf {

        private static Principled of(Material m) {
            return new Principled(m, m.isSmooth(), AnisotropicHighlight.of(m),
                    m.coat().isVisible() ? m.coat() : null, m.hasSmoothCoat(), m.surfaceMaps().roughness().isPresent(),
                    m.layerMaps().coatRoughness().isPresent(), m.hasCoatNormals(),
                    m.surfaceMaps().changeColors(), new PrincipledColors(m), SheenLayer.of(m),
                    m.isFrosted() ? LightWeight.channels(m.transmission().color()) : null);
        }

        @Override
        public Terms terms(LightingEquation light, SurfacePoint at, float cosine, HighlightFactor factor) {
            double alpha = Material.alpha(at.roughness());
            double facets = highlight == null ? light.facets(at.nx(), at.ny(), at.nz(), at.vx(), at.vy(), at.vz(), alpha)
                    : light.anisotropicFacets(at.nx(), at.ny(), at.nz(), at.vx(), at.vy(), at.vz(), at.tangent(), highlight, alpha);
            double schlick = light.schlick(at.vx(), at.vy(), at.vz());
            float specular = factor.surface((float) (facets * (1 - schlick)), alpha);
            float grazing = factor.surface((float) (facets * schlick), alpha);
            if (coat != null) {
                var weights = new PrincipledWeights();
                weights.moveTo(this, at);
                Terms over = coatTerms(light, at, factor);
                specular *= weights.base();
                grazing = weights.coatedGrazing(this, grazing, over.specular, over.grazing);
            }
            return sheen == null ? new Terms(cosine, specular, grazing)
                    : new Terms(cosine, sheen.below(specular, grazing), light.sheen(at.nx(), at.ny(), at.nz(), at.vx(), at.vy(), at.vz(),
                            at.mapped(material).sheenRoughness()));
        }

        private Terms coatTerms(LightingEquation light, SurfacePoint at, HighlightFactor factor) {
            double alpha = Material.alpha(at.mapped(material).coatRoughness());
            float[] n = at.coatNormal();
            boolean isLit = light.cosine(n[0], n[1], n[2]) > 0;
            return new Terms(0, factor.coat(isLit ? light.metallicSpecular(n[0], n[1], n[2], at.vx(), at.vy(), at.vz(), alpha) : 0, alpha),
                    factor.coat(isLit ? light.metallicGrazing(n[0], n[1], n[2], at.vx(), at.vy(), at.vz(), alpha) : 0, alpha));
        }

        /** Returns whether light passes it. */
        public boolean isFrosted() {
            return passing != null;
        }

        /** Returns whether it needs the color of a mirrored ray. */
        public boolean isMirror() {
            return isSmooth || isCoatSmooth;
        }
    }

    /**
     * Surface that shows sharply what is behind it.
     *
     * @param surface  how it scatters light that does not pass
     * @param interior tint along paths inside
     * @param body     {@link SurfaceFactors#bodyShare}
     */
    record Clear(Bsdf surface, Transmission transmission, InteriorTint interior, float body) implements Bsdf {
        @Override
        public Terms terms(LightingEquation light, SurfacePoint at, float cosine, HighlightFactor factor) {
            return surface.terms(light, at, cosine, factor);
        }
    }
}
