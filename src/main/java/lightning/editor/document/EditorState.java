package lightning.editor.document;

import io.soabase.recordbuilder.core.RecordBuilder;
import java.util.Optional;
import lightning.base.text.Messages;
import lightning.editor.loop.DisplayMode;
import lightning.editor.loop.Frame;
import lightning.render.shading.RenderedScenes;
import lightning.scene.Light;
import lightning.scene.LightType;
import lightning.scene.Scene;
import lightning.scene.SceneNode;
import lightning.scene.VisibleState;
import lightning.scene.shot.TrackTarget;

/**
 * Everything that decides which commands have something to do.
 *
 * @param scene         the document's scene
 * @param frame         the traced picture; empty before the first
 * @param sceneInProgress        the scene that is being rendered; empty if none is
 * @param verifying     whether a verification runs
 * @param selectedLight      the selected light
 * @param selectedNode          the selected shape or group; empty where a light is selected
 * @param undoLabel          what undo would take back; likewise {@code redoLabel}, and the two of the selected light alone
 * @param dirty         whether the file lacks edits
 * @param changedOnDisk whether someone else changed the file
 * @param copiedLight        the light whose settings were copied
 * @param animating     whether an animation is open
 * @param reading       whether a scene file is being read
 * @param shotFrame        the frame that is shown; empty where the scene has no shot
 * @param selectedKeyCount    how many of its keys are chosen
 * @param motionRecorded           whether the open animation has a way
 */
@RecordBuilder
public record EditorState(Scene scene, Optional<Frame> frame, Optional<Scene> sceneInProgress,
        boolean verifying, Optional<Light> selectedLight, Optional<SceneNode> selectedNode, Optional<String> undoLabel,
        Optional<String> redoLabel,
        Optional<String> undoLightLabel, Optional<String> redoLightLabel, boolean dirty, boolean changedOnDisk,
        Optional<Light> copiedLight, boolean animating, boolean reading, Optional<ShotFrame> shotFrame, int selectedKeyCount,
        boolean motionRecorded)
        implements EditorStateBuilder.With {

    /** The situation of a document with a picture, and nothing running, copied or animated. */
    public static EditorState of(OpenDocument document, Optional<Frame> frame) {
        EditHistory history = document.history();
        Optional<Light> selected = document.selectedLight();
        long id = selected.map(l -> history.id(l.name())).orElse(-1L);
        return new EditorState(document.scene(), frame, Optional.empty(), false,
                selected, document.selection().node(document.scene()), history.undoLabel(), history.redoLabel(), history.undoLabel(id),
                history.redoLabel(id),
                document.isDirty(), document.isChangedOnDisk(), Optional.empty(), false, false, document.shotFrame(), 0, false);
    }

    /** Whether keys of it are what Set Key is for: the selected light's with its bank's, those of the selected shape or group, the camera's. */
    public boolean isSelected(TrackTarget target) {
        return switch (target.kind()) {
            case CAMERA -> true;
            case LIGHT -> selectedLight.filter(l -> l.name().equals(target.name())).isPresent();
            case LIGHT_GROUP -> selectedLight.filter(l -> l.lightGroup().equals(target.name())).isPresent();
            case NODE -> selectedNode.filter(n -> n.name().equals(target.name())).isPresent();
        };
    }

    /** The same of an open animation, which shows a scene of its own with the selected light, shape or group as it is there. */
    public EditorState withAnimationScene(Scene animationScene, Optional<Light> light, Optional<SceneNode> otherNode) {
        return with(s -> s.scene(animationScene).selectedLight(light).selectedNode(otherNode));
    }

    /** What the traced picture shows; empty before the first. */
    public Optional<Scene> renderedScene() {
        return frame.map(Frame::scene);
    }

    /** What its mirrors show; empty before the first. */
    public Optional<Scene> mirroredScene() {
        return frame.map(Frame::mirroredScene);
    }

    /** Whether the canvas shows the picture itself, and not a share of it. */
    boolean isFullPicture() {
        return frame.map(Frame::displayMode).orElse(DisplayMode.FULL_PICTURE).isFullPicture();
    }

    /** Whether there are edits that the traced picture does not show, its mirrors left out. */
    public boolean hasPendingEdits() {
        return frame.isEmpty() || !VisibleState.isSame(scene, frame.get().scene());
    }

    /** What the canvas and Save Image say of a picture that is behind the document; empty if it is not. */
    public Optional<String> pendingMessage() {
        if (frame.isEmpty()) {
            return Optional.empty();
        }
        return hasPendingEdits() ? Optional.of(Messages.tr("the image is out of date"))
                : lacksSamples() ? Optional.of(Messages.tr("the image is not anti-aliased yet")) : Optional.empty();
    }

    /** Whether the traced picture is one of pixels' centers, that finer samples are still to follow. */
    public boolean lacksSamples() {
        return frame.isPresent() && !frame.get().isFinished();
    }

    /** What the canvas says of mirrors that are older than the rest of the picture; empty where they are not. */
    public Optional<String> staleMirrorsMessage() {
        if (frame.isEmpty()) {
            return Optional.empty();
        }
        Scene shownScene = frame.get().scene();
        if (new RenderedScenes(shownScene, frame.get().mirroredScene()).areReflectionsCurrent()) {
            return Optional.empty();
        }
        boolean isUnlit = shownScene.lights().stream().noneMatch(shownScene::isActive);
        return Optional.of(isUnlit ? Messages.tr("No lights on; reflections out of date")
                : Messages.tr("Reflections out of date"));
    }

    Optional<LightType> selectedLightType() {
        return selectedLight.map(Light::type);
    }
}
