package lightning.format.jen;

import lightning.scene.EnvironmentMap;
import lightning.scene.Mesh;
import lightning.scene.Photometry;
import lightning.scene.Texture;
import lightning.scene.TextureUsage;

/** Source of the assets that a scene references. */
interface AssetSource {
    /**
     * Returns a texture.
     *
     * @param samples meaning of the samples
     * @throws IllegalArgumentException if it cannot be used; the message contains the cause
     */
    Texture texture(String file, TextureUsage samples);

    /**
     * Returns a photometric profile.
     *
     * @throws IllegalArgumentException if it cannot be used; the message contains the cause
     */
    Photometry profile(String file);

    /**
     * Returns an environment map.
     *
     * @throws IllegalArgumentException if it cannot be used; the message contains the cause
     */
    EnvironmentMap environment(String file);

    /**
     * Returns a mesh.
     *
     * @param part name of a part of the file; empty for all parts
     * @throws IllegalArgumentException if it cannot be used; the message contains the cause
     */
    Mesh mesh(String file, String part);
}
