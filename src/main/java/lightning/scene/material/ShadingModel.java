package lightning.scene.material;

/** Shading model of a material. */
public enum ShadingModel {
    /** Lambert and Phong, as in the paper (§2.2). */
    PHONG,
    /** Lambert and GGX with base color, metalness and roughness, as in glTF 2.0. */
    METALLIC,
    /** Lambert below GGX with the metallic attributes: surfaces reflect their surroundings as sharply as they are smooth. */
    PRINCIPLED
}
