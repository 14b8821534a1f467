package lightning.scene;

/** By which equation a surface answers light. */
public enum ShadingModel {
    /** Lambert and Phong, as the paper has them (§2.2). */
    PHONG,
    /** Lambert and GGX, as glTF 2.0 has materials: a base color, how metallic, how rough. */
    METALLIC
}
