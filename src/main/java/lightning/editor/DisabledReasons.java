package lightning.editor;

import java.util.Optional;
import java.util.function.Function;
import lightning.base.text.Messages;
import lightning.scene.SceneElement;
import lightning.scene.VisibleState;
import lightning.scene.light.LightAttribute;
import lightning.scene.light.LightType;
import lightning.scene.value.SceneLimits;

/** Reasons why commands are disabled: each a clause without a period, or empty if the command is enabled. */
final class DisabledReasons {
    /** Condition of a command that is always enabled. */
    static final Function<EditorState, Optional<String>> NONE = _ -> Optional.empty();

    private static final String NO_PICTURE = Messages.key("nothing is rendered yet");

    private DisabledReasons() {}

    static Optional<String> noPicture(EditorState s) {
        return reasonUnless(s.renderedScene().isPresent(), Messages.tr(NO_PICTURE));
    }

    static Optional<String> notFullPicture(EditorState s) {
        return reasonUnless(s.isFullPicture(), Messages.tr("the view does not show the full image"));
    }

    static Optional<String> nothingRuns(EditorState s) {
        return reasonUnless(s.sceneInProgress().isPresent() || s.verifying() || s.reading(), Messages.tr("nothing is running"));
    }

    static Optional<String> sameAsOnDisk(EditorState s) {
        return reasonUnless(s.dirty() || s.changedOnDisk(), Messages.tr("no unsaved changes"));
    }

    static Optional<String> nothingToSave(EditorState s) {
        return reasonUnless(s.dirty() || s.untitled(), Messages.tr("nothing to save"));
    }

    static Optional<String> nothingToUndo(EditorState s) {
        return reasonUnless(s.undoLabel().isPresent(), Messages.tr("nothing to undo"));
    }

    static Optional<String> nothingToRedo(EditorState s) {
        return reasonUnless(s.redoLabel().isPresent(), Messages.tr("nothing to redo"));
    }

    static Optional<String> nothingToUndoOfLight(EditorState s) {
        return lightReason(s, s.undoLightLabel().isPresent(), Messages.tr("nothing to undo for this light"));
    }

    static Optional<String> nothingToRedoOfLight(EditorState s) {
        return lightReason(s, s.redoLightLabel().isPresent(), Messages.tr("nothing to redo for this light"));
    }

    static Optional<String> noLight(EditorState s) {
        return reasonUnless(s.selectedLight().isPresent(), Messages.tr("no light is selected"));
    }

    static Optional<String> noPlacedLight(EditorState s) {
        return noLight(s).or(() -> reasonUnless(s.selectedLightType().filter(type -> type == LightType.OBJECT).isEmpty(),
                Messages.tr("the light is where its object is")));
    }

    static Optional<String> nothingGlows(EditorState s) {
        return reasonUnless(s.scene().materials().stream().anyMatch(m -> !m.glow().isBlack() && m.bulb().light().isEmpty()),
                Messages.tr("no material glows"));
    }

    static Optional<String> noShape(EditorState s) {
        return reasonUnless(s.selectedNode().isPresent(), Messages.tr("no object is selected"));
    }

    static Optional<String> noShapeOrTooManyShapes(EditorState s) {
        return noShape(s).or(() -> tooManyShapes(s));
    }

    static Optional<String> tooManyShapes(EditorState s) {
        return reasonUnless(s.scene().stage().shapeCount() < SceneLimits.MAX_SHAPES,
                Messages.tr("a scene can have at most {0} objects", SceneLimits.MAX_SHAPES));
    }

    static Optional<String> nothingCopied(EditorState s) {
        return lightReason(s, s.copiedLight().isPresent(), Messages.tr("no settings are copied"));
    }

    static Optional<String> noDirection(EditorState s) {
        return s.selectedLightType().map(LightAttribute.DIRECTION::inactiveReason).orElseGet(() -> noLight(s));
    }

    static Optional<String> tooManyLights(EditorState s) {
        return reasonUnless(s.scene().lights().size() < SceneLimits.MAX_LIGHTS,
                Messages.tr("a scene can have at most {0} lights", SceneLimits.MAX_LIGHTS));
    }

    static Optional<String> noLightGroup(EditorState s) {
        return noLight(s)
                .or(() -> reasonUnless(!s.selectedLight().orElseThrow().lightGroup().isEmpty(),
                        Messages.tr("the light is in no light group")));
    }

    static Optional<String> noLightOrTooManyGroups(EditorState s) {
        return noLight(s)
                .or(() -> reasonUnless(s.scene().rig().lightGroups().size() < SceneLimits.MAX_LIGHT_GROUPS,
                        Messages.tr("a scene can have at most {0} light groups", SceneLimits.MAX_LIGHT_GROUPS)));
    }

    static Optional<String> noLightOrTooManyLights(EditorState s) {
        return noLight(s).or(() -> tooManyLights(s));
    }

    static Optional<String> hasShot(EditorState s) {
        return reasonUnless(s.shotFrame().isEmpty(), Messages.tr("the scene already has a shot"));
    }

    static Optional<String> noShot(EditorState s) {
        return reasonUnless(s.shotFrame().isPresent(), Messages.tr("the scene has no shot"));
    }

    static Optional<String> atFirstFrame(EditorState s) {
        return noShot(s).or(() -> reasonUnless(s.shotFrame().get().frame() > s.shotFrame().get().shot().first(),
                Messages.tr("this is the first frame")));
    }

    static Optional<String> atLastFrame(EditorState s) {
        return noShot(s)
                .or(() -> reasonUnless(s.shotFrame().get().frame() < s.shotFrame().get().shot().last(),
                        Messages.tr("this is the last frame")));
    }

    static Optional<String> noKeyBefore(EditorState s) {
        return noShot(s).or(() -> reasonUnless(s.shotFrame().get().nearestKeyFrame(true).isPresent(),
                Messages.tr("no keyframe before this frame")));
    }

    static Optional<String> noKeyAfter(EditorState s) {
        return noShot(s).or(() -> reasonUnless(s.shotFrame().get().nearestKeyFrame(false).isPresent(),
                Messages.tr("no keyframe after this frame")));
    }

    static Optional<String> nothingWithKeys(EditorState s) {
        return noShot(s).or(() -> reasonUnless(s.shotFrame().get().shot().tracks().stream().anyMatch(t -> s.isSelected(t.target())),
                Messages.tr("the selection has no keyframes; right-click a property to set the first")));
    }

    static Optional<String> noKeySelected(EditorState s) {
        return noShot(s).or(() -> reasonUnless(s.selectedKeyCount() > 0, Messages.tr("no keyframe is selected in the timeline")));
    }

    static Optional<String> noPositionKeys(EditorState s) {
        return noPlacedLight(s)
                .or(() -> reasonUnless(
                        s.shotFrame().flatMap(m -> m.shot().track(new SceneElement.OfLight(s.selectedLight().orElseThrow().name()),
                                LightAttribute.POSITION.name())).isPresent(),
                        Messages.tr("the light has no position keyframes")));
    }

    static Optional<String> singleSample(EditorState s) {
        return reasonUnless(s.scene().picture().sampling().isSupersampled(), Messages.tr("anti-aliasing is off"));
    }

    static Optional<String> noIndirectLight(EditorState s) {
        return reasonUnless(s.scene().picture().indirect().isPresent(), Messages.tr("indirect light is off"));
    }

    static Optional<String> nothingToRender(EditorState s) {
        if (!s.hasPendingEdits() && !s.lacksSamples()) {
            return Optional.of(Messages.tr("nothing to render"));
        }
        boolean isRendering = s.sceneInProgress().filter(scene -> VisibleState.isSame(scene, s.traced())).isPresent();
        return reasonUnless(!isRendering, Messages.tr("rendering is in progress"));
    }

    static Optional<String> mirrorsAreCurrent(EditorState s) {
        if (s.renderedScene().isEmpty() || s.mirroredScene().isEmpty()) {
            return Optional.of(Messages.tr(NO_PICTURE));
        }
        if (VisibleState.isSame(s.renderedScene().get(), s.mirroredScene().get())) {
            return Optional.of(Messages.tr("reflections are up to date"));
        }
        return reasonUnless(s.staleMirrorsMessage().isPresent(), Messages.tr("no visible object is reflective or transparent"));
    }

    private static Optional<String> lightReason(EditorState s, boolean isPossible, String reason) {
        return noLight(s).or(() -> reasonUnless(isPossible, reason));
    }

    private static Optional<String> reasonUnless(boolean isPossible, String reason) {
        return isPossible ? Optional.empty() : Optional.of(reason);
    }
}
