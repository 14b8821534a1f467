package lightning.format.exchange.assembly;

import lightning.base.math.Rgb;
import lightning.scene.material.Anisotropy;
import lightning.scene.material.Coat;
import lightning.scene.material.Material;
import lightning.scene.material.ShadingModel;
import lightning.scene.material.Sheen;
import lightning.scene.value.SceneLimits;

/** Converter of other programs' reflections to principled materials. */
public record PrincipledImport(SceneAssembler assembler) {
    /** Degrees of two half turns; materials look the same after one. */
    private static final double HALF_TURNS = 360;

    /**
     * Returns a principled material.
     *
     * @param metalness clamped to 0 … 1, like the roughness
     */
    public static Material material(Rgb base, double metalness, double roughness) {
        return Material.of("material").withModel(ShadingModel.PRINCIPLED).withBase(base).withMetalness(SceneAssembler.clamp(metalness, 1))
                .withRoughness(SceneAssembler.clamp(roughness, 1));
    }

    /** Returns the reflectance at normal incidence for an index of refraction, 0 … 1. */
    public static double f0(double ior) {
        double ratio = (ior - 1) / (ior + 1);
        return SceneAssembler.clamp(ratio * ratio, 1);
    }

    /** Sets the reflection color of a nonmetal at normal incidence, clamped to 0 … 1: its largest channel, and the tint of the others. */
    public Material withReflectance(Material material, Rgb color) {
        Rgb f0 = assembler.clampColor(color, 1, "highlights of materials");
        double max = f0.max();
        return max == 0 || f0.min() == max ? material.withF0(max)
                : material.withF0(max).withSpecularTint(new Rgb(rounded(f0.r(), max), rounded(f0.g(), max), rounded(f0.b(), max)));
    }

    private static double rounded(double part, double max) {
        return part == max ? 1 : Math.min(NineDigits.rounded(part / max), 1);
    }

    /**
     * Adds a coat; a clear material has none, which is noted.
     *
     * @param weight    share of the surface, clamped to 0 … 1
     * @param roughness clamped to 0 … 1
     * @param ior       index of refraction, clamped to its range
     */
    public Material withCoat(Material material, double weight, double roughness, double ior) {
        double share = SceneAssembler.clamp(weight, 1);
        if (!(share > 0)) {
            return material;
        }
        if (material.isClear()) {
            assembler.notes.add("coats of clear materials");
            return material;
        }
        return material.withCoat(new Coat(share, SceneAssembler.clamp(roughness, 1), ior >= 1 ? Math.min(ior, SceneLimits.MAX_IOR) : 1));
    }

    /**
     * Adds a sheen; a transparent material has none, which is noted.
     *
     * @param color     clamped to 0 … 1
     * @param roughness of the scene's lobe, clamped to 0 … 1
     */
    public Material withSheen(Material material, Rgb color, double roughness) {
        var sheen = new Sheen(assembler.clampColor(color, 1, "sheen of materials"), SceneAssembler.clamp(roughness, 1));
        if (!sheen.isVisible()) {
            return material;
        }
        if (material.transmission().isTransparent()) {
            assembler.notes.add("sheen of transparent materials");
            return material;
        }
        return material.withSheen(sheen);
    }

    /**
     * Adds an anisotropy with two widths of highlights. Changes the roughness, since its α is the mean of both. A transparent material has none, which is
     * noted.
     *
     * @param along    width along the direction divided by α of the roughness with the mean of its map, above 0
     * @param across   width across the direction divided by that α; a smaller share of {@code along} than materials have counts as the smallest
     * @param rotation from the tangent, degrees, counterclockwise
     */
    public Material withAnisotropy(Material material, double along, double across, double rotation) {
        double strength = NineDigits.rounded(Anisotropy.strength(across / along));
        if (!(strength > 0)) {
            return material;
        }
        if (material.transmission().isTransparent()) {
            assembler.notes.add("anisotropy of transparent materials");
            return material;
        }
        double roughness = NineDigits.rounded(material.roughness() * Math.sqrt(Math.sqrt(along * across)));
        return material.withRoughness(SceneAssembler.clamp(roughness, 1))
                .withAnisotropy(new Anisotropy(strength, NineDigits.rounded(rotation % HALF_TURNS)));
    }

    /**
     * Adds an anisotropy of scenes, which is that of B. Burley (Physically-based shading at Disney, 2012); a transparent material has none, which is
     * noted.
     *
     * @param strength 0 … 1
     * @param rotation as above
     */
    public Material withBurleyAnisotropy(Material material, double strength, double rotation) {
        Material anisotropic = withAnisotropy(material, 1, Anisotropy.ratio(strength), rotation);
        return anisotropic == material ? material
                : material.withAnisotropy(anisotropic.anisotropy().withStrength(NineDigits.rounded(strength)));
    }

    /**
     * Returns the roughness at which a ball with the scene's sheen sends as much white light back as one with the sheen of A. Estevez and C. Kulla
     * (Production friendly microfacet sheen BRDF, 2017), which glTF and MaterialX's standard surface have; ± 0.012.
     *
     * @param roughness root of the width of that lobe, 0 … 1
     */
    public static double sheenRoughness(double roughness) {
        double r = SceneAssembler.clamp(roughness, 1);
        return NineDigits.rounded(0.155 + r * (0.93 - 0.3 * r));
    }
}
