package lightning.scene;

import io.soabase.recordbuilder.core.RecordBuilder;
import java.util.Optional;
import lightning.base.math.Rgb;

/**
 * How a surface answers light. All colors are linear; {@link MaterialAttribute} tells the ranges, and which attributes act by
 * which model: those of the other model have their initial values, whatever was said.
 *
 * @param name       unique among the materials
 * @param ambient    k<sub>ambient</sub>, also what the surface emits
 * @param model      by which equation
 * @param diffuse    of Phong: k<sub>diffuse</sub>, multiplied by the texture where there is one
 * @param specular   of Phong: k<sub>specular</sub>
 * @param shininess  of Phong: the exponent of the highlight
 * @param base       metallic: what scatters, and what a metal mirrors, each multiplied by the texture where there is one
 * @param metalness  metallic: 0 where it is no metal, 1 where it is one
 * @param roughness  metallic: 0 is smooth; its square is the width α of the highlight
 * @param f0         metallic: which part of the light the surface mirrors head-on where it is no metal
 * @param reflective k<sub>reflect</sub> per channel
 * @param texture    the picture on the surface
 * @param bumpMapping     what its normals are bent by
 * @param transmission    what passes through it
 * @param cutout     which points of it are not there
 */
@RecordBuilder
public record Material(String name, Rgb ambient, ShadingModel model, Rgb diffuse, Rgb specular, double shininess, Rgb base,
        double metalness, double roughness, double f0, Rgb reflective, Optional<TextureMap> texture,
        BumpMapping bumpMapping, Transmission transmission, AlphaCutout cutout) implements MaterialBuilder.With {

    /**
     * Less rough is no surface here: what smaller ones show of a light that is a point is less than a pixel mostly, and digits fail
     * (Guy and Agopian, Physically Based Rendering in Filament, §4.8.3.3, names this value).
     */
    public static final double MIN_ROUGHNESS = 0.045;

    /** What a shape without a material gets: plain gray. */
    public static final Material DEFAULT = of("default");

    public Material {
        SceneLimits.checkName(name);
        MaterialAttribute.AMBIENT.check(ambient);
        diffuse = MaterialAttribute.DIFFUSE.checkFor(model, diffuse);
        specular = MaterialAttribute.SPECULAR.checkFor(model, specular);
        shininess = MaterialAttribute.SHININESS.checkFor(model, shininess);
        base = MaterialAttribute.BASE.checkFor(model, base);
        metalness = MaterialAttribute.METALNESS.checkFor(model, metalness);
        roughness = MaterialAttribute.ROUGHNESS.checkFor(model, roughness);
        f0 = MaterialAttribute.F0.checkFor(model, f0);
        MaterialAttribute.REFLECTIVE.check(reflective);
    }

    /** A material of which nothing else was said. */
    public static Material of(String name) {
        return new Material(name, MaterialAttribute.AMBIENT.initial(), MaterialAttribute.MODEL.initial(),
                MaterialAttribute.DIFFUSE.initial(), MaterialAttribute.SPECULAR.initial(), MaterialAttribute.SHININESS.initial(),
                MaterialAttribute.BASE.initial(), MaterialAttribute.METALNESS.initial(), MaterialAttribute.ROUGHNESS.initial(),
                MaterialAttribute.F0.initial(), MaterialAttribute.REFLECTIVE.initial(), MaterialAttribute.TEXTURE.initial(),
                BumpMapping.NONE, Transmission.NONE, AlphaCutout.NONE);
    }

    /** Whether it is of the model {@link ShadingModel#METALLIC}. */
    public boolean isMetallic() {
        return model == ShadingModel.METALLIC;
    }

    /** The width α of the highlights of a metallic material: the square of its roughness. */
    public double alpha() {
        double clamped = Math.max(roughness, MIN_ROUGHNESS);
        return clamped * clamped;
    }

    /**
     * What no term of a light of weight 1 is above on it: 1, or for metallic ones 1/(2α³) and a rounding
     * (shading.LightingEquation tells why).
     */
    public double maxTerm() {
        double alpha = alpha();
        return isMetallic() ? Math.max(1, (1 + 0x1p-20) / (2 * alpha * alpha * alpha)) : 1;
    }

    /** The color that it has at first sight: what its texture multiplies. */
    public Rgb albedo() {
        return switch (model) {
            case PHONG -> diffuse;
            case METALLIC -> base;
        };
    }

    /** The same with another such color. */
    public Material withAlbedo(Rgb v) {
        return switch (model) {
            case PHONG -> withDiffuse(v);
            case METALLIC -> withBase(v);
        };
    }

    /** The same by another model: its color is kept, all else of the model is as if nothing was said. */
    @Override
    public Material withModel(ShadingModel v) {
        return v == model ? this : with(m -> m.model(v).diffuse(base).base(diffuse));
    }

    /** Whether surfaces of it have the same holes, bend normals, lead rays on and throw shadows as those of another material do. */
    public boolean hasSameRays(Material o) {
        return bumpMapping.hasSameNormals(o.bumpMapping) && transmission.refractsLike(o.transmission)
                && transmission.shadows() == o.transmission.shadows()
                && hasSameShadowTint(o)
                && cutout.hasSameHoles(o.cutout);
    }

    /** Whether light on its way to a point passes surfaces of it as it passes those of another. */
    public boolean hasSameShadowTint(Material o) {
        return this == o || transmission.tintsShadows() == o.transmission.tintsShadows()
                && (!transmission.tintsShadows() || transmission.equals(o.transmission) && reflective.equals(o.reflective));
    }

    /** Whether it mirrors by its own color; a clear material mirrors by its angle too. */
    public boolean isMirror() {
        return (float) reflective.max() > 0;
    }

    /** Whether rays that meet it are followed further: it mirrors, or something is seen through it. */
    public boolean spawnsSecondaryRays() {
        return isMirror() || transmission.isTransparent();
    }
}
