package lightning.scene;

/**
 * A picture of all that is far around a scene.
 *
 * @param file the name as written in the scene file
 * @param sky  what it shows
 */
public record Panorama(String file, Sky sky) implements FromFile {
    @Override
    public Object content() {
        return sky;
    }
}
