package lightning.scene;

/** Which shadows the shapes of a material throw. */
public enum ShadowsThrown {
    /** As if the material let no light through. */
    FULL,
    /** None: lights shine through. */
    NONE
}
