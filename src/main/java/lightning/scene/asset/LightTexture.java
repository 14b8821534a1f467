package lightning.scene.asset;

import lightning.scene.value.SceneLimits;

/**
 * Image on the face of an area light: its colors multiply the light's emission.
 *
 * @param file  name as written in the scene file
 * @param image the decoded image, each value 0 … {@link SceneLimits#MAX_EMISSION}
 */
public record LightTexture(String file, Texture image) implements FileAsset {
    @Override
    public Texture content() {
        return image;
    }
}
