package lightning.format.gltf;

import java.util.OptionalInt;
import lightning.base.math.Rgb;

/**
 * A material of a glTF file.
 *
 * @param base       linear colour, times the picture where there is one
 * @param metallic   0 … 1, times the blue of the picture of surfaces where there is one
 * @param roughness  0 … 1, times its green
 * @param reflection the share of light that it mirrors when seen head on, where it is no metal
 * @param grazing    the same where it is seen from its side
 * @param emission   linear, strength included, times the picture where there is one
 * @param glow       the number of the image of its emission, −1 where it cannot be read; empty for none
 * @param unlit      whether it shows its base colour, whatever light there is
 * @param image      the number of the base colour's image; −1 for none
 * @param surface    the number of the image of metalness and roughness; −1 for none
 * @param normals    the number of the image of its normal map; −1 for none
 * @param lean       a factor on how far these normals lean
 * @param opacity    0 … 1, how much of it is there; less than 1 where it is a veil
 * @param glass      what passes through it
 * @param cutoff     where the alpha of its base colour, times that of the picture, is less, nothing is there; 0 for nowhere
 * @param alpha      that of its base colour, where it cuts
 * @param fades      whether the file lets such a picture fade, instead
 */
public record GltfMaterial(String name, Rgb base, double metallic, double roughness, Rgb reflection, double grazing, Rgb emission,
        OptionalInt glow, boolean unlit, int image, int surface, int normals, double lean, double opacity, Glass glass, double cutoff,
        double alpha, boolean fades) {
    /**
     * What passes through a surface, and through the body behind it.
     *
     * @param share    0 … 1, of the light that is not mirrored
     * @param ior      the index of refraction
     * @param thin     whether there is no body behind it
     * @param tint     what is left of white after {@code distance}
     * @param distance metres; infinite where nothing is lost
     */
    public record Glass(double share, double ior, boolean thin, Rgb tint, double distance) {}
}
