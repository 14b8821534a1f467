package lightning.editor;

import io.soabase.recordbuilder.core.RecordBuilder;
import java.util.Optional;
import lightning.base.text.Messages;
import lightning.document.EditHistory;
import lightning.document.OpenDocument;
import lightning.document.PictureArea;
import lightning.document.ShotFrame;
import lightning.document.loop.DisplayMode;
import lightning.document.loop.Frame;
import lightning.document.loop.RenderState;
import lightning.render.shading.RenderedScenes;
import lightning.scene.Scene;
import lightning.scene.SceneElement;
import lightning.scene.VisibleState;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.node.SceneNode;

/**
 * State of the editor: what its window shows, and which commands are enabled. {@link Workbench} replaces it as a whole.
 *
 * @param document         open document, of which the state has what panes show
 * @param scene            scene of the document
 * @param area             area for which the picture is traced while the scene is edited; empty for the scene's own size
 * @param traced           scene of the document with the size of that area, as it is traced
 * @param render           traced image, and the progress of the next one
 * @param previousScene    scene of the image before, which shows another scene; empty if there is none
 * @param frameStep        whether the image shows only the direct light of a scene whose indirect light is being rendered
 * @param sceneInProgress  scene that is being rendered; empty if none
 * @param verifying        whether a verification is running
 * @param live             whether edits are rendered immediately
 * @param selectedLight    selected light
 * @param selectedNode     selected shape or group; empty if a light is selected
 * @param undoLabel        label of the step that undo reverts; {@code redoLabel} and the two of the selected light correspond
 * @param dirty            whether there are unsaved edits
 * @param changedOnDisk    whether another program changed the file
 * @param copiedLight      light whose settings were copied
 * @param reading          whether a scene file is being read
 * @param shotFrame        displayed frame; empty if the scene has no shot
 * @param selectedKeyCount number of selected keyframes
 * @param untitled         whether the document has no file of its own yet
 */
@RecordBuilder
public record EditorState(OpenDocument document, Scene scene, Optional<PictureArea> area, Scene traced, RenderState render,
        Optional<Scene> previousScene, boolean frameStep,
        Optional<Scene> sceneInProgress, boolean verifying, boolean live, Optional<Light> selectedLight, Optional<SceneNode> selectedNode,
        Optional<String> undoLabel,
        Optional<String> redoLabel,
        Optional<String> undoLightLabel, Optional<String> redoLightLabel, boolean dirty, boolean changedOnDisk,
        Optional<Light> copiedLight, boolean reading, Optional<ShotFrame> shotFrame, int selectedKeyCount,
        boolean untitled)
        implements EditorStateBuilder.With {

    /** Returns the state of a document without an image, with nothing running or copied. */
    public static EditorState of(OpenDocument document) {
        return new EditorState(document, document.scene(), Optional.empty(), document.scene(), RenderState.NONE, Optional.empty(), false,
                Optional.empty(), false, false,
                Optional.empty(), Optional.empty(), Optional.empty(), Optional.empty(), Optional.empty(), Optional.empty(), false, false,
                Optional.empty(), false, Optional.empty(), 0, false).showing(document);
    }

    /** Returns this state with the present content of a document. */
    EditorState showing(OpenDocument shown) {
        EditHistory history = shown.history();
        Optional<Light> selected = shown.selectedLight();
        long id = selected.map(l -> history.id(l.name())).orElse(-1L);
        return with(s -> s.document(shown).scene(shown.scene()).traced(traced(shown.scene(), area)).selectedLight(selected)
                .selectedNode(shown.selection().node(shown.scene()))
                .undoLabel(history.undoLabel()).redoLabel(history.redoLabel()).undoLightLabel(history.undoLabel(id))
                .redoLightLabel(history.redoLabel(id)).dirty(shown.isDirty()).changedOnDisk(shown.isChangedOnDisk())
                .shotFrame(shown.shotFrame()).untitled(shown.isUntitled()));
    }

    private static Scene traced(Scene scene, Optional<PictureArea> area) {
        return area.map(a -> scene.withPicture(a.size(scene.picture()))).orElse(scene);
    }

    /** Returns this state with the present image. An image of another scene makes the one before the previous. */
    EditorState withImage(RenderState next) {
        Frame newFrame = next.frame();
        if (newFrame == null || newFrame == render.frame()) {
            return withRender(next);
        }
        Optional<Scene> shownScene = renderedScene().filter(_ -> !frameStep);
        return withPreviousScene(shownScene.filter(s -> !VisibleState.isSame(s, newFrame.scene())).or(() -> previousScene))
                .withFrameStep(newFrame.step() == Frame.Step.DIRECT_LIGHT).withRender(next);
    }

    /** Returns the traced image; empty before the first. */
    public Optional<Frame> frame() {
        return Optional.ofNullable(render.frame());
    }

    /** Returns whether Set Keyframe applies to a track: of the selected light or its group, of the selected shape or group, of the camera
     * or of the world. */
    public boolean isSelected(SceneElement<?> target) {
        return switch (target) {
            case SceneElement.OfCamera _,SceneElement.OfWorld _ -> true;
            case SceneElement.OfLight(String name) -> selectedLight.filter(l -> l.name().equals(name)).isPresent();
            case SceneElement.OfLightGroup(String name) -> selectedLight.filter(l -> l.lightGroup().equals(name)).isPresent();
            case SceneElement.OfNode(String name) -> selectedNode.filter(n -> n.name().equals(name)).isPresent();
            default -> false;
        };
    }

    /** Returns the scene of the traced image; empty before the first. */
    public Optional<Scene> renderedScene() {
        return frame().map(Frame::scene);
    }

    /** Returns the scene of its reflections; empty before the first. */
    public Optional<Scene> mirroredScene() {
        return frame().map(Frame::mirroredScene);
    }

    /** Returns whether the canvas shows the full image, not a part of it. */
    boolean isFullPicture() {
        return frame().map(Frame::displayMode).orElse(DisplayMode.FULL_PICTURE).isFullPicture();
    }

    /** Returns whether there are edits that the traced image does not show, reflections excluded. */
    public boolean hasPendingEdits() {
        return frame().isEmpty() || !VisibleState.isSame(traced, frame().get().scene());
    }

    /** Returns the warning that the image is out of date, for the canvas and Save Image; empty if it is current. */
    public Optional<String> pendingMessage() {
        if (frame().isEmpty()) {
            return Optional.empty();
        }
        return lacksIndirectLight() ? Optional.of(Messages.tr("the image has no indirect light yet"))
                : hasPendingEdits() ? Optional.of(Messages.tr("the image is out of date"))
                : lacksSamples() ? Optional.of(Messages.tr("the image is not anti-aliased yet")) : Optional.empty();
    }

    /** Returns whether the traced image shows the scene, but not its indirect light, which is rendered after direct light. */
    public boolean lacksIndirectLight() {
        return frame().filter(f -> f.showsDirectLightOf(traced)).isPresent();
    }

    /** Returns whether the traced image has one sample per pixel center and its anti-aliasing samples are pending. */
    public boolean lacksSamples() {
        return frame().isPresent() && !frame().get().isFinished();
    }

    /** Returns the warning that reflections are out of date, for the canvas; empty if they are current. */
    public Optional<String> staleMirrorsMessage() {
        if (frame().isEmpty()) {
            return Optional.empty();
        }
        Scene shownScene = frame().get().scene();
        if (new RenderedScenes(shownScene, frame().get().mirroredScene()).areReflectionsCurrent()) {
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
