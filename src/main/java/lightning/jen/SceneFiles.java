package lightning.jen;

import lightning.mesh.Mesh;
import lightning.scene.Texture;

/** What the files hold that a scene names. */
interface SceneFiles {
    /** @throws IllegalArgumentException if there is no such picture; the message says why */
    Texture texture(String file);

    /**
     * @param part the name of a part of the file; empty for all that it holds
     * @throws IllegalArgumentException if there is no such mesh; the message says why
     */
    Mesh mesh(String file, String part);
}
