package lightning.scene;

/**
 * A picture of all that is far around a scene.
 *
 * @param file the name as written in the scene file
 * @param map  what it shows
 */
public record Environment(String file, EnvironmentMap map) implements FileAsset {
    @Override
    public Object content() {
        return map;
    }
}
