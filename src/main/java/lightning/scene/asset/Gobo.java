package lightning.scene.asset;

/**
 * Image projected by a spot, rectangle or disc light: white passes the light, black blocks it.
 *
 * @param file  name as written in the scene file
 * @param image the decoded image
 */
public record Gobo(String file, Texture image) implements FileAsset {
    @Override
    public Texture content() {
        return image;
    }
}
