package lightning.scene.material;

/** Shadows cast by shapes with a material. */
public enum ShadowCasting {
    /** Opaque shadows, even if the material is transparent. */
    FULL,
    /** Shadows tinted by the transmitted color; opaque if the material is. */
    TINTED,
    /** No shadows. */
    NONE
}
