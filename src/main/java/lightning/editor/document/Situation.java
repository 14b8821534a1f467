package lightning.editor.document;

import io.soabase.recordbuilder.core.RecordBuilder;
import java.util.Optional;
import lightning.base.text.Texts;
import lightning.editor.loop.Frame;
import lightning.editor.loop.Look;
import lightning.render.shading.SeenScenes;
import lightning.scene.Light;
import lightning.scene.LightType;
import lightning.scene.Node;
import lightning.scene.Scene;
import lightning.scene.VisiblePart;
import lightning.scene.shot.Target;

/**
 * Everything that decides which commands have something to do.
 *
 * @param scene         the document's scene
 * @param frame         the traced picture; empty before the first
 * @param inWork        the scene that is being rendered; empty if none is
 * @param verifying     whether a verification runs
 * @param selected      the selected light
 * @param node          the selected shape or group; empty where a light is selected
 * @param undo          what undo would take back; likewise {@code redo}, and the two of the selected light alone
 * @param dirty         whether the file lacks edits
 * @param changedOnDisk whether someone else changed the file
 * @param copied        the light whose settings were copied
 * @param animating     whether an animation is open
 * @param reading       whether a scene file is being read
 * @param moment        the frame that is shown; empty where the scene has no shot
 * @param chosenKeys    how many of its keys are chosen
 * @param way           whether the open animation has a way
 */
@RecordBuilder
public record Situation(Scene scene, Optional<Frame> frame, Optional<Scene> inWork,
        boolean verifying, Optional<Light> selected, Optional<Node> node, Optional<String> undo, Optional<String> redo,
        Optional<String> undoLight, Optional<String> redoLight, boolean dirty, boolean changedOnDisk,
        Optional<Light> copied, boolean animating, boolean reading, Optional<Moment> moment, int chosenKeys, boolean way)
        implements SituationBuilder.With {

    /** The situation of a document with a picture, and nothing running, copied or animated. */
    public static Situation of(OpenDocument document, Optional<Frame> frame) {
        History history = document.history();
        Optional<Light> selected = document.selectedLight();
        long id = selected.map(l -> history.id(l.name())).orElse(-1L);
        return new Situation(document.scene(), frame, Optional.empty(), false,
                selected, document.selection().node(document.scene()), history.undoLabel(), history.redoLabel(), history.undoLabel(id),
                history.redoLabel(id),
                document.isDirty(), document.isChangedOnDisk(), Optional.empty(), false, false, document.moment(), 0, false);
    }

    /** Whether keys of it are what Set Key is for: the selected light's with its bank's, those of the selected shape or group, the camera's. */
    public boolean isSelected(Target target) {
        return switch (target.what()) {
            case CAMERA -> true;
            case LIGHT -> selected.filter(l -> l.name().equals(target.name())).isPresent();
            case BANK -> selected.filter(l -> l.bank().equals(target.name())).isPresent();
            case NODE -> node.filter(n -> n.name().equals(target.name())).isPresent();
        };
    }

    /** The same of an open animation, which shows a scene of its own with the selected light, shape or group as it is there. */
    public Situation withStaged(Scene staged, Optional<Light> light, Optional<Node> other) {
        return with(s -> s.scene(staged).selected(light).node(other));
    }

    /** What the traced picture shows; empty before the first. */
    public Optional<Scene> rendered() {
        return frame.map(Frame::scene);
    }

    /** What its mirrors show; empty before the first. */
    public Optional<Scene> mirrored() {
        return frame.map(Frame::mirrored);
    }

    /** Whether the canvas shows the picture itself, and not a share of it. */
    boolean plain() {
        return frame.map(Frame::look).orElse(Look.PLAIN).isPlain();
    }

    /** Whether there are edits that the traced picture does not show, its mirrors left out. */
    public boolean isPending() {
        return frame.isEmpty() || !VisiblePart.same(scene, frame.get().scene());
    }

    /** What the canvas and Save Image say of a picture that is behind the document; empty if it is not. */
    public Optional<String> pendingRemark() {
        if (frame.isEmpty()) {
            return Optional.empty();
        }
        return isPending() ? Optional.of(Texts.of("the picture does not show the edits since the last Go"))
                : lacksSamples() ? Optional.of(Texts.of("the picture lacks the finer samples of its edges")) : Optional.empty();
    }

    /** Whether the traced picture is one of pixels' centres, that finer samples are still to follow. */
    public boolean lacksSamples() {
        return frame.isPresent() && !frame.get().finished();
    }

    /** What the canvas says of mirrors that are older than the rest of the picture; empty where they are not. */
    public Optional<String> mirrorsRemark() {
        if (frame.isEmpty()) {
            return Optional.empty();
        }
        Scene shown = frame.get().scene();
        if (new SeenScenes(shown, frame.get().mirrored()).isCurrent()) {
            return Optional.empty();
        }
        boolean dark = shown.lights().stream().noneMatch(shown::shines);
        return Optional.of(dark ? Texts.of("No light shines here; the mirrors still show those of before")
                : Texts.of("The mirrors are older than the lights"));
    }

    Optional<LightType> type() {
        return selected.map(Light::type);
    }
}
