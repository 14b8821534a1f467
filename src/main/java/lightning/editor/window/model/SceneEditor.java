package lightning.editor.window.model;

import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.IntegerProperty;
import javafx.beans.property.ObjectProperty;
import javafx.beans.property.ReadOnlyIntegerProperty;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.beans.property.SimpleIntegerProperty;
import javafx.beans.property.SimpleObjectProperty;
import lightning.document.EditOutcome;
import lightning.document.OpenDocument;
import lightning.document.Selection;
import lightning.document.look.LookFiles;
import lightning.document.manipulation.PreviewCamera;
import lightning.editor.EditorState;
import lightning.editor.Workbench;
import lightning.scene.Scene;
import lightning.scene.shot.AnimatedScene;
import org.jspecify.annotations.Nullable;

/** Shows and edits the scene of the open document. Every edit clears the previous message. */
public final class SceneEditor {
    private final ReadOnlyObjectWrapper<OpenDocument> document = new ReadOnlyObjectWrapper<>();
    private final ReadOnlyObjectWrapper<Scene> scene = new ReadOnlyObjectWrapper<>();
    private final ReadOnlyObjectWrapper<EditorState> editorState = new ReadOnlyObjectWrapper<>();
    private final BooleanProperty live = new SimpleBooleanProperty();
    private final BooleanProperty materialShown = new SimpleBooleanProperty();
    private final IntegerProperty savedLooks = new SimpleIntegerProperty();
    private final IntegerProperty looksVersion = new SimpleIntegerProperty();
    private final ObjectProperty<@Nullable ComparedLooks> comparedLooks = new SimpleObjectProperty<>();
    private final StatusMessage message = new StatusMessage();
    private final SceneSelection selection;
    private final Workbench workbench;
    private final ObjectProperty<PreviewCamera> previewCamera;
    private final FileActivity fileActivity;
    private final KeySelection keySelection;
    /** Scene at the time of the last message, which does not apply to others. */
    private @Nullable Scene messageScene;

    /** @param previewCamera  camera of the preview; follows the scene's camera while both are equal */
    SceneEditor(Workbench workbench, ObjectProperty<PreviewCamera> previewCamera, FileActivity fileActivity, KeySelection keySelection) {
        this.workbench = workbench;
        this.previewCamera = previewCamera;
        this.fileActivity = fileActivity;
        this.keySelection = keySelection;
        selection = new SceneSelection(workbench, editorStateProperty(), materialShown);
        message.textProperty().subscribe(_ -> messageScene = scene());
        live.addListener((_, _, on) -> workbench.setLive(on));
    }

    public ReadOnlyObjectProperty<OpenDocument> documentProperty() {
        return document.getReadOnlyProperty();
    }

    /** Scene as edited. */
    public ReadOnlyObjectProperty<Scene> sceneProperty() {
        return scene.getReadOnlyProperty();
    }

    /** State that decides which commands are enabled. */
    public ReadOnlyObjectProperty<EditorState> editorStateProperty() {
        return editorState.getReadOnlyProperty();
    }

    /** True if edits are rendered immediately, without Go. */
    public BooleanProperty liveProperty() {
        return live;
    }

    /** True if the material's properties are shown in place of the selection's. */
    public BooleanProperty materialShownProperty() {
        return materialShown;
    }

    /** Number of looks saved in this session. */
    public IntegerProperty savedLooksProperty() {
        return savedLooks;
    }

    /** Lists the looks again, for which files have appeared. */
    void reloadLooks() {
        workbench.looksChanged();
        looksVersion.set(looksVersion.get() + 1);
    }

    /** Returns a number that changes with the files of the looks. */
    public ReadOnlyIntegerProperty looksVersionProperty() {
        return looksVersion;
    }

    /** Returns the folder for the looks of the open scene if it has no file of its own; empty if it has one. */
    public Optional<Path> untitledLooks() {
        return workbench.untitledLooks();
    }

    /** Returns the folder of the looks of the open scene. */
    public LookFiles looksFolder() {
        Path scene = document().file();
        return untitledLooks().map(folder -> LookFiles.ofUntitled(scene, folder)).orElseGet(() -> new LookFiles(scene));
    }

    /** Two looks that the panel of looks shall show beside each other; null if it has done so. */
    public ObjectProperty<@Nullable ComparedLooks> comparedLooksProperty() {
        return comparedLooks;
    }

    /** Shows two looks, which have just been saved, beside each other. */
    public void compareLooks(ComparedLooks looks) {
        comparedLooks.set(looks);
        reloadLooks();
    }

    /** Reports a saved or deleted look. */
    public void looksChanged() {
        workbench.looksChanged();
    }

    public SceneSelection selection() {
        return selection;
    }

    public StatusMessage message() {
        return message;
    }

    public OpenDocument document() {
        return workbench.document();
    }

    public Scene scene() {
        return document().scene();
    }

    /**
     * Applies an edit to the document.
     *
     * @return why the edit was refused; empty if it was applied
     */
    public Optional<String> edit(Function<Scene, EditOutcome> edit) {
        return edit(edit, null);
    }

    /**
     * Applies an edit as part of a gesture, which is one undo step.
     *
     * @param gesture  object that identifies one drag; null for a separate undo step
     */
    public Optional<String> edit(Function<Scene, EditOutcome> edit, @Nullable Object gesture) {
        message.clear();
        return workbench.edit(edit.apply(scene()), gesture);
    }

    /** Applies an edit as {@link #edit(Function, Object)} does, and renders it also if Live is off, unless there is no picture yet. */
    public Optional<String> editAndRender(Function<Scene, EditOutcome> edit, @Nullable Object gesture) {
        message.clear();
        return workbench.editAndRender(edit.apply(scene()), gesture);
    }

    /** Applies an edit as {@link #editAndRender} does, and shows a refusal in the status line. */
    public Optional<String> editAndRenderOrReport(Function<Scene, EditOutcome> edit, @Nullable Object gesture) {
        return reportRefusal(editAndRender(edit, gesture));
    }

    /** Applies an edit as {@link #edit(Function)} does, and shows a refusal in the status line. */
    public Optional<String> editOrReport(Function<Scene, EditOutcome> edit) {
        return editOrReport(edit, null);
    }

    /** Applies an edit as {@link #edit(Function, Object)} does, and shows a refusal in the status line. */
    public Optional<String> editOrReport(Function<Scene, EditOutcome> edit, @Nullable Object gesture) {
        return reportRefusal(edit(edit, gesture));
    }

    /**
     * Applies an edit to the scene with its shot: to keyframes or to static values.
     *
     * @param edit  throws an {@link IllegalArgumentException} with the reason if the edit is invalid
     * @param gesture  gesture as in {@link #edit(Function, Object)}
     * @return why the edit was refused; empty if it was applied
     */
    public Optional<String> editShot(UnaryOperator<AnimatedScene> edit, @Nullable Object gesture) {
        message.clear();
        return workbench.editShot(() -> edit.apply(document().content()), gesture);
    }

    /** Applies an edit as {@link #editShot} does, and shows a refusal in the status line. */
    public Optional<String> editShotOrReport(UnaryOperator<AnimatedScene> edit, @Nullable Object gesture) {
        return reportRefusal(editShot(edit, gesture));
    }

    /** Applies an edit to the document and then selects a shape or group by name. Shows a refusal in the status line. */
    Optional<String> editAndSelect(Function<Scene, EditOutcome> edit, String node) {
        message.clear();
        materialShown.set(false);
        return reportRefusal(workbench.editAndSelect(edit.apply(document().scene()), new Selection.OfNode(node)));
    }

    private Optional<String> reportRefusal(Optional<String> refusal) {
        refusal.ifPresent(message::show);
        return refusal;
    }

    /** Shows a frame of the shot in the preview and the traced picture. Later edits apply at this frame. */
    public void showFrame(int frame) {
        message.show(workbench.showFrame(frame).orElse(""));
    }

    /** Renders the scene as edited. */
    public void go() {
        workbench.go();
    }

    /** Updates all properties from the workbench. */
    void refresh() {
        if (document() != document.get()) {
            // A message about opening the document was shown before.
            messageScene = scene();
        } else if (scene() != messageScene) {
            // A message about an earlier state, such as one that was undone since.
            message.clear();
        }
        document.set(document());
        Scene before = scene.get();
        boolean followsCamera = before != null && previewCamera.get().equals(PreviewCamera.of(before));
        scene.set(scene());
        if (followsCamera) {
            previewCamera.set(PreviewCamera.of(scene()));
        }
        selection.refresh(scene());
        editorState.set(workbench.editorState().withReading(fileActivity.file() != null)
                .withSelectedKeyCount(keySelection.retainExisting(document().content())));
    }
}
