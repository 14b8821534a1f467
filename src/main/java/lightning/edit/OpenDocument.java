package lightning.edit;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.Optional;
import lightning.jen.JenDocument;
import lightning.jen.JenException;
import lightning.jen.JenReader;
import lightning.scene.Light;
import lightning.scene.Scene;

/** The open scene file: what it holds now, what was selected, what can be undone, and what is not saved yet. */
public final class OpenDocument {
    /** Of a file that does not hold what was opened. */
    private static final FileTime NEVER = FileTime.fromMillis(0);

    private final History history;
    private Path file;
    private JenDocument saved;
    private FileTime savedAt;
    private Selection selection = Selection.NONE;

    private OpenDocument(Path file, FileTime savedAt, JenDocument saved) {
        this.file = file;
        this.savedAt = savedAt;
        this.saved = saved;
        history = new History(saved.scene());
    }

    /**
     * Opens a scene file.
     *
     * @throws IOException  if it cannot be read at all
     * @throws JenException if its content is wrong; holds all problems
     */
    public static OpenDocument open(Path file) throws IOException, JenException {
        FileTime modified = lastModified(file);
        return new OpenDocument(file, modified, JenReader.read(file));
    }

    /**
     * Opens a scene file with the edits that a crash left unsaved, as one step that can be undone. Where the file itself
     * is gone or wrong, the recovered text stands in for it.
     *
     * @throws JenException if the recovered text does not parse, as where its textures are gone
     */
    public static OpenDocument recover(Recovery.Found found) throws JenException {
        JenDocument edits = JenReader.read(found.text(), found.file().toString(), found.file().toAbsolutePath().getParent());
        try {
            OpenDocument document = open(found.file());
            document.history.edit(edits.scene());
            return document;
        } catch (IOException | JenException e) {
            return new OpenDocument(found.file(), NEVER, edits);
        }
    }

    public Path file() {
        return file;
    }

    /** The file's name without its folder. */
    public String name() {
        return file.getFileName().toString();
    }

    public Scene scene() {
        return history.scene();
    }

    public History history() {
        return history;
    }

    /** The scene's text now, with the comments and the order of the file. */
    public JenDocument document() {
        return saved.with(scene());
    }

    /** What the file holds. */
    JenDocument saved() {
        return saved;
    }

    /** Whether there are edits that the file does not have. */
    public boolean isDirty() {
        return savedAt.equals(NEVER) || !scene().equals(saved.scene());
    }

    /** Whether someone else wrote the file, or took it away, since it was read or saved. */
    public boolean isChangedOnDisk() {
        try {
            return !lastModified(file).equals(savedAt);
        } catch (IOException e) {
            return true;
        }
    }

    /** Makes the edit unless it was refused; returns the reason if it was. */
    public Optional<String> apply(Change change) {
        return apply(change, null);
    }

    /** The same as part of a gesture: see {@link History#edit(Scene, Object)}. */
    public Optional<String> apply(Change change, Object gesture) {
        if (change instanceof Change.To to) {
            history.edit(to.scene(), gesture);
        }
        return change.refusal();
    }

    public Selection selection() {
        return selection;
    }

    public void select(Selection v) {
        selection = v;
    }

    /** Selects the light of that name; nothing if there is none. */
    public void selectLight(String light) {
        selection = Selection.light(history, light);
    }

    /** The selected light as it is now; empty if it is gone or none is selected. */
    public Optional<Light> selectedLight() {
        return selection.light(history);
    }

    /**
     * Writes the scene to its file.
     *
     * @throws IOException if it cannot be written; the file is then unchanged and the document still dirty
     */
    public void save() throws IOException {
        JenDocument now = document();
        now.save(file);
        saved = now;
        savedAt = lastModified(file);
    }

    /**
     * Writes the scene to another file, which is the document's from now on.
     *
     * @throws IOException if it cannot be written, or could not be read again there because its textures are not found
     *     from that folder; nothing has changed then
     */
    public void saveAs(Path target) throws IOException {
        JenDocument now = document();
        try {
            JenReader.read(now.text(), target.toString(), target.toAbsolutePath().getParent());
        } catch (JenException e) {
            throw new IOException("the scene cannot be read from there: " + e.problems().getFirst(), e);
        }
        now.save(target);
        file = target;
        saved = now;
        savedAt = lastModified(target);
    }

    /**
     * Starts over with the file as it is on disk (paper §3.4), as one step that can be undone.
     *
     * @throws IOException  if it cannot be read at all; the open scene stays
     * @throws JenException if its content is wrong; the open scene stays
     */
    public void reload() throws IOException, JenException {
        FileTime modified = lastModified(file);
        JenDocument read = JenReader.read(file);
        saved = read;
        savedAt = modified;
        history.edit(read.scene());
    }

    private static FileTime lastModified(Path file) throws IOException {
        return Files.exists(file) ? Files.getLastModifiedTime(file) : NEVER;
    }
}
