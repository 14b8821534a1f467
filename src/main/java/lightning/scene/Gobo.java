package lightning.scene;

/**
 * A picture that a spot light projects: what is white lets the light through, what is black holds it back.
 *
 * @param file  the name as written in the scene file
 * @param image the decoded picture
 */
public record Gobo(String file, Texture image) implements FileAsset {
    @Override
    public Object content() {
        return image;
    }
}
