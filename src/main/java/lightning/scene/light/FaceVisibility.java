package lightning.scene.light;

/** Visibility of an area light's surface to rays of the camera, also in mirrors and through glass. */
public enum FaceVisibility {
    /** No ray meets it. */
    HIDDEN,
    /** It glows while the light shines. */
    GLOWING,
    /** It hides what is farther away but is black, as in the image of a light's contribution. */
    BLACK
}
