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
    private final EditHistory history;
    /** What the file held when it was read or written here; its state is none where it never held what was opened. */
    private SavedScene saved;
    private DiskStatus diskStatus;
    private boolean ignoresDiskChange;
    private Selection selection = Selection.NONE;
    private int frame;
    /** The scene shown last, and of which frame of what it is; {@code frameProblem} says why it is no frame's. */
    private Scene shownScene;
    private AnimatedScene shownContent;
    private int shownFrame;
    private String frameProblem = "";

    private OpenDocument(SavedScene saved) {
        setSaved(saved);
        history = new EditHistory(saved.document().animatedScene());
        goToFirstFrame();
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

    private void setSaved(SavedScene newSaved) {
        saved = newSaved;
        diskStatus = new DiskStatus(newSaved.file(), newSaved.state(), newSaved.state(), false);
        ignoresDiskChange = false;
    }

    /**
     * Opens a scene file with the edits that a crash left unsaved, as one step that can be undone. Where the file itself
     * is gone or wrong, the recovered text stands in for it.
     *
     * @throws JenException if the recovered text does not parse, as where its textures are gone
     */
    public static OpenDocument recover(RecoveryFolder.RecoverableScene recoverable) throws JenException {
        JenDocument edits =
                JenReader.read(recoverable.text(), recoverable.file().toString(), recoverable.file().toAbsolutePath().getParent());
        try {
            OpenDocument document = open(recoverable.file());
            document.history.edit(edits.animatedScene(), null);
            document.clampFrame();
            return document;
        } catch (IOException | JenException e) {
            return new OpenDocument(new SavedScene(recoverable.file(), FileState.MISSING, edits));
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
        if (content != shownContent || frame != shownFrame) {
            try {
                show(content, content.sceneAt(frame), "");
            } catch (IllegalArgumentException e) {
                show(content, content.base(), e.getMessage());
            }
        }
        return shownScene;
    }

    private void show(AnimatedScene content, Scene scene, String problem) {
        shownContent = content;
        shownFrame = frame;
        shownScene = scene;
        frameProblem = problem;
    }

    /** The scene with its shot. */
    public AnimatedScene content() {
        return history.content();
    }

    /** Why the frame cannot be shown, as where a scale goes through 0: then the scene is, as it is without keys. Empty where it can. */
    public Optional<String> frameProblem() {
        scene();
        return frameProblem.isEmpty() ? Optional.empty() : Optional.of(frameProblem);
    }

    /** The frame that is shown; empty where there is no shot. */
    public Optional<ShotFrame> shotFrame() {
        return content().shot().map(shot -> new ShotFrame(shot, frame));
    }

    /** Shows another frame of the shot, or the nearest one that it has. */
    public void showFrame(int v) {
        content().shot().ifPresent(shot -> frame = Math.clamp(v, shot.first(), shot.last()));
    }

    private void goToFirstFrame() {
        content().shot().ifPresent(shot -> frame = shot.first());
    }

    public EditHistory history() {
        return history;
    }

    /** The text of what the document holds or held, with the comments and the order of the file. On any thread. */
    public String text(AnimatedScene content) {
        return saved.document().withAnimatedScene(content).text();
    }

    /** The scene as the file holds it, where nothing has keys. */
    public Scene savedScene() {
        return savedDocument().scene();
    }

    /** What the file holds. */
    JenDocument savedDocument() {
        return saved.document();
    }

    /** Whether there are edits that the file does not have. */
    public boolean isDirty() {
        return knownState().equals(FileState.MISSING) || diskStatus.isDeleted() || ignoresDiskChange
                || !content().equals(savedDocument().animatedScene());
    }

    /** What the file held when it was read or written here. */
    public FileState knownState() {
        return saved.state();
    }

    /** Takes what was seen of the file, unless that is of before it was read or written last. */
    public void setDiskStatus(DiskStatus status) {
        if (status.file().equals(file()) && status.known().equals(knownState())) {
            diskStatus = status;
        }
    }

    /** What was heard last of the file on disk. */
    public DiskStatus diskStatus() {
        return diskStatus;
    }

    /** Stays with what is open here although somebody else wrote the file; saving it asks all the same. */
    public void ignoreDiskChange() {
        ignoresDiskChange = true;
    }

    /** Whether someone else wrote the file, or took it away, since it was read or saved, as far as was heard. */
    public boolean isChangedOnDisk() {
        return diskStatus.isChanged() || diskStatus.isDeleted();
    }

    /** Makes the edit unless it was refused; returns the reason if it was. */
    public Optional<String> apply(EditOutcome change) {
        return apply(change, null);
    }

    /** The same as part of a gesture: see {@link EditHistory#edit(Scene, Object)}. */
    public Optional<String> apply(EditOutcome change, Object gesture) {
        if (change instanceof EditOutcome.Applied to) {
            resolveSelection();
            AnimatedScene edited;
            try {
                edited = contentWith(to.scene());
            } catch (IllegalArgumentException e) {
                return Optional.of(e.getMessage());
            }
            history.edit(edited, gesture);
            if (frameProblem.isEmpty() && history.content() == edited) {
                // The same in every bit as what it would be made of anew, and it shares with what was shown before.
                show(edited, to.scene(), "");
            }
        }
        return change.refusal();
    }

    /** What has keys is edited at the frame that is shown, all else at all frames. */
    private AnimatedScene contentWith(Scene to) {
        Scene before = scene();
        return frameProblem.isEmpty() ? content().withEdit(frame, before, to) : content().withScene(to);
    }

    /** Makes an edit of the scene with its shot; returns the reason if it was refused. As {@link #apply} part of a gesture. */
    public Optional<String> applyToShot(Supplier<AnimatedScene> edit, Object gesture) {
        try {
            AnimatedScene edited = edit.get();
            resolveSelection();
            boolean isNewShot = content().shot().isEmpty();
            history.edit(edited, gesture);
            if (isNewShot) {
                goToFirstFrame();
            }
            clampFrame();
            return Optional.empty();
        } catch (IllegalArgumentException e) {
            return Optional.of(e.getMessage());
        }
    }

    /** After another step of the history: a frame that the shot lacks gives way to the nearest one. */
    void clampFrame() {
        showFrame(frame);
    }

    public Selection selection() {
        return selection;
    }

    public void select(Selection v) {
        selection = v;
    }

    /** From the next edit on, the light that stands in for one that is gone is the selected one. */
    void resolveSelection() {
        selectedLight().ifPresent(light -> selectLight(light.name()));
    }

    /** Selects the light of that name; nothing if there is none. */
    public void selectLight(String light) {
        selection = Selection.light(history, light);
    }

    /** The selected light as it is now, or its neighbor where it is gone; empty if none is selected or there are no lights. */
    public Optional<Light> selectedLight() {
        return selection.light(history).flatMap(light -> scene().light(light.name()));
    }

    /** The scene as it is now, to be written on any thread. */
    SaveRequest prepareSave(Path target, Set<OverwriteConfirmation> allowed) {
        return new SaveRequest(saved, content(), target, allowed);
    }

    /** The scene was written. What was edited since is not in the file. */
    void onSaved(SavedScene newSaved) {
        setSaved(newSaved);
    }

    /** The file was read anew: the document starts over with it (paper §3.4), as one step that can be undone. */
    void onReloaded(SavedScene newSaved) {
        setSaved(newSaved);
        history.edit(newSaved.document().animatedScene(), null);
        clampFrame();
    }
}
