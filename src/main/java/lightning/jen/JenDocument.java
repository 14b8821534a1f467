package lightning.jen;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import lightning.file.FileState;
import lightning.file.SafeFile;
import lightning.scene.Scene;

/** A scene together with the text that says it. Immutable. */
public final class JenDocument {
    private final Scene scene;
    private final String text;

    JenDocument(Scene scene, String text) {
        this.scene = scene;
        this.text = text;
    }

    /** A document with a text written from scratch. */
    public static JenDocument of(Scene scene) {
        return new JenDocument(scene, JenWriter.write(scene));
    }

    public Scene scene() {
        return scene;
    }

    /** The file's content: reading it gives {@link #scene()} again, in every bit. */
    public String text() {
        return text;
    }

    /**
     * The same document after an edit of its scene: in the text only what was edited changes.
     * Comments, order, spaces and all numbers that are the same keep their characters. Values that
     * were not written are added where they are no longer the default; new blocks come last, or
     * before the block that they precede in the scene; blocks that are gone are cut out.
     *
     * @throws IllegalArgumentException if {@code edited} names a texture file that a scene file
     *     cannot name
     */
    public JenDocument with(Scene edited) {
        return edited.equals(scene) ? this : new JenDocument(edited, Patch.apply(text, scene, edited));
    }

    /**
     * Writes the text to a file, at once or not at all.
     *
     * @throws IOException if it cannot be written; the old file is then unchanged
     */
    public void save(Path file) throws IOException {
        save(SafeFile.at(file));
    }

    /**
     * The same with what else is asked of the file; returns what it holds then.
     *
     * @throws IOException as {@link SafeFile#write(byte[])}
     */
    public FileState save(SafeFile file) throws IOException {
        return file.write(text.getBytes(StandardCharsets.UTF_8));
    }
}
