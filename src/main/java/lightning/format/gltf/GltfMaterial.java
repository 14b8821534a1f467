package lightning.format.gltf;

import java.util.Optional;
import java.util.OptionalDouble;
import lightning.base.math.Rgb;

/**
 * Material of a glTF file.
 *
 * @param base linear color, multiplied by the base color image
 * @param metallic 0 … 1, multiplied by blue of the metallic-roughness image
 * @param roughness 0 … 1, multiplied by green of the metallic-roughness image
 * @param f0 specular reflectance at normal incidence, for the dielectric part
 * @param f90 specular reflectance at grazing incidence
 * @param specular images of the reflectance
 * @param emission linear, including strength, multiplied by the emission image
 * @param emissionImage emission image, without index if its format is not supported; empty for none
 * @param isUnlit true if it shows its base color regardless of lights
 * @param baseImage base color image
 * @param metallicRoughnessImage metallic-roughness image
 * @param normalImage normal map
 * @param normalScale strength of the normal map
 * @param opacity 0 … 1; below 1 for a veil
 * @param transmission transmission through the surface
 * @param clearcoat clear layer over it
 * @param sheen fibers over it
 * @param anisotropy direction of its roughness
 * @param cutoff threshold for the alpha of base color and image below which the surface is cut out; 0 for none
 * @param alphaFactor alpha of the base color, if it is used for cutouts
 * @param isBlended true if the file blends by alpha instead of cutting out
 */
public record GltfMaterial(String name, Rgb base, double metallic, double roughness, Rgb f0, double f90, Specular specular, Rgb emission,
        Optional<GltfImage> emissionImage, boolean isUnlit, GltfImage baseImage, GltfImage metallicRoughnessImage, GltfImage normalImage,
        double normalScale,
        double opacity, Transmission transmission, Clearcoat clearcoat, Sheen sheen, Anisotropy anisotropy, double cutoff,
        double alphaFactor, boolean isBlended) {
    /** Matte gray material. */
    static final GltfMaterial GRAY =
            new GltfMaterial("", Rgb.gray(0.5), 0, 1, Rgb.gray(0.04), 1, Specular.NONE, Rgb.BLACK, Optional.empty(), false, GltfImage.NONE,
                    GltfImage.NONE, GltfImage.NONE, 1, 1, new Transmission(0, 1.5, true, Rgb.WHITE, Double.POSITIVE_INFINITY),
                    Clearcoat.NONE, Sheen.NONE, Anisotropy.NONE, 0, 1, false);

    /**
     * Transmission through a surface and the volume behind it.
     *
     * @param factor transmitted share of the light that is not reflected, 0 … 1
     * @param ior index of refraction
     * @param isThin true if there is no volume
     * @param tint color of white light after {@code tintDistance}
     * @param tintDistance meters; infinite for no absorption
     */
    public record Transmission(double factor, double ior, boolean isThin, Rgb tint, double tintDistance) {}

    /**
     * Images of KHR_materials_specular.
     *
     * @param level image whose alpha multiplies the reflectance
     * @param keepsGrazing whether that image leaves the reflectance at grazing incidence, as the extras of the extension may say
     * @param color image that multiplies the reflectance at normal incidence
     */
    public record Specular(GltfImage level, boolean keepsGrazing, GltfImage color) {
        static final Specular NONE = new Specular(GltfImage.NONE, true, GltfImage.NONE);
    }

    /**
     * Clear layer (KHR_materials_clearcoat).
     *
     * @param factor share of the surface, 0 … 1, multiplied by red of its image
     * @param image image of the factor
     * @param roughness 0 … 1, multiplied by green of its image
     * @param roughnessImage image of the roughness
     * @param normalImage normal map
     * @param normalScale strength of the normal map
     * @param ior index of refraction; that of the extension, unless its extras have another
     */
    public record Clearcoat(double factor, GltfImage image, double roughness, GltfImage roughnessImage, GltfImage normalImage,
            double normalScale, double ior) {
        static final double DEFAULT_IOR = 1.5;
        static final Clearcoat NONE = new Clearcoat(0, GltfImage.NONE, 0, GltfImage.NONE, GltfImage.NONE, 1, DEFAULT_IOR);
    }

    /**
     * Direction of the roughness (KHR_materials_anisotropy).
     *
     * @param strength 0 … 1
     * @param rotation from the tangent, radians, counterclockwise
     * @param exactStrength strength of a scene's anisotropy, from the extras of the extension; empty for other files
     */
    public record Anisotropy(double strength, double rotation, OptionalDouble exactStrength) {
        static final Anisotropy NONE = new Anisotropy(0, 0, OptionalDouble.empty());
    }

    /**
     * Fibers (KHR_materials_sheen).
     *
     * @param color factor of the color; black for none
     * @param colorImage image that multiplies it
     * @param roughness 0 … 1, the root of the width of the extension's lobe, multiplied by alpha of its image
     * @param roughnessImage image of the roughness
     * @param exactRoughness roughness of a scene's sheen, from the extras of the extension; empty for other files
     */
    public record Sheen(Rgb color, GltfImage colorImage, double roughness, GltfImage roughnessImage, OptionalDouble exactRoughness) {
        static final Sheen NONE = new Sheen(Rgb.BLACK, GltfImage.NONE, 0, GltfImage.NONE, OptionalDouble.empty());
    }
}
