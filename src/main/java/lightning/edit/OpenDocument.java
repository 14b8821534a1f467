package lightning.edit;

import java.io.IOException;
import java.nio.file.Path;
import java.util.EnumSet;
import java.util.Optional;
import java.util.Set;
import lightning.file.ChangedFileException;
import lightning.file.FileState;
import lightning.file.ReadOnlyFileException;
import lightning.jen.JenDocument;
import lightning.jen.JenException;
import lightning.jen.JenReader;
import lightning.scene.Light;
import lightning.scene.Scene;
import lightning.text.Quote;

/** The open scene file: what it holds now, what was selected, what can be undone, and what is not saved yet. */
public final class OpenDocument {
    private final History history;
    private Path file;
    private JenDocument saved;
    /** What the file held when it was read or written here; none where it never held what was opened. */
    private FileState known;
    private DiskNews news;
    private boolean keptAgainstNews;
    private Selection selection = Selection.NONE;

    private OpenDocument(Path file, FileState known, JenDocument saved) {
        is(file, known, saved);
        history = new History(saved.scene());
    }

    /**
     * Opens a scene file.
     *
     * @throws IOException  if it cannot be read at all
     * @throws JenException if its content is wrong; holds all problems
     */
    public static OpenDocument open(Path file) throws IOException, JenException {
        // Before it is read: what comes in between then counts as another's change, and is not lost.
        FileState known = FileState.of(file);
        return new OpenDocument(file, known, JenReader.read(file));
    }

    private void is(Path where, FileState what, JenDocument text) {
        file = where;
        known = what;
        saved = text;
        news = new DiskNews(where, what, what, false);
        keptAgainstNews = false;
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
            return new OpenDocument(found.file(), FileState.NONE, edits);
        }
    }

    public Path file() {
        return file;
    }

    /** The file's name without its folder, as a line shows it. */
    public String name() {
        return Quote.path(file.getFileName());
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

    /** The scene as the file holds it. */
    public Scene savedScene() {
        return saved.scene();
    }

    /** What the file holds. */
    JenDocument saved() {
        return saved;
    }

    /** Whether there are edits that the file does not have. */
    public boolean isDirty() {
        return known.equals(FileState.NONE) || news.isGone() || keptAgainstNews || !scene().equals(saved.scene());
    }

    /** What the file held when it was read or written here. */
    public FileState known() {
        return known;
    }

    /** Takes what was seen of the file, unless that is of before it was read or written last. */
    public void hear(DiskNews seen) {
        if (seen.file().equals(file) && seen.known().equals(known)) {
            news = seen;
        }
    }

    /** What was heard last of the file on disk. */
    public DiskNews news() {
        return news;
    }

    /** Stays with what is open here although somebody else wrote the file; saving it asks all the same. */
    public void keepAgainstNews() {
        keptAgainstNews = true;
    }

    /** Whether someone else wrote the file, or took it away, since it was read or saved, as far as was heard. */
    public boolean isChangedOnDisk() {
        return news.isChanged() || news.isGone();
    }

    /** Makes the edit unless it was refused; returns the reason if it was. */
    public Optional<String> apply(Change change) {
        return apply(change, null);
    }

    /** The same as part of a gesture: see {@link History#edit(Scene, Object)}. */
    public Optional<String> apply(Change change, Object gesture) {
        if (change instanceof Change.To to) {
            settleSelection();
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

    /** From the next edit on, the light that stands in for one that is gone is the selected one. */
    void settleSelection() {
        selectedLight().ifPresent(light -> selectLight(light.name()));
    }

    /** Selects the light of that name; nothing if there is none. */
    public void selectLight(String light) {
        selection = Selection.light(history, light);
    }

    /** The selected light as it is now, or its neighbour where it is gone; empty if none is selected or there are no lights. */
    public Optional<Light> selectedLight() {
        return selection.light(history);
    }

    /** Writes the scene to its file: {@link #save(Set)} with nothing allowed. */
    public void save() throws IOException {
        save(Set.of());
    }

    /**
     * Writes the scene to its file. In all failures the file is unchanged and the document still dirty.
     *
     * @throws ChangedFileException  if the file holds what somebody else wrote, unless that may be overwritten
     * @throws ReadOnlyFileException if the file is read-only, unless that may be replaced
     * @throws IOException           if it cannot be written
     */
    public void save(Set<Consent> allowed) throws IOException {
        JenDocument now = document();
        is(file, now.save(Consent.to(file, known, allowed)), now);
    }

    /** Writes the scene to another file: {@link #saveAs(Path, Set)}, with nothing allowed but what a new name allows. */
    public void saveAs(Path target) throws IOException {
        saveAs(target, Set.of());
    }

    /**
     * Writes the scene to another file, which is the document's from now on. To choose its own file is to {@link #save};
     * another that is there is replaced: ask before.
     *
     * @throws ReadOnlyFileException if that file is read-only, unless it may be replaced
     * @throws IOException           if it cannot be written, or could not be read again there because its textures are not
     *                               found from that folder; nothing has changed then
     */
    public void saveAs(Path target, Set<Consent> allowed) throws IOException {
        if (target.toAbsolutePath().equals(file.toAbsolutePath())) {
            save(allowed);
            return;
        }
        JenDocument now = document();
        try {
            JenReader.read(now.text(), target.toString(), target.toAbsolutePath().getParent());
        } catch (JenException e) {
            throw new IOException("the scene cannot be read from there: " + e.problems().getFirst(), e);
        }
        Set<Consent> more = EnumSet.of(Consent.OVERWRITE_CHANGED);
        more.addAll(allowed);
        is(target, now.save(Consent.to(target, FileState.NONE, more)), now);
    }

    /**
     * Starts over with the file as it is on disk (paper §3.4), as one step that can be undone.
     *
     * @throws IOException  if it cannot be read at all; the open scene stays
     * @throws JenException if its content is wrong; the open scene stays
     */
    public void reload() throws IOException, JenException {
        FileState now = FileState.of(file);
        is(file, now, JenReader.read(file));
        history.edit(saved.scene());
    }
}
