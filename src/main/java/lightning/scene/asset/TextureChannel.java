package lightning.scene.asset;

/** Channel of an image whose values a map reads. */
public enum TextureChannel {
    RED,
    GREEN,
    BLUE
}
