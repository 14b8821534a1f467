package lightning.scene;

/** Which shadows the shapes of a material throw. */
public enum ShadowCasting {
    /** As if the material let no light through. */
    FULL,
    /** Of the color of the light that passes; full ones where none does. */
    TINTED,
    /** None: lights shine through. */
    NONE
}
