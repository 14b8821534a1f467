package lightning.document;

import static java.util.Objects.requireNonNull;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;
import lightning.base.file.FileState;
import lightning.base.file.ParentFolder;
import lightning.base.file.ShippedFile;
import lightning.base.text.Messages;
import lightning.base.text.Quote;
import lightning.base.text.RefusalException;
import lightning.format.jen.AssetCopies;
import lightning.format.jen.InputFiles;
import lightning.format.jen.JenDocument;
import lightning.format.jen.JenException;
import lightning.format.jen.JenReader;
import lightning.format.jen.Problem;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import lightning.scene.shot.AnimatedScene;
import org.jspecify.annotations.Nullable;

/** Open scene document: current scene, selection, history, and unsaved changes. */
public final class OpenDocument {
    private final EditHistory history;
    /** Content of the file when this editor last read or wrote it; its state is empty if the file never had this content. */
    private SavedScene saved;
    private DiskStatus diskStatus;
    private boolean untitled;
    /** True if looks were saved for a document without a file; they move next to its file with the next save. */
    private boolean hasUnsavedLooks;
    private boolean ignoresDiskChange;
    private Selection selection = Selection.NONE;
    private int frame;
    /** Displayed scene and its frame; {@code frameProblem} says why the frame cannot be shown. */
    private @Nullable Scene shownScene;
    private @Nullable AnimatedScene shownContent;
    private int shownFrame;
    private String frameProblem = "";

    private OpenDocument(SavedScene saved, boolean untitled) {
        setSaved(saved);
        this.untitled = untitled;
        history = new EditHistory(saved.document().animatedScene());
        goToFirstFrame();
    }

    /**
     * Opens a scene file; one that is shipped with the program as a copy.
     *
     * @throws IOException  if the file cannot be read
     * @throws JenException if its content is invalid; holds all problems
     */
    public static OpenDocument open(Path file) throws IOException, JenException {
        return new OpenDocument(SavedScene.read(file), ShippedFile.isShipped(file));
    }

    /**
     * Opens a copy of a scene file, which has no file of its own until it is saved. Saving copies the files that the scene references.
     *
     * @throws IOException  if the file cannot be read
     * @throws JenException if its content is invalid; holds all problems
     */
    public static OpenDocument openCopy(Path file) throws IOException, JenException {
        return new OpenDocument(SavedScene.read(file), true);
    }

    /**
     * Opens the text of a scene, which has no file of its own.
     *
     * @param folder folder that the scene's files are resolved against
     * @throws JenException if the text is invalid; holds all problems
     */
    public static OpenDocument openText(String text, Path folder) throws JenException {
        return untitled(folder.resolve("untitled.jen"), JenReader.read(text, "text", folder));
    }

    /**
     * Opens content that no scene file has yet.
     *
     * @param file proposed scene file; the content's files are resolved against its folder
     */
    public static OpenDocument openContent(Path file, JenDocument content) {
        return untitled(file, content);
    }

    /** Returns this document with its current content but without its history, so that many edits do not fill the memory. */
    public OpenDocument withoutHistory() {
        OpenDocument fresh =
                new OpenDocument(new SavedScene(file(), saved.state(), savedDocument().withAnimatedScene(content())), untitled);
        fresh.showFrame(frame);
        return fresh;
    }

    /**
     * Creates a document without a file.
     *
     * @param file proposed file, which does not exist
     */
    static OpenDocument untitled(Path file, JenDocument content) {
        return new OpenDocument(new SavedScene(file, FileState.MISSING, content), true);
    }

    /** Returns this document, as opened, with an image that fits an area. */
    public OpenDocument fittedTo(PictureArea area) {
        Scene scene = savedScene();
        Scene fitted = scene.withPicture(area.fit(scene.picture()));
        return new OpenDocument(new SavedScene(file(), saved.state(), savedDocument().withScene(fitted)), untitled);
    }

    private void setSaved(SavedScene newSaved) {
        saved = newSaved;
        diskStatus = new DiskStatus(newSaved.file(), newSaved.state(), newSaved.state(), false);
        ignoresDiskChange = false;
    }

    /**
     * Opens a scene file with the unsaved edits of a crashed process, as one undo step. If the file itself is missing or invalid, uses the
     * recovered text instead. A file that was changed since that process read it counts as changed by another program.
     *
     * @throws JenException if the recovered text is invalid, for example because its textures are missing
     */
    public static OpenDocument recover(RecoveryFolder.RecoverableScene recoverable) throws JenException {
        JenDocument edits =
                JenReader.read(recoverable.text(), recoverable.file().toString(), ParentFolder.of(recoverable.file()));
        Path file = recoverable.file();
        try {
            OpenDocument document = recoverable.isNew() ? NewScene.create(PictureArea.DEFAULT) : open(file);
            if (!document.untitled) {
                document.setSaved(new SavedScene(file, recoverable.disk().known(), document.savedDocument()));
            }
            document.history.edit(edits.animatedScene(), null);
            document.clampFrame();
            return document;
        } catch (IOException | JenException e) {
            return new OpenDocument(new SavedScene(file, FileState.MISSING, edits), false);
        }
    }

    /** Returns the document's file. If the document is untitled, returns the file that it is a copy of, or a proposal. */
    public Path file() {
        return saved.file();
    }

    /** Returns whether the document has no file of its own until it is saved: a new scene, or a copy of a shipped one. */
    public boolean isUntitled() {
        return untitled;
    }

    /** Returns the file to propose for the document or for a file that belongs to it. */
    public Path proposedFile(String name) {
        return untitled ? NewScene.folder().resolve(name) : file().resolveSibling(name);
    }

    /** Returns the name for the window's title. */
    public String title() {
        return untitled && !knownState().equals(FileState.MISSING) ? Messages.tr("Copy of {0}", name()) : name();
    }

    /** Returns the file's name without its folder. */
    public String name() {
        return Quote.path(file().getFileName());
    }

    /** Returns the scene at the displayed frame; without a shot, the scene. */
    public Scene scene() {
        AnimatedScene content = history.content();
        if (content != shownContent || frame != shownFrame) {
            try {
                show(content, content.sceneAt(frame), "");
            } catch (RefusalException e) {
                show(content, content.base(), e.getMessage());
            }
        }
        return requireNonNull(shownScene);
    }

    private void show(AnimatedScene content, Scene scene, String problem) {
        shownContent = content;
        shownFrame = frame;
        shownScene = scene;
        frameProblem = problem;
    }

    /** Returns the scene with its shot. */
    public AnimatedScene content() {
        return history.content();
    }

    /** Returns the reason why the frame cannot be shown, for example a scale of 0. The scene then ignores keyframes. Empty otherwise. */
    public Optional<String> frameProblem() {
        scene();
        return frameProblem.isEmpty() ? Optional.empty() : Optional.of(frameProblem);
    }

    /** Returns the displayed frame; empty without a shot. */
    public Optional<ShotFrame> shotFrame() {
        return content().shot().map(shot -> new ShotFrame(shot, frame));
    }

    /** Shows another frame of the shot, clamped to its range. */
    public void showFrame(int v) {
        content().shot().ifPresent(shot -> frame = Math.clamp(v, shot.first(), shot.last()));
    }

    private void goToFirstFrame() {
        content().shot().ifPresent(shot -> frame = shot.first());
    }

    public EditHistory history() {
        return history;
    }

    /** Returns the text of a current or earlier content, with the comments and order of the file. Callable on any thread. */
    public String text(AnimatedScene content) {
        return saved.document().withAnimatedScene(content).text();
    }

    /** Returns the file and those that the current scene references, none of which an export may replace. */
    public InputFiles inputs() {
        return InputFiles.of(file(), List.of(savedScene(), content().base()));
    }

    /** Returns the files that the scene file names and cannot use, or only with fewer pixels; see {@link JenDocument#notes}. */
    public List<Problem> notes() {
        return savedDocument().notes();
    }

    /** Returns the names of the files that the scene file names and its folders lack; none if the document is untitled. Callable on any thread. */
    public List<String> missingFiles() throws IOException {
        return untitled ? List.of() : AssetCopies.missing(savedDocument(), ParentFolder.of(file()));
    }

    /**
     * Copies a missing file, and all others that are next to the chosen one, to where the scene finds them, and opens the document again.
     *
     * @param name name of the chosen file in the scene
     * @throws IOException if a file cannot be copied or read
     */
    public OpenDocument withMissingFiles(String name, Path chosen) throws IOException, JenException {
        AssetCopies.copyMissing(savedDocument(), name, chosen, ParentFolder.of(file()));
        return open(file());
    }

    /** Returns the scene of the file, without keyframes applied. */
    public Scene savedScene() {
        return savedDocument().scene();
    }

    /** Returns the document of the file. */
    JenDocument savedDocument() {
        return saved.document();
    }

    /** Returns whether there are unsaved edits. */
    public boolean isDirty() {
        boolean differsFromDisk = knownState().equals(FileState.MISSING) || diskStatus.isDeleted() || ignoresDiskChange;
        return differsFromDisk && !untitled || hasUnsavedLooks || !content().equals(savedDocument().animatedScene());
    }

    /** Marks a document without a file as having looks, which are lost unless it is saved. */
    public void setUnsavedLooks() {
        hasUnsavedLooks = untitled;
    }

    /** Returns the file's content state when this editor last read or wrote it. */
    public FileState knownState() {
        return saved.state();
    }

    /** Sets the observed state of the file, unless it predates the last read or write. */
    public void setDiskStatus(DiskStatus status) {
        if (!untitled && status.file().equals(file()) && status.known().equals(knownState())) {
            diskStatus = status;
        }
    }

    /** Returns the last observed state of the file. */
    public DiskStatus diskStatus() {
        return diskStatus;
    }

    /** Keeps the open content although another program changed the file. A save still requires confirmation. */
    public void ignoreDiskChange() {
        ignoresDiskChange = true;
    }

    /** Returns whether another program changed or deleted the file since it was last read or saved, according to the last check. */
    public boolean isChangedOnDisk() {
        return diskStatus.isChanged() || diskStatus.isDeleted();
    }

    /** Applies the edit unless it was refused; returns the reason if it was. */
    public Optional<String> apply(EditOutcome change) {
        return apply(change, null);
    }

    /** Applies the edit as part of a gesture: see {@link EditHistory#edit(Scene, Object)}. */
    public Optional<String> apply(EditOutcome change, @Nullable Object gesture) {
        if (change instanceof EditOutcome.Applied to) {
            resolveSelection();
            AnimatedScene edited;
            try {
                edited = contentWith(to.scene());
            } catch (RefusalException e) {
                return Optional.of(e.getMessage());
            }
            history.edit(edited, gesture, to.label());
            if (frameProblem.isEmpty() && history.content() == edited) {
                // Bit-identical to a newly built scene, and shares data with the previous one.
                show(edited, to.scene(), "");
            }
        }
        return change.refusal();
    }

    /** Edits animated attributes at the displayed frame, all others at all frames. */
    private AnimatedScene contentWith(Scene to) {
        Scene before = scene();
        return frameProblem.isEmpty() ? content().withEdit(frame, before, to) : content().withScene(to);
    }

    /** Edits the scene with its shot; returns the reason if refused. Part of a gesture as in {@link #apply}. */
    public Optional<String> applyToShot(Supplier<AnimatedScene> edit, @Nullable Object gesture) {
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
        } catch (RefusalException e) {
            return Optional.of(e.getMessage());
        }
    }

    /** Clamps the displayed frame to the shot after a step of the history. */
    public void clampFrame() {
        showFrame(frame);
    }

    public Selection selection() {
        return selection;
    }

    public void select(Selection v) {
        selection = v;
    }

    /** Selects the substitute of a deleted light permanently, at the next edit. */
    public void resolveSelection() {
        selectedLight().ifPresent(light -> selectLight(light.name()));
    }

    /** Selects the light with that name; nothing if it does not exist. */
    public void selectLight(String light) {
        selection = Selection.light(history, light);
    }

    /** Returns the selected light, or its neighbor if it was deleted; empty if none is selected or there are no lights. */
    public Optional<Light> selectedLight() {
        return selection.light(history).flatMap(light -> scene().light(light.name()));
    }

    /** Prepares a save of the current scene, to be written on any thread. */
    public SaveRequest prepareSave(Path target, Set<OverwriteConfirmation> allowed) {
        return new SaveRequest(saved, content(), target, untitled, allowed);
    }

    /** Marks a scene as saved. Later edits are unsaved. */
    public void onSaved(SavedScene newSaved) {
        setSaved(newSaved);
        untitled = false;
        hasUnsavedLooks = false;
    }

    /** Returns a task that reads the saved content, on any thread. An untitled document has only what it was opened with. */
    public FileThread.FileTask<SavedScene> readSaved() {
        SavedScene opened = saved;
        return untitled ? () -> opened : () -> SavedScene.read(opened.file());
    }

    /** Replaces the content with the reloaded file (paper §3.4), as one undo step. */
    public void onReloaded(SavedScene newSaved) {
        setSaved(newSaved);
        history.edit(newSaved.document().animatedScene(), null);
        clampFrame();
    }
}
