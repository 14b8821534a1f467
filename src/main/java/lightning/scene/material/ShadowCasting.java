package lightning.scene.material;

/** Shadows cast by shapes with a material. */
public enum ShadowCasting {
    /** Opaque shadows, even if the material is transparent. */
    FULL,
    /** Shadows tinted by the transmitted color; opaque if the material is. */
    TINTED,
    /** No shadows. */
    NONE,
    /** Opaque shadows of lights alone: no ray of the camera, of mirrors or of indirect light meets the shape. */
    ONLY
}
