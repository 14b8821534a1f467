package lightning.format.jen;

import lightning.scene.EnvironmentMap;
import lightning.scene.Mesh;
import lightning.scene.Photometry;
import lightning.scene.Texture;
import lightning.scene.TextureUsage;

/** What the files hold that a scene names. */
interface AssetSource {
    /**
     * @param samples what its samples stand for
     * @throws IllegalArgumentException if there is no such picture; the message says why
     */
    Texture texture(String file, TextureUsage samples);

    /** @throws IllegalArgumentException if there is no such profile; the message says why */
    Photometry profile(String file);

    /** @throws IllegalArgumentException if there is no such environment; the message says why */
    EnvironmentMap environment(String file);

    /**
     * @param part the name of a part of the file; empty for all that it holds
     * @throws IllegalArgumentException if there is no such mesh; the message says why
     */
    Mesh mesh(String file, String part);
}
