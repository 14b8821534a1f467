package lightning.editor.window.model;

import java.util.Optional;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.ObjectProperty;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;
import javafx.beans.property.SimpleBooleanProperty;
import lightning.base.text.Texts;
import lightning.editor.document.Change;
import lightning.editor.document.OpenDocument;
import lightning.editor.document.PreviewCamera;
import lightning.editor.document.Selection;
import lightning.editor.document.Situation;
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
    private final ReadOnlyObjectWrapper<Situation> situation = new ReadOnlyObjectWrapper<>();
    private final BooleanProperty live = new SimpleBooleanProperty();
    private final BooleanProperty materialInFront = new SimpleBooleanProperty();
    private final StatusMessage message = new StatusMessage();
    private final SceneSelection selection;
    private final Workbench workbench;
    private final ObjectProperty<PreviewCamera> previewCamera;
    private final FileWork fileWork;
    private final KeyChoice keyChoice;
    /** What an open animation shows in place of the document; null where none is open. */
    private Scene staged;

    /** @param previewCamera follows the scene's camera from frame to frame while it is the same */
    SceneEditor(Workbench workbench, ObjectProperty<PreviewCamera> previewCamera, FileWork fileWork, KeyChoice keyChoice) {
        this.workbench = workbench;
        this.previewCamera = previewCamera;
        this.fileWork = fileWork;
        this.keyChoice = keyChoice;
        selection = new SceneSelection(workbench, situationProperty(), materialInFront);
        live.addListener((_, _, on) -> {
            workbench.setLive(on);
            stage(staged);
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
    public ReadOnlyObjectProperty<Situation> situationProperty() {
        return situation.getReadOnlyProperty();
    }

    /** Whether edits are rendered as they are made, without Go. */
    public BooleanProperty liveProperty() {
        return live;
    }

    /** Whether the properties of the material are shown in place of those of the selection. */
    public BooleanProperty materialInFrontProperty() {
        return materialInFront;
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
        return staged == null ? document().scene() : staged;
    }

    /**
     * Makes an edit, of the document or of the animation that is open.
     *
     * @return why it was refused; empty if it was made
     */
    public Optional<String> edit(Function<Scene, Change> edit) {
        return edit(edit, null);
    }

    /**
     * The same as part of a gesture, all of which is one step to undo.
     *
     * @param gesture any object that stands for one drag, told by identity; null for a step of its own
     */
    public Optional<String> edit(Function<Scene, Change> edit, Object gesture) {
        message.clear();
        Change change = edit.apply(scene());
        if (staged == null) {
            return workbench.edit(change, gesture);
        }
        stage(change.or(staged));
        return change.refusal();
    }

    /** Makes an edit as {@link #edit(Function)} does, and shows a refusal in the status line. */
    public Optional<String> editOrReport(Function<Scene, Change> edit) {
        return editOrReport(edit, null);
    }

    /** Makes an edit as {@link #edit(Function, Object)} does, and shows a refusal in the status line. */
    public Optional<String> editOrReport(Function<Scene, Change> edit, Object gesture) {
        return reported(edit(edit, gesture));
    }

    /**
     * Makes an edit of the scene with its shot: of keys, or of what is the same at all frames.
     *
     * @param edit    throws an {@link IllegalArgumentException} that says why it cannot be made
     * @param gesture as in {@link #edit(Function, Object)}
     * @return why it was refused; empty if it was made
     */
    public Optional<String> editAll(UnaryOperator<AnimatedScene> edit, Object gesture) {
        message.clear();
        if (staged != null) {
            return Optional.of(Texts.of("an animation is open; close it first"));
        }
        return workbench.editAll(() -> edit.apply(document().content()), gesture);
    }

    /** Makes an edit as {@link #editAll} does, and shows a refusal in the status line. */
    public Optional<String> editAllOrReport(UnaryOperator<AnimatedScene> edit, Object gesture) {
        return reported(editAll(edit, gesture));
    }

    /** Makes an edit of the document, shows a refusal in the status line, and selects the shape or the group of a name if it was made. */
    Optional<String> editAndSelect(Function<Scene, Change> edit, String node) {
        message.clear();
        materialInFront.set(false);
        return reported(workbench.editAndSelect(edit.apply(document().scene()), new Selection.OfNode(node)));
    }

    private Optional<String> reported(Optional<String> refusal) {
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
        if (staged == null) {
            workbench.go();
        } else {
            workbench.show(staged);
        }
    }

    /** Whether an animation is open: edits then are no edits of the document, and are gone when it is closed. */
    public boolean isAnimating() {
        return staged != null;
    }

    public void beginAnimation() {
        staged = document().scene();
        workbench.setAnimating(true);
    }

    /** Shows and renders a scene of the animation. */
    public void animate(Scene frame) {
        staged = frame;
        workbench.show(frame);
    }

    private void stage(Scene frame) {
        staged = frame;
        refresh();
        if (staged != null && live.get() && situation.get().isPending()) {
            workbench.show(staged);
        }
    }

    /** Restores the document's scene, in the picture too. */
    public void endAnimation() {
        dropAnimation();
        workbench.setAnimating(false);
        if (situation.get().isPending()) {
            go();
        }
    }

    /** Ends an animation whose document is about to be closed. */
    void dropAnimation() {
        staged = null;
    }

    /** Takes over what the workbench has now. */
    void refresh() {
        document.set(document());
        scene.set(scene());
        selection.refresh(scene());
        Situation now =
                workbench.situation().withReading(fileWork.file() != null).withChosenKeys(keyChoice.settled(document().content()));
        situation.set(staged == null ? now
                : now.withStaged(staged, Optional.ofNullable(selection.light()), document().selection().node(staged)));
    }
}
