package lightning.editor.window.model;

import java.util.Optional;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.ObjectProperty;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;
import javafx.beans.property.SimpleBooleanProperty;
import lightning.base.text.Messages;
import lightning.editor.document.EditOutcome;
import lightning.editor.document.EditorState;
import lightning.editor.document.OpenDocument;
import lightning.editor.document.PreviewCamera;
import lightning.editor.document.Selection;
import lightning.editor.document.Workbench;
import lightning.scene.Scene;
import lightning.scene.shot.AnimatedScene;

/**
 * The scene that the panes show and edit: the open document's, or the frame that an open animation shows. Every edit clears the message of
 * the edit before.
 */
public final class SceneEditor {
    private final ReadOnlyObjectWrapper<OpenDocument> document = new ReadOnlyObjectWrapper<>();
    private final ReadOnlyObjectWrapper<Scene> scene = new ReadOnlyObjectWrapper<>();
    private final ReadOnlyObjectWrapper<EditorState> editorState = new ReadOnlyObjectWrapper<>();
    private final BooleanProperty live = new SimpleBooleanProperty();
    private final BooleanProperty materialShown = new SimpleBooleanProperty();
    private final StatusMessage message = new StatusMessage();
    private final SceneSelection selection;
    private final Workbench workbench;
    private final ObjectProperty<PreviewCamera> previewCamera;
    private final FileActivity fileActivity;
    private final KeySelection keySelection;
    /** What an open animation shows in place of the document; null where none is open. */
    private Scene animationScene;

    /** @param previewCamera follows the scene's camera from frame to frame while it is the same */
    SceneEditor(Workbench workbench, ObjectProperty<PreviewCamera> previewCamera, FileActivity fileActivity, KeySelection keySelection) {
        this.workbench = workbench;
        this.previewCamera = previewCamera;
        this.fileActivity = fileActivity;
        this.keySelection = keySelection;
        selection = new SceneSelection(workbench, editorStateProperty(), materialShown);
        live.addListener((_, _, on) -> {
            workbench.setLive(on);
            setAnimationScene(animationScene);
        });
    }

    public ReadOnlyObjectProperty<OpenDocument> documentProperty() {
        return document.getReadOnlyProperty();
    }

    /** The scene as edited: the document's, or what an open animation shows. */
    public ReadOnlyObjectProperty<Scene> sceneProperty() {
        return scene.getReadOnlyProperty();
    }

    /** Everything that decides which commands are enabled. */
    public ReadOnlyObjectProperty<EditorState> editorStateProperty() {
        return editorState.getReadOnlyProperty();
    }

    /** Whether edits are rendered as they are made, without Go. */
    public BooleanProperty liveProperty() {
        return live;
    }

    /** Whether the properties of the material are shown in place of those of the selection. */
    public BooleanProperty materialShownProperty() {
        return materialShown;
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
        return animationScene == null ? document().scene() : animationScene;
    }

    /**
     * Makes an edit, of the document or of the animation that is open.
     *
     * @return why it was refused; empty if it was made
     */
    public Optional<String> edit(Function<Scene, EditOutcome> edit) {
        return edit(edit, null);
    }

    /**
     * The same as part of a gesture, all of which is one step to undo.
     *
     * @param gesture any object that stands for one drag, told by identity; null for a step of its own
     */
    public Optional<String> edit(Function<Scene, EditOutcome> edit, Object gesture) {
        message.clear();
        EditOutcome change = edit.apply(scene());
        if (animationScene == null) {
            return workbench.edit(change, gesture);
        }
        setAnimationScene(change.sceneOr(animationScene));
        return change.refusal();
    }

    /** Makes an edit as {@link #edit(Function)} does, and shows a refusal in the status line. */
    public Optional<String> editOrReport(Function<Scene, EditOutcome> edit) {
        return editOrReport(edit, null);
    }

    /** Makes an edit as {@link #edit(Function, Object)} does, and shows a refusal in the status line. */
    public Optional<String> editOrReport(Function<Scene, EditOutcome> edit, Object gesture) {
        return reportRefusal(edit(edit, gesture));
    }

    /**
     * Makes an edit of the scene with its shot: of keys, or of what is the same at all frames.
     *
     * @param edit    throws an {@link IllegalArgumentException} that says why it cannot be made
     * @param gesture as in {@link #edit(Function, Object)}
     * @return why it was refused; empty if it was made
     */
    public Optional<String> editShot(UnaryOperator<AnimatedScene> edit, Object gesture) {
        message.clear();
        if (animationScene != null) {
            return Optional.of(Messages.tr("an animation is open; close it first"));
        }
        return workbench.editShot(() -> edit.apply(document().content()), gesture);
    }

    /** Makes an edit as {@link #editShot} does, and shows a refusal in the status line. */
    public Optional<String> editShotOrReport(UnaryOperator<AnimatedScene> edit, Object gesture) {
        return reportRefusal(editShot(edit, gesture));
    }

    /** Makes an edit of the document, shows a refusal in the status line, and selects the shape or the group of a name if it was made. */
    Optional<String> editAndSelect(Function<Scene, EditOutcome> edit, String node) {
        message.clear();
        materialShown.set(false);
        return reportRefusal(workbench.editAndSelect(edit.apply(document().scene()), new Selection.OfNode(node)));
    }

    private Optional<String> reportRefusal(Optional<String> refusal) {
        refusal.ifPresent(message::show);
        return refusal;
    }

    /** Shows a frame of the shot in both pictures; edits are made at it from then on. */
    public void showFrame(int frame) {
        PreviewCamera before = PreviewCamera.of(scene());
        message.show(workbench.showFrame(frame).orElse(""));
        if (previewCamera.get().equals(before)) {
            previewCamera.set(PreviewCamera.of(scene()));
        }
    }

    /** Renders the scene as edited. */
    public void go() {
        if (animationScene == null) {
            workbench.go();
        } else {
            workbench.show(animationScene);
        }
    }

    /** Whether an animation is open: edits then are no edits of the document, and are gone when it is closed. */
    public boolean isAnimating() {
        return animationScene != null;
    }

    public void beginAnimation() {
        animationScene = document().scene();
        workbench.setAnimating(true);
    }

    /** Shows and renders a scene of the animation. */
    public void showAnimationScene(Scene frame) {
        animationScene = frame;
        workbench.show(frame);
    }

    private void setAnimationScene(Scene frame) {
        animationScene = frame;
        refresh();
        if (animationScene != null && live.get() && editorState.get().hasPendingEdits()) {
            workbench.show(animationScene);
        }
    }

    /** Restores the document's scene, in the picture too. */
    public void endAnimation() {
        dropAnimation();
        workbench.setAnimating(false);
        if (editorState.get().hasPendingEdits()) {
            go();
        }
    }

    /** Ends an animation whose document is about to be closed. */
    void dropAnimation() {
        animationScene = null;
    }

    /** Takes over what the workbench has now. */
    void refresh() {
        document.set(document());
        scene.set(scene());
        selection.refresh(scene());
        EditorState state =
                workbench.editorState().withReading(fileActivity.file() != null)
                        .withSelectedKeyCount(keySelection.retainExisting(document().content()));
        editorState.set(animationScene == null ? state
                : state.withAnimationScene(animationScene, Optional.ofNullable(selection.light()),
                        document().selection().node(animationScene)));
    }
}
