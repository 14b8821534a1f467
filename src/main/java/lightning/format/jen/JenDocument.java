package lightning.format.jen;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import lightning.base.file.AtomicFile;
import lightning.base.file.FileState;
import lightning.scene.Scene;
import lightning.scene.shot.AnimatedScene;
import lightning.scene.shot.Shot;
import lightning.scene.shot.TrackRetargeting;

/** Scene together with its text. Immutable. */
public final class JenDocument {
    private final Scene scene;
    private final Optional<Shot> shot;
    private final String text;
    private final List<Problem> notes;
    private final Set<LeftOutFile> leftOut;

    JenDocument(Scene scene, Optional<Shot> shot, String text, List<Problem> notes, Set<LeftOutFile> leftOut) {
        this.scene = scene;
        this.shot = shot;
        this.text = text;
        this.notes = List.copyOf(notes);
        this.leftOut = leftOut;
    }

    /** Creates a document with new text. */
    public static JenDocument of(Scene scene) {
        return new JenDocument(scene, Optional.empty(), JenWriter.write(scene), List.of(), Set.of());
    }

    public Scene scene() {
        return scene;
    }

    /** Returns the animation, if the file has a shot. */
    public Optional<Shot> shot() {
        return shot;
    }

    /**
     * Returns what the file names and the scene lacks, in the order of the text it was read from: images, profiles and meshes that cannot be used are
     * left out, those that are too large are reduced. The text still names them.
     */
    public List<Problem> notes() {
        return notes;
    }

    /**
     * Returns this document if the scene has everything that the text names.
     *
     * @throws JenException if there are {@link #notes}; contains them as problems
     */
    public JenDocument requireAllFiles() throws JenException {
        if (!notes.isEmpty()) {
            throw new JenException(notes);
        }
        return this;
    }

    /** Returns the files that the scene lacks, since they cannot be used. */
    Set<LeftOutFile> leftOut() {
        return leftOut;
    }

    /** Returns the scene with its shot. */
    public AnimatedScene animatedScene() {
        return new AnimatedScene(scene, shot);
    }

    /** Returns the file's text; reading it gives {@link #scene()} and {@link #shot()} again, bit-identical. */
    public String text() {
        return text;
    }

    /**
     * Returns the document for an edited scene, with a minimally changed text. Comments, order, spaces and unchanged numbers
     * are preserved. Values that were not written are added if they differ from the default; new blocks come last, or before
     * the block that they precede in the scene; deleted blocks are removed. Keyframes follow renames and deletions.
     *
     * @throws IllegalArgumentException if {@code edited} references a texture by a name that is not valid in a scene file
     */
    public JenDocument withScene(Scene edited) {
        if (edited.equals(scene)) {
            return this;
        }
        Optional<Shot> updatedShot = shot.map(s -> new TrackRetargeting(scene, edited).retarget(s));
        return new JenDocument(edited, updatedShot, DocumentPatch.apply(text, scene, edited, leftOut), notes, leftOut);
    }

    /** Returns the document for an edited scene with its shot; see {@link #withScene}. */
    public JenDocument withAnimatedScene(AnimatedScene edited) {
        JenDocument document = withScene(edited.base());
        return edited.shot().map(document::withShot).orElseGet(document::withoutShot);
    }

    /** Returns the document without its shot block. */
    public JenDocument withoutShot() {
        return shot.isEmpty() ? this : new JenDocument(scene, Optional.empty(), DocumentPatch.removeShot(text), notes, leftOut);
    }

    /**
     * Returns the document with another shot. Only the shot block is rewritten.
     *
     * @throws IllegalArgumentException if the shot does not match the scene ({@link Shot#check})
     */
    public JenDocument withShot(Shot newShot) {
        if (shot.filter(newShot::equals).isPresent()) {
            return this;
        }
        newShot.check(scene);
        return new JenDocument(scene, Optional.of(newShot), DocumentPatch.applyShot(text, scene, newShot), notes, leftOut);
    }

    /**
     * Writes the text to a file, atomically.
     *
     * @throws IOException if it cannot be written; the old file is then unchanged
     */
    public void save(Path file) throws IOException {
        save(AtomicFile.of(file));
    }

    /**
     * Writes the text with the file's own options; returns the new state of the file.
     *
     * @throws IOException as {@link AtomicFile#write(byte[])}
     */
    public FileState save(AtomicFile file) throws IOException {
        return file.write(text.getBytes(StandardCharsets.UTF_8));
    }
}
