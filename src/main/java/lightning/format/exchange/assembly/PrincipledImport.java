package lightning.format.exchange.assembly;

import lightning.base.math.Rgb;
import lightning.scene.material.Coat;
import lightning.scene.material.Material;
import lightning.scene.material.ShadingModel;
import lightning.scene.material.Sheen;
import lightning.scene.value.SceneLimits;

/** Converter of other programs' reflections to principled materials. */
public final class PrincipledImport {
    private final SceneAssembler assembler;

    public PrincipledImport(SceneAssembler assembler) {
        this.assembler = assembler;
    }

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
