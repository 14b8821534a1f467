package lightning.format.jen;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Optional;
import lightning.base.file.AtomicFile;
import lightning.base.file.FileState;
import lightning.scene.Scene;
import lightning.scene.shot.AnimatedScene;
import lightning.scene.shot.Shot;
import lightning.scene.shot.TrackRetargeting;

/** A scene together with the text that says it. Immutable. */
public final class JenDocument {
    private final Scene scene;
    private final Optional<Shot> shot;
    private final String text;

    JenDocument(Scene scene, Optional<Shot> shot, String text) {
        this.scene = scene;
        this.shot = shot;
        this.text = text;
    }

    /** A document with a text written from scratch. */
    public static JenDocument of(Scene scene) {
        return new JenDocument(scene, Optional.empty(), JenWriter.write(scene));
    }

    public Scene scene() {
        return scene;
    }

    /** Keys over frames, where the file says any. */
    public Optional<Shot> shot() {
        return shot;
    }

    /** The scene with its shot. */
    public AnimatedScene animatedScene() {
        return new AnimatedScene(scene, shot);
    }

    /** The file's content: reading it gives {@link #scene()} and {@link #shot()} again, in every bit. */
    public String text() {
        return text;
    }

    /**
     * The same document after an edit of its scene: in the text only what was edited changes.
     * Comments, order, spaces and all numbers that are the same keep their characters. Values that
     * were not written are added where they are no longer the default; new blocks come last, or
     * before the block that they precede in the scene; blocks that are gone are cut out.
     * Keys follow what is renamed, and go with what is gone.
     *
     * @throws IllegalArgumentException if {@code edited} names a texture file that a scene file
     *     cannot name
     */
    public JenDocument withScene(Scene edited) {
        if (edited.equals(scene)) {
            return this;
        }
        Optional<Shot> updatedShot = shot.map(s -> new TrackRetargeting(scene, edited).retarget(s));
        return new JenDocument(edited, updatedShot, DocumentPatch.apply(text, scene, edited));
    }

    /** The same of a scene with its shot. */
    public JenDocument withAnimatedScene(AnimatedScene edited) {
        JenDocument document = withScene(edited.base());
        return edited.shot().map(document::withShot).orElseGet(document::withoutShot);
    }

    /** The same scene without its shot, whose block is cut out. */
    public JenDocument withoutShot() {
        return shot.isEmpty() ? this : new JenDocument(scene, Optional.empty(), DocumentPatch.removeShot(text));
    }

    /**
     * The same scene with another shot. The block of the shot is written anew; all else keeps its characters.
     *
     * @throws IllegalArgumentException if it is a shot of another scene ({@link Shot#check})
     */
    public JenDocument withShot(Shot newShot) {
        if (shot.filter(newShot::equals).isPresent()) {
            return this;
        }
        newShot.check(scene);
        return new JenDocument(scene, Optional.of(newShot), DocumentPatch.applyShot(text, scene, newShot));
    }

    /**
     * Writes the text to a file, at once or not at all.
     *
     * @throws IOException if it cannot be written; the old file is then unchanged
     */
    public void save(Path file) throws IOException {
        save(AtomicFile.of(file));
    }

    /**
     * The same with what else is asked of the file; returns what it holds then.
     *
     * @throws IOException as {@link AtomicFile#write(byte[])}
     */
    public FileState save(AtomicFile file) throws IOException {
        return file.write(text.getBytes(StandardCharsets.UTF_8));
    }
}
