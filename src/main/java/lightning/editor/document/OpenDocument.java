package lightning.editor.document;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;
import lightning.base.file.FileState;
import lightning.base.text.Quote;
import lightning.format.jen.JenDocument;
import lightning.format.jen.JenException;
import lightning.format.jen.JenReader;
import lightning.scene.Light;
import lightning.scene.Scene;
import lightning.scene.shot.AnimatedScene;

/** The open scene file: what it holds now, what was selected, what can be undone, and what is not saved yet. */
public final class OpenDocument {
    private final History history;
    /** What the file held when it was read or written here; its state is none where it never held what was opened. */
    private SavedScene saved;
    private DiskNews news;
    private boolean keptAgainstNews;
    private Selection selection = Selection.NONE;
    private int frame;
    /** The scene shown last, and of which frame of what it is; {@code unshown} says why it is no frame's. */
    private Scene shown;
    private AnimatedScene shownOf;
    private int shownAt;
    private String unshown = "";

    private OpenDocument(SavedScene saved) {
        is(saved);
        history = new History(saved.document().content());
        toFirstFrame();
    }

    /**
     * Opens a scene file.
     *
     * @throws IOException  if it cannot be read at all
     * @throws JenException if its content is wrong; holds all problems
     */
    public static OpenDocument open(Path file) throws IOException, JenException {
        return new OpenDocument(SavedScene.read(file));
    }

    private void is(SavedScene now) {
        saved = now;
        news = new DiskNews(now.file(), now.state(), now.state(), false);
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
            document.history.edit(edits.content(), null);
            document.settleFrame();
            return document;
        } catch (IOException | JenException e) {
            return new OpenDocument(new SavedScene(found.file(), FileState.NONE, edits));
        }
    }

    public Path file() {
        return saved.file();
    }

    /** The file's name without its folder, as a line shows it. */
    public String name() {
        return Quote.path(file().getFileName());
    }

    /** The scene as it is at the frame that is shown; where it has no shot, the scene. */
    public Scene scene() {
        AnimatedScene content = history.content();
        if (content != shownOf || frame != shownAt) {
            try {
                show(content, content.at(frame), "");
            } catch (IllegalArgumentException e) {
                show(content, content.still(), e.getMessage());
            }
        }
        return shown;
    }

    private void show(AnimatedScene of, Scene scene, String why) {
        shownOf = of;
        shownAt = frame;
        shown = scene;
        unshown = why;
    }

    /** The scene with its shot. */
    public AnimatedScene content() {
        return history.content();
    }

    /** Why the frame cannot be shown, as where a scale goes through 0: then the scene is, as it is without keys. Empty where it can. */
    public Optional<String> frameProblem() {
        scene();
        return unshown.isEmpty() ? Optional.empty() : Optional.of(unshown);
    }

    /** The frame that is shown; empty where there is no shot. */
    public Optional<Moment> moment() {
        return content().shot().map(shot -> new Moment(shot, frame));
    }

    /** Shows another frame of the shot, or the nearest one that it has. */
    public void showFrame(int v) {
        content().shot().ifPresent(shot -> frame = Math.clamp(v, shot.first(), shot.last()));
    }

    private void toFirstFrame() {
        content().shot().ifPresent(shot -> frame = shot.first());
    }

    public History history() {
        return history;
    }

    /** The text of what the document holds or held, with the comments and the order of the file. On any thread. */
    public String text(AnimatedScene of) {
        return saved.document().with(of).text();
    }

    /** The scene as the file holds it, where nothing has keys. */
    public Scene savedScene() {
        return savedText().scene();
    }

    /** What the file holds. */
    JenDocument savedText() {
        return saved.document();
    }

    /** Whether there are edits that the file does not have. */
    public boolean isDirty() {
        return known().equals(FileState.NONE) || news.isGone() || keptAgainstNews || !content().equals(savedText().content());
    }

    /** What the file held when it was read or written here. */
    public FileState known() {
        return saved.state();
    }

    /** Takes what was seen of the file, unless that is of before it was read or written last. */
    public void hear(DiskNews seen) {
        if (seen.file().equals(file()) && seen.known().equals(known())) {
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
            AnimatedScene edited;
            try {
                edited = edited(to.scene());
            } catch (IllegalArgumentException e) {
                return Optional.of(e.getMessage());
            }
            history.edit(edited, gesture);
            if (unshown.isEmpty() && history.content() == edited) {
                // The same in every bit as what it would be made of anew, and it shares with what was shown before.
                show(edited, to.scene(), "");
            }
        }
        return change.refusal();
    }

    /** What has keys is edited at the frame that is shown, all else at all frames. */
    private AnimatedScene edited(Scene to) {
        Scene before = scene();
        return unshown.isEmpty() ? content().edited(frame, before, to) : content().with(to);
    }

    /** Makes an edit of the scene with its shot; returns the reason if it was refused. As {@link #apply} part of a gesture. */
    public Optional<String> applyToAll(Supplier<AnimatedScene> edit, Object gesture) {
        try {
            AnimatedScene edited = edit.get();
            settleSelection();
            boolean begins = content().shot().isEmpty();
            history.edit(edited, gesture);
            if (begins) {
                toFirstFrame();
            }
            settleFrame();
            return Optional.empty();
        } catch (IllegalArgumentException e) {
            return Optional.of(e.getMessage());
        }
    }

    /** After another step of the history: a frame that the shot lacks gives way to the nearest one. */
    void settleFrame() {
        showFrame(frame);
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
        return selection.light(history).flatMap(light -> scene().light(light.name()));
    }

    /** The scene as it is now, to be written on any thread. */
    SceneWriting writing(Path target, Set<Consent> allowed) {
        return new SceneWriting(saved, content(), target, allowed);
    }

    /** The scene was written. What was edited since is not in the file. */
    void written(SavedScene now) {
        is(now);
    }

    /** The file was read anew: the document starts over with it (paper §3.4), as one step that can be undone. */
    void reloaded(SavedScene now) {
        is(now);
        history.edit(now.document().content(), null);
        settleFrame();
    }
}
