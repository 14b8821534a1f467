package lightning.scene.asset;

/**
 * Environment map of a scene, with its file.
 *
 * @param file name as written in the scene file
 * @param map  the decoded image
 */
public record Environment(String file, EnvironmentMap map) implements FileAsset {
    @Override
    public EnvironmentMap content() {
        return map;
    }
}
