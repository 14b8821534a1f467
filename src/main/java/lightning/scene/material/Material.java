package lightning.scene.material;

import io.soabase.recordbuilder.core.RecordBuilder;
import java.util.Optional;
import lightning.base.math.Rgb;
import lightning.scene.asset.TextureMap;
import lightning.scene.value.SceneLimits;
import org.jspecify.annotations.Nullable;

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
 * @param base         metallic and principled, as the next three: diffuse color, and reflection color of a metal, each multiplied by the texture, if any
 * @param metalness    metallic: 0 for a nonmetal, 1 for a metal
 * @param roughness    metallic: 0 is smooth; its square is the width α of the highlight
 * @param f0           metallic: reflectance of a nonmetal at normal incidence
 * @param specularTint principled: color of a nonmetal's reflection at normal incidence
 * @param anisotropy   principled: direction of its roughness below the coat, which a smooth or transparent one ignores
 * @param coat         principled: clear layer over it
 * @param sheen        principled: fibers over it and its coat, which a transparent one ignores
 * @param surfaceMaps  principled: images of the surface below its coat, which a clear one ignores
 * @param layerMaps    principled: images of its coat and sheen, which a clear one ignores
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
        double metalness, double roughness, double f0, Rgb specularTint, Anisotropy anisotropy, Coat coat, Sheen sheen,
        SurfaceMaps surfaceMaps, LayerMaps layerMaps, Rgb reflective,
        Optional<TextureMap> texture,
        BumpMapping bumpMapping, Transmission transmission, AlphaCutout cutout) implements MaterialBuilder.With {

    /**
     * Minimum effective roughness. Highlights of a point light on smoother surfaces are mostly smaller than a pixel and lose precision (Guy
     * and Agopian, Physically Based Rendering in Filament, §4.8.3.3, use this value).
     */
    public static final double MIN_ROUGHNESS = 0.045;

    /** Roughness of a principled material below which it reflects as a mirror does: its blur would be about a degree. */
    public static final double MIRROR_ROUGHNESS = 0.08;

    /** Share of light, and roughness, that make a mirror of a surface seen in blurred reflections. */
    private static final double MIRROR_SHARE = 0.5;
    private static final double SATIN = 0.35;

    /**
     * Smallest reflectance below a sheen, and an upper bound of the ratio by which rows scale what is reflected there: 1 / (0.02·(a + b)), where the
     * albedo a + b is at least 1/4 (ReflectionLobeTest).
     */
    private static final double MIN_F0_UNDER_SHEEN = 0.02;
    private static final double MAX_UNDER_SHEEN = 200;

    /** Upper bound of the sum of a surface's and its coat's terms, several times scattered, in terms of one (shading.PrincipledWeights). */
    private static final double MAX_LAYERS = 8;

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
        specularTint = MaterialAttribute.SPECULAR_TINT.checkFor(model, specularTint);
        anisotropy = new Anisotropy(MaterialAttribute.ANISOTROPY.checkFor(model, anisotropy.strength()),
                MaterialAttribute.ANISOTROPY_ROTATION.checkFor(model, anisotropy.rotation()));
        coat = new Coat(MaterialAttribute.COAT.checkFor(model, coat.weight()),
                MaterialAttribute.COAT_ROUGHNESS.checkFor(model, coat.roughness()),
                MaterialAttribute.COAT_IOR.checkFor(model, coat.ior()));
        sheen = new Sheen(MaterialAttribute.SHEEN.checkFor(model, sheen.color()),
                MaterialAttribute.SHEEN_ROUGHNESS.checkFor(model, sheen.roughness()));
        surfaceMaps = new SurfaceMaps(MaterialAttribute.ROUGHNESS_MAP.checkFor(model, surfaceMaps.roughness()),
                MaterialAttribute.ROUGHNESS_CHANNEL.checkFor(model, surfaceMaps.roughnessChannel()),
                MaterialAttribute.METALNESS_MAP.checkFor(model, surfaceMaps.metalness()),
                MaterialAttribute.METALNESS_CHANNEL.checkFor(model, surfaceMaps.metalnessChannel()),
                MaterialAttribute.F0_MAP.checkFor(model, surfaceMaps.f0()),
                MaterialAttribute.F0_CHANNEL.checkFor(model, surfaceMaps.f0Channel()),
                MaterialAttribute.SPECULAR_TINT_MAP.checkFor(model, surfaceMaps.specularTint()));
        layerMaps = new LayerMaps(MaterialAttribute.COAT_MAP.checkFor(model, layerMaps.coat()),
                MaterialAttribute.COAT_CHANNEL.checkFor(model, layerMaps.coatChannel()),
                MaterialAttribute.COAT_ROUGHNESS_MAP.checkFor(model, layerMaps.coatRoughness()),
                MaterialAttribute.COAT_ROUGHNESS_CHANNEL.checkFor(model, layerMaps.coatRoughnessChannel()),
                MaterialAttribute.COAT_NORMAL_MAP.checkFor(model, layerMaps.coatNormal()),
                MaterialAttribute.COAT_STRENGTH.checkFor(model, layerMaps.coatStrength()),
                MaterialAttribute.SHEEN_MAP.checkFor(model, layerMaps.sheen()),
                MaterialAttribute.SHEEN_ROUGHNESS_MAP.checkFor(model, layerMaps.sheenRoughness()),
                MaterialAttribute.SHEEN_ROUGHNESS_CHANNEL.checkFor(model, layerMaps.sheenRoughnessChannel()));
        reflective = MaterialAttribute.REFLECTIVE.checkFor(model, reflective);
    }

    /** Returns a material with initial values. */
    public static Material of(String name) {
        return new Material(name, MaterialAttribute.AMBIENT.initial(), MaterialAttribute.GLOW.initial(),
                MaterialAttribute.GLOW_MAP.initial(), Bulb.NONE,
                MaterialAttribute.MODEL.initial(), MaterialAttribute.DIFFUSE.initial(), MaterialAttribute.SPECULAR.initial(),
                MaterialAttribute.SHININESS.initial(),
                MaterialAttribute.BASE.initial(), MaterialAttribute.METALNESS.initial(), MaterialAttribute.ROUGHNESS.initial(),
                MaterialAttribute.F0.initial(), MaterialAttribute.SPECULAR_TINT.initial(), Anisotropy.NONE, Coat.NONE, Sheen.NONE,
                SurfaceMaps.NONE, LayerMaps.NONE,
                MaterialAttribute.REFLECTIVE.initial(), MaterialAttribute.TEXTURE.initial(),
                BumpMapping.NONE, Transmission.NONE, AlphaCutout.NONE);
    }

    /** Returns all light that the surface emits itself, before its glow map: its glow and that of its bulb. */
    public Rgb emission() {
        return bulb.glow().isBlack() ? glow : glow.plus(bulb.glow());
    }

    /** Returns whether the images that rows of both look up are the same. */
    public boolean hasSameTextures(Material o) {
        return MaterialAttribute.ALL.stream().filter(attribute -> attribute.term().changesTexels())
                .allMatch(attribute -> attribute.isEquivalent(this, o));
    }

    /** Returns this material without any image; where an image says which parts glow, none does. */
    public Material withoutImages() {
        Material plain = with(m -> m.glow(glowMap.isPresent() ? Rgb.BLACK : glow).bumpMapping(BumpMapping.NONE).cutout(AlphaCutout.NONE));
        for (MaterialAttribute<Optional<TextureMap>> map : MaterialAttribute.MAPS) {
            plain = map.with(plain, Optional.empty());
        }
        return plain;
    }

    /** Returns whether its highlights have metalness and roughness: it is {@link ShadingModel#METALLIC} or {@link ShadingModel#PRINCIPLED}. */
    public boolean isMetallic() {
        return model != ShadingModel.PHONG;
    }

    /**
     * Returns whether it is shaded by the {@link ShadingModel#PRINCIPLED} model. A clear one is shaded as a metallic material.
     */
    public boolean isPrincipled() {
        return model == ShadingModel.PRINCIPLED && !isClear();
    }

    /** Returns whether it is transparent and shows sharply what is behind it. */
    public boolean isClear() {
        return transmission.isTransparent() && !isFrosted();
    }

    /**
     * Returns whether it is transparent and blurs what is behind it, as frosted glass, whatever its roughness map. A surface between equal
     * indices of refraction bends no light.
     */
    public boolean isFrosted() {
        return model == ShadingModel.PRINCIPLED && transmission.isTransparent() && transmission.ior() > 1 && roughness >= MIRROR_ROUGHNESS;
    }

    /** Returns the roughness where its map has a value. */
    public double mappedRoughness(float texel) {
        return Math.clamp(roughness * texel, 0, 1);
    }

    /** Returns the metalness where its map has a value. */
    public double mappedMetalness(float texel) {
        return Math.clamp(metalness * texel, 0, 1);
    }

    /** Returns the reflectance of its nonmetal part at normal incidence, before its tint, where its map has a value. */
    public double mappedF0(float texel) {
        return Math.clamp(f0 * texel, 0, 1);
    }

    /** Returns its coat with the means of its maps. */
    public Coat meanCoat() {
        return layerMaps.mean(coat);
    }

    /** Returns its sheen with the means of its maps. */
    public Sheen meanSheen() {
        return layerMaps.mean(sheen);
    }

    /** Returns the width α of a metallic material's highlights, before a map: the square of its roughness. */
    public double alpha() {
        return alpha(roughness);
    }

    /** Returns the width α of highlights of a roughness. */
    public static double alpha(double roughness) {
        double clamped = Math.max(roughness, MIN_ROUGHNESS);
        return clamped * clamped;
    }

    /** Returns whether it reflects as a mirror does, below its coat: it is principled and smooth, whatever its roughness map. */
    public boolean isSmooth() {
        return isPrincipled() && roughness < MIRROR_ROUGHNESS;
    }

    /** Returns whether its coat reflects as a mirror does. */
    public boolean hasSmoothCoat() {
        return isPrincipled() && coat.isVisible() && coat.roughness() < MIRROR_ROUGHNESS;
    }

    /** Returns whether some of its reflections are blurred. */
    public boolean reflectsRoughly() {
        return isPrincipled() && (!isSmooth() || coat.isVisible() && !hasSmoothCoat() || hasSheen());
    }

    /** Returns whether its highlights and blurred reflections depend on a direction along the surface. */
    public boolean isAnisotropic() {
        return anisotropy.strength() > 0 && isPrincipled() && !isSmooth() && !isFrosted();
    }

    /** Returns whether it shows fibers. */
    public boolean hasSheen() {
        return sheen.isVisible() && isPrincipled() && !isFrosted();
    }

    /**
     * Returns the reflectance at normal incidence of the surface below its sheen, by the means of its color and metalness, which one sum of all
     * that the surface reflects is computed for (shading.PrincipledWeights); 0 without a sheen.
     */
    public double f0UnderSheen() {
        return !hasSheen() ? 0
                : Math.clamp((1 - meanMetalness()) * meanF0() * meanSpecularTint().max() + meanMetalness() * base.max(),
                        MIN_F0_UNDER_SHEEN, 1);
    }

    /**
     * Returns an upper bound of any term of a light of weight 1: 1, or for metallic materials 1/(2α³) plus rounding (see
     * shading.LightingEquation), with the narrower α of an anisotropic one.
     */
    public double maxTerm() {
        double round = surfaceMaps.roughness().isPresent() ? alpha(0) : alpha();
        double base = isAnisotropic() ? anisotropy.across(round) : round;
        double over = layerMaps.coatRoughness().isPresent() ? alpha(0) : coat.alpha();
        double alpha = coat.isVisible() ? Math.min(base, over) : base;
        double coated = (model == ShadingModel.PRINCIPLED ? MAX_LAYERS : 1) * (hasSheen() ? MAX_UNDER_SHEEN : 1);
        return isMetallic() ? coated * Math.max(1, (1 + 0x1p-20) / (2 * alpha * alpha * alpha)) : 1;
    }

    /** Returns its main color, which its texture multiplies. */
    public Rgb albedo() {
        return switch (model) {
            case PHONG -> diffuse;
            case METALLIC, PRINCIPLED -> base;
        };
    }

    /** Returns this material with another main color. */
    public Material withAlbedo(Rgb v) {
        return switch (model) {
            case PHONG -> withDiffuse(v);
            case METALLIC, PRINCIPLED -> withBase(v);
        };
    }

    /** Returns this material with another shading model. Keeps the attributes that both have, and the main color. */
    @Override
    public Material withModel(ShadingModel v) {
        return v == model ? this
                : v == ShadingModel.PHONG || model == ShadingModel.PHONG ? with(m -> m.model(v).diffuse(base).base(diffuse))
                : with(m -> m.model(v));
    }

    /**
     * Returns the normals of its coat; {@link CoatNormals#NONE} if they are those of the surface, or it has none. Bumps of the surface do not
     * change a coat. If both are smooth, mirrored rays follow the surface.
     */
    public CoatNormals coatNormals() {
        if (!isPrincipled() || isFrosted() || !coat.isVisible() || !bumpMapping.bendsNormals() && layerMaps.coatNormal().isEmpty()) {
            return CoatNormals.NONE;
        }
        return new CoatNormals(BumpMapping.NONE.withNormalMap(layerMaps.coatNormal()).withStrength(layerMaps.coatStrength()),
                hasSmoothCoat() && !isSmooth());
    }

    /** Returns whether its coat has other normals than the surface. */
    public boolean hasCoatNormals() {
        return coatNormals() != CoatNormals.NONE;
    }

    /** Returns whether cutouts, normals, secondary rays and shadows are the same for both materials. */
    public boolean hasSameRays(Material o) {
        return isFrosted() == o.isFrosted() && bumpMapping.hasSameNormals(o.bumpMapping) && coatNormals().areSame(o.coatNormals())
                && transmission.refractsLike(o.transmission)
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
        return (float) reflective.max() > 0 || isSmooth() || hasSmoothCoat();
    }

    /**
     * Returns the color of what it mirrors if it reflects most light nearly as a mirror does: a smooth or satin metal, or a reflective surface, with
     * the means of its images; null for others. Blurred reflections of other surfaces show such a surface as a mirror.
     */
    public @Nullable Rgb mirrorTint() {
        if (transmission.isTransparent()) {
            return null;
        }
        if (isPrincipled()) {
            double metal = meanMetalness();
            if (metal < MIRROR_SHARE || meanRoughness() > SATIN) {
                return null;
            }
            Rgb color = texture.map(map -> base.times(map.image().areas().mean())).orElse(base);
            return color.times(metal).plus(meanSpecularTint().times((1 - metal) * meanF0()));
        }
        return reflective.max() < MIRROR_SHARE ? null : reflective;
    }

    /** Returns the metalness with the mean of its map, 0…1. */
    public double meanMetalness() {
        return surfaceMaps.metalness().isPresent() ? mappedMetalness(surfaceMaps.meanMetalness()) : metalness;
    }

    /** Returns the reflectance at normal incidence of its nonmetal part, before its tint, with the mean of its map. */
    public double meanF0() {
        return surfaceMaps.f0().isPresent() ? mappedF0(surfaceMaps.meanF0()) : f0;
    }

    /** Returns the tint of its nonmetal part with the mean of its map. */
    public Rgb meanSpecularTint() {
        return surfaceMaps.specularTint().isPresent() ? specularTint.times(surfaceMaps.meanSpecularTint()) : specularTint;
    }

    /** Returns the roughness with the mean of its map, 0…1. */
    public double meanRoughness() {
        return surfaceMaps.roughness().isPresent() ? mappedRoughness(surfaceMaps.meanRoughness()) : roughness;
    }

    /** Returns whether rays that hit it are traced further: it reflects or is transparent. */
    public boolean spawnsSecondaryRays() {
        return isMirror() || isClear();
    }
}
