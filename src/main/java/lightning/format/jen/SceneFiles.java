package lightning.format.jen;

import lightning.scene.Mesh;
import lightning.scene.Photometry;
import lightning.scene.SampleMeaning;
import lightning.scene.Sky;
import lightning.scene.Texture;

/** What the files hold that a scene names. */
interface SceneFiles {
    /**
     * @param samples what its samples stand for
     * @throws IllegalArgumentException if there is no such picture; the message says why
     */
    Texture texture(String file, SampleMeaning samples);

    /** @throws IllegalArgumentException if there is no such profile; the message says why */
    Photometry profile(String file);

    /** @throws IllegalArgumentException if there is no such environment; the message says why */
    Sky sky(String file);

    /**
     * @param part the name of a part of the file; empty for all that it holds
     * @throws IllegalArgumentException if there is no such mesh; the message says why
     */
    Mesh mesh(String file, String part);
}
