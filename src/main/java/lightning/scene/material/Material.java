package lightning.scene.material;

import io.soabase.recordbuilder.core.RecordBuilder;
import java.util.Optional;
import lightning.base.math.Rgb;
import lightning.scene.asset.TextureMap;
import lightning.scene.value.SceneLimits;

/**
 * Material of a surface. All colors are linear. {@link MaterialAttribute} has the ranges and says which attributes belong to which shading
 * model; those of the other model always have their initial values.
 *
 * @param name         unique among the materials
 * @param ambient      k<sub>ambient</sub>, multiplied by the scene's ambience
 * @param glow         light that the surface emits itself, independent of the scene's ambience and lights
 * @param glowMap      image that multiplies its {@link #emission}
 * @param bulb         light that makes it glow too
 * @param model        shading model
 * @param diffuse      Phong: k<sub>diffuse</sub>, multiplied by the texture, if any
 * @param specular     Phong: k<sub>specular</sub>
 * @param shininess    Phong: exponent of the highlight
 * @param base         metallic: diffuse color, and reflection color of a metal, each multiplied by the texture, if any
 * @param metalness    metallic: 0 for a nonmetal, 1 for a metal
 * @param roughness    metallic: 0 is smooth; its square is the width α of the highlight
 * @param f0           metallic: reflectance of a nonmetal at normal incidence
 * @param reflective   k<sub>reflect</sub> per channel
 * @param texture      color texture
 * @param bumpMapping  bump and normal map
 * @param transmission light that passes through it
 * @param cutout       opacity cutout
 */
@RecordBuilder
public record Material(String name, Rgb ambient, Rgb glow, Optional<TextureMap> glowMap, Bulb bulb, ShadingModel model, Rgb diffuse,
        Rgb specular, double shininess,
        Rgb base,
        double metalness, double roughness, double f0, Rgb reflective, Optional<TextureMap> texture,
        BumpMapping bumpMapping, Transmission transmission, AlphaCutout cutout) implements MaterialBuilder.With {

    /**
     * Minimum effective roughness. Highlights of a point light on smoother surfaces are mostly smaller than a pixel and lose precision (Guy
     * and Agopian, Physically Based Rendering in Filament, §4.8.3.3, use this value).
     */
    public static final double MIN_ROUGHNESS = 0.045;

    /** Material of shapes without a material: plain gray. */
    public static final Material DEFAULT = of("default");

    public Material {
        SceneLimits.checkName(name);
        MaterialAttribute.AMBIENT.check(ambient);
        MaterialAttribute.GLOW.check(glow);
        MaterialAttribute.BULB.check(bulb.light());
        MaterialAttribute.BULB_EXPOSURE.check(bulb.exposure());
        diffuse = MaterialAttribute.DIFFUSE.checkFor(model, diffuse);
        specular = MaterialAttribute.SPECULAR.checkFor(model, specular);
        shininess = MaterialAttribute.SHININESS.checkFor(model, shininess);
        base = MaterialAttribute.BASE.checkFor(model, base);
        metalness = MaterialAttribute.METALNESS.checkFor(model, metalness);
        roughness = MaterialAttribute.ROUGHNESS.checkFor(model, roughness);
        f0 = MaterialAttribute.F0.checkFor(model, f0);
        MaterialAttribute.REFLECTIVE.check(reflective);
    }

    /** Returns a material with initial values. */
    public static Material of(String name) {
        return new Material(name, MaterialAttribute.AMBIENT.initial(), MaterialAttribute.GLOW.initial(),
                MaterialAttribute.GLOW_MAP.initial(), Bulb.NONE,
                MaterialAttribute.MODEL.initial(), MaterialAttribute.DIFFUSE.initial(), MaterialAttribute.SPECULAR.initial(),
                MaterialAttribute.SHININESS.initial(),
                MaterialAttribute.BASE.initial(), MaterialAttribute.METALNESS.initial(), MaterialAttribute.ROUGHNESS.initial(),
                MaterialAttribute.F0.initial(), MaterialAttribute.REFLECTIVE.initial(), MaterialAttribute.TEXTURE.initial(),
                BumpMapping.NONE, Transmission.NONE, AlphaCutout.NONE);
    }

    /** Returns all light that the surface emits itself, before its glow map: its glow and that of its bulb. */
    public Rgb emission() {
        return bulb.glow().isBlack() ? glow : glow.plus(bulb.glow());
    }

    /** Returns whether the images that rows of both look up are the same. */
    public boolean hasSameTextures(Material o) {
        return MaterialAttribute.MAPS.stream().filter(map -> map.term() == MaterialTerm.TEXEL)
                .allMatch(map -> map.get(this).equals(map.get(o)));
    }

    /** Returns this material without any image; where an image says which parts glow, none does. */
    public Material withoutImages() {
        Material plain = with(m -> m.glow(glowMap.isPresent() ? Rgb.BLACK : glow).bumpMapping(BumpMapping.NONE).cutout(AlphaCutout.NONE));
        for (MaterialAttribute<Optional<TextureMap>> map : MaterialAttribute.MAPS) {
            plain = map.with(plain, Optional.empty());
        }
        return plain;
    }

    /** Returns whether its shading model is {@link ShadingModel#METALLIC}. */
    public boolean isMetallic() {
        return model == ShadingModel.METALLIC;
    }

    /** Returns the width α of a metallic material's highlights: the square of its roughness. */
    public double alpha() {
        double clamped = Math.max(roughness, MIN_ROUGHNESS);
        return clamped * clamped;
    }

    /**
     * Returns an upper bound of any term of a light of weight 1: 1, or for metallic materials 1/(2α³) plus rounding (see
     * shading.LightingEquation).
     */
    public double maxTerm() {
        double alpha = alpha();
        return isMetallic() ? Math.max(1, (1 + 0x1p-20) / (2 * alpha * alpha * alpha)) : 1;
    }

    /** Returns its main color, which its texture multiplies. */
    public Rgb albedo() {
        return switch (model) {
            case PHONG -> diffuse;
            case METALLIC -> base;
        };
    }

    /** Returns this material with another main color. */
    public Material withAlbedo(Rgb v) {
        return switch (model) {
            case PHONG -> withDiffuse(v);
            case METALLIC -> withBase(v);
        };
    }

    /** Returns this material with another shading model. Keeps the main color and resets all other attributes of the model. */
    @Override
    public Material withModel(ShadingModel v) {
        return v == model ? this : with(m -> m.model(v).diffuse(base).base(diffuse));
    }

    /** Returns whether cutouts, normals, secondary rays and shadows are the same for both materials. */
    public boolean hasSameRays(Material o) {
        return bumpMapping.hasSameNormals(o.bumpMapping) && transmission.refractsLike(o.transmission)
                && transmission.shadows() == o.transmission.shadows()
                && hasSameShadowTint(o)
                && cutout.hasSameHoles(o.cutout);
    }

    /** Returns whether light on its way to a shading point passes both materials in the same way. */
    public boolean hasSameShadowTint(Material o) {
        return this == o || transmission.tintsShadows() == o.transmission.tintsShadows()
                && (!transmission.tintsShadows() || transmission.equals(o.transmission) && reflective.equals(o.reflective));
    }

    /** Returns whether its own color reflects; a transparent material also reflects, depending on the angle. */
    public boolean isMirror() {
        return (float) reflective.max() > 0;
    }

    /** Returns whether rays that hit it are traced further: it reflects or is transparent. */
    public boolean spawnsSecondaryRays() {
        return isMirror() || transmission.isTransparent();
    }
}
