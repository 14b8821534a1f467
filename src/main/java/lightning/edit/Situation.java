package lightning.edit;

import java.util.Optional;
import lightning.edit.loop.Frame;
import lightning.scene.Light;
import lightning.scene.LightType;
import lightning.scene.Scene;
import lightning.scene.VisiblePart;
import lightning.shading.Sight;

/**
 * Everything that decides which commands have something to do.
 *
 * @param scene         the document's scene
 * @param rendered      what the traced picture shows; empty before the first
 * @param mirrored      what its mirrors show; empty before the first
 * @param inWork        the scene that is being rendered; empty if none is
 * @param verifying     whether a verification runs
 * @param selected      the selected light
 * @param undo          what undo would take back; likewise {@code redo}, and the two of the selected light alone
 * @param dirty         whether the file lacks edits
 * @param changedOnDisk whether someone else changed the file
 * @param copied        the light whose settings were copied
 * @param animating     whether an animation is open
 */
public record Situation(Scene scene, Optional<Scene> rendered, Optional<Scene> mirrored, Optional<Scene> inWork,
        boolean verifying, Optional<Light> selected, Optional<String> undo, Optional<String> redo,
        Optional<String> undoLight, Optional<String> redoLight, boolean dirty, boolean changedOnDisk,
        Optional<Light> copied, boolean animating) {

    /** The situation of a document with a picture, and nothing running, copied or animated. */
    public static Situation of(OpenDocument document, Optional<Frame> frame) {
        History history = document.history();
        Optional<Light> selected = document.selectedLight();
        long id = selected.map(l -> history.id(l.name())).orElse(-1L);
        return new Situation(document.scene(), frame.map(Frame::scene), frame.map(Frame::mirrored), Optional.empty(), false,
                selected, history.undoLabel(), history.redoLabel(), history.undoLabel(id), history.redoLabel(id),
                document.isDirty(), document.isChangedOnDisk(), Optional.empty(), false);
    }

    public Situation withInWork(Optional<Scene> v) {
        return new Situation(scene, rendered, mirrored, v, verifying, selected, undo, redo, undoLight, redoLight, dirty,
                changedOnDisk, copied, animating);
    }

    public Situation withVerifying(boolean v) {
        return new Situation(scene, rendered, mirrored, inWork, v, selected, undo, redo, undoLight, redoLight, dirty,
                changedOnDisk, copied, animating);
    }

    public Situation withCopied(Optional<Light> v) {
        return new Situation(scene, rendered, mirrored, inWork, verifying, selected, undo, redo, undoLight, redoLight, dirty,
                changedOnDisk, v, animating);
    }

    public Situation withAnimating(boolean v) {
        return new Situation(scene, rendered, mirrored, inWork, verifying, selected, undo, redo, undoLight, redoLight, dirty,
                changedOnDisk, copied, v);
    }

    /** Whether there are edits that the traced picture does not show, its mirrors left out. */
    public boolean isPending() {
        return rendered.isEmpty() || !VisiblePart.same(scene, rendered.get());
    }

    /** What the canvas and Save Image say of a picture that is behind the document; empty if it is not. */
    public Optional<String> pendingRemark() {
        return rendered.isPresent() && isPending() ? Optional.of("the picture does not show the edits since the last Go")
                : Optional.empty();
    }

    /** What the canvas says of mirrors that are older than the rest of the picture; empty where they are not. */
    public Optional<String> mirrorsRemark() {
        if (rendered.isEmpty() || mirrored.isEmpty() || new Sight(rendered.get(), mirrored.get()).isCurrent()) {
            return Optional.empty();
        }
        boolean dark = rendered.get().lights().stream().noneMatch(rendered.get()::shines);
        return Optional.of(dark ? "No light shines here; the mirrors still show those of before" : "The mirrors are older than the lights");
    }

    Optional<LightType> type() {
        return selected.map(Light::type);
    }
}
