package lightning.format.gltf;

import java.util.OptionalInt;
import lightning.base.math.Rgb;

/**
 * A material of a glTF file.
 *
 * @param base       linear color, times the picture where there is one
 * @param metallic   0 … 1, times the blue of the picture of surfaces where there is one
 * @param roughness  0 … 1, times its green
 * @param f0 the share of light that it mirrors when seen head on, where it is no metal
 * @param f90    the same where it is seen from its side
 * @param emission   linear, strength included, times the picture where there is one
 * @param emissionImage       the number of the image of its emission, −1 where it cannot be read; empty for none
 * @param isUnlit      whether it shows its base color, whatever light there is
 * @param baseImage      the number of the base color's image; −1 for none
 * @param metallicRoughnessImage    the number of the image of metalness and roughness; −1 for none
 * @param normalImage    the number of the image of its normal map; −1 for none
 * @param normalScale       a factor on how far these normals lean
 * @param opacity    0 … 1, how much of it is there; less than 1 where it is a veil
 * @param transmission      what passes through it
 * @param cutoff     where the alpha of its base color, times that of the picture, is less, nothing is there; 0 for nowhere
 * @param alphaFactor      that of its base color, where it cuts
 * @param isBlended      whether the file lets such a picture fade, instead
 */
public record GltfMaterial(String name, Rgb base, double metallic, double roughness, Rgb f0, double f90, Rgb emission,
        OptionalInt emissionImage, boolean isUnlit, int baseImage, int metallicRoughnessImage, int normalImage, double normalScale,
        double opacity, Transmission transmission, double cutoff,
        double alphaFactor, boolean isBlended) {
    /**
     * What passes through a surface, and through the body behind it.
     *
     * @param factor    0 … 1, of the light that is not mirrored
     * @param ior      the index of refraction
     * @param isThin     whether there is no body behind it
     * @param tint     what is left of white after {@code tintDistance}
     * @param tintDistance meters; infinite where nothing is lost
     */
    public record Transmission(double factor, double ior, boolean isThin, Rgb tint, double tintDistance) {}
}
