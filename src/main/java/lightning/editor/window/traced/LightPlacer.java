package lightning.editor.window.traced;

import java.util.Optional;
import javafx.beans.property.ReadOnlyStringProperty;
import javafx.beans.property.ReadOnlyStringWrapper;
import lightning.base.math.Vec3;
import lightning.base.text.Messages;
import lightning.editor.document.Command;
import lightning.editor.document.LightEdits;
import lightning.editor.document.LightPlacement;
import lightning.editor.document.LightPlacement.Goal;
import lightning.editor.document.PreviewCamera;
import lightning.editor.document.ScenePicker;
import lightning.editor.document.Snapping;
import lightning.editor.document.Viewport;
import lightning.editor.loop.Frame;
import lightning.editor.window.model.CommandRegistry;
import lightning.editor.window.model.ErrorMessage;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.widget.PictureView;
import lightning.scene.Light;

/**
 * Places the selected light by what it does in the traced picture: a press does it there, a drag goes on with it from surface to surface.
 * Then a ring about the place stays, whose drag takes the light nearer or farther; it goes with the next edit that is not its own.
 */
final class LightPlacer {
    /** The ring's radius, pixels. */
    static final double RING_RADIUS = 40;

    private static final String NO_SURFACE = Messages.key("No object here");

    private final SceneEditor editor;
    private final ReadOnlyStringWrapper prompt = new ReadOnlyStringWrapper("");
    private Tool tool;
    private Drag drag;
    /** Of the drag: what makes it one step, and the light before it. */
    private Object gesture;
    private Light startLight;
    private Ring ring;

    /** What the next press is for. */
    private sealed interface Tool {
        /** It does that, wherever it is. */
        record PlacementTool(Goal act) implements Tool {}

        /** It takes what throws a shadow, or a shadow. */
        record ShadowTool() implements Tool {}
    }

    /** What is under the mouse while the button is down. */
    private sealed interface Drag {
        /** @param picker finds surfaces of the picture that is shown */
        record PlacementDrag(LightPlacement placing, ScenePicker picker) implements Drag {}

        /** @param startHit where the shadow, or what throws it, was taken */
        record ShadowDrag(Light startLight, ScenePicker.SurfaceHit startHit, ScenePicker picker) implements Drag {}

        record DistanceDrag(Ring ring, Viewport.Pixel start) implements Drag {}
    }

    /**
     * A placed light.
     *
     * @param light as it is now
     */
    private record Ring(LightPlacement placing, ScenePicker.SurfaceHit hit, Light light) {}

    private LightPlacer(SceneEditor editor) {
        this.editor = editor;
        editor.editorStateProperty().subscribe(_ -> {
            if (drag == null && ring != null && !ring.light().equals(editor.selection().light())) {
                ring = null;
            }
        });
    }

    /** Does the commands that place a light. */
    static LightPlacer register(SceneEditor editor, CommandRegistry commands) {
        var placer = new LightPlacer(editor);
        commands.setAction(Command.AIM,
                () -> placer.selectTool(Messages.tr("Click where the light should aim, or drag the spot"), new Goal.Pool()));
        commands.setAction(Command.PLACE_HIGHLIGHT,
                () -> placer.selectTool(Messages.tr("Click or drag where the highlight should be"), new Goal.Highlight()));
        commands.setAction(Command.PLACE_DIFFUSE,
                () -> placer.selectTool(Messages.tr("Click or drag on the surface that should face the light"), new Goal.Diffuse()));
        commands.setAction(Command.PLACE_RIM,
                () -> placer.selectTool(Messages.tr("Click or drag where the rim should start"), new Goal.Rim()));
        commands.setAction(Command.PLACE_SHADOW,
                () -> placer.selectTool(new Tool.ShadowTool(),
                        Messages.tr("Drag a shadow or the object that casts it, or click that object")));
        return placer;
    }

    private void selectTool(String hint, Goal act) {
        selectTool(new Tool.PlacementTool(act), hint);
    }

    private void selectTool(Tool newTool, String hint) {
        tool = newTool;
        ring = null;
        prompt.set(hint);
    }

    /**
     * Where the mouse is.
     *
     * @param pixel  of the picture; empty beside it
     * @param canvas the size of the whole picture as it is shown
     * @param position     on that
     */
    record Pointer(Optional<PictureView.Pixel> pixel, Viewport canvas, Viewport.Pixel position) {
        Optional<ScenePicker.SurfaceHit> pick(ScenePicker picker) {
            return pixel.flatMap(p -> picker.pickPixel(p.x(), p.y()));
        }
    }

    /** What the artist shall do; empty where no tool is taken. */
    ReadOnlyStringProperty promptProperty() {
        return prompt.getReadOnlyProperty();
    }

    /** Puts the tool away. */
    void clearTool() {
        tool = null;
        prompt.set("");
    }

    /** Takes the ring away; returns whether there was one. */
    boolean clearRing() {
        boolean hadRing = ring != null;
        ring = null;
        return hadRing;
    }

    /** Whether a press took something. */
    boolean isDragging() {
        return drag != null;
    }

    /** Where the ring is drawn on a canvas that shows the whole picture, and how far the light is from there; empty where there is none. */
    Optional<RingMark> ringMark(Viewport canvas) {
        return Optional.ofNullable(ring).filter(r -> r.light().type().hasPosition())
                .map(r -> new RingMark(ringCenter(r, canvas), r.light().position().minus(r.hit().point()).length()));
    }

    /** @param distance from the place to the light, as it is now */
    record RingMark(Viewport.Pixel center, double distance) {}

    private Viewport.Pixel ringCenter(Ring r, Viewport canvas) {
        return canvas.project(PreviewCamera.of(editor.scene()), r.hit().point());
    }

    /** Takes what is there with the tool, or the ring; returns whether there is something to drag. */
    boolean press(Pointer pointer, double tolerance) {
        Frame frame = editor.editorStateProperty().get().frame().orElse(null);
        gesture = new Object();
        startLight = editor.selection().light();
        if (tool == null) {
            boolean hitsRing = ringMark(pointer.canvas())
                    .filter(m -> Math.abs(m.center().distance(pointer.position()) - RING_RADIUS) <= tolerance).isPresent();
            drag = hitsRing ? new Drag.DistanceDrag(ring, pointer.position()) : null;
        } else if (startLight == null) {
            editor.message().show(Messages.tr("No light is selected"));
        } else if (frame != null) {
            ScenePicker picker = ScenePicker.of(frame.scene(), frame.geometry());
            pointer.pick(picker).ifPresentOrElse(found -> {
                switch (tool) {
                    case Tool.PlacementTool(Goal act) -> {
                        var placing = LightPlacement.start(startLight, act, found.point());
                        drag = new Drag.PlacementDrag(placing, picker);
                        place(placing, found, false);
                    }
                    case Tool.ShadowTool() -> drag = new Drag.ShadowDrag(startLight, found, picker);
                }
            }, () -> editor.message().show(Messages.tr(NO_SURFACE)));
        }
        return drag != null;
    }

    /** @param isSnapping whether distances are rounded, and aims */
    void drag(Pointer pointer, boolean isSnapping) {
        switch (drag) {
            case Drag.PlacementDrag(LightPlacement placing, ScenePicker picker) ->
                    pointer.pick(picker).ifPresent(found -> place(placing, found, isSnapping));
            case Drag.ShadowDrag(Light begin, ScenePicker.SurfaceHit from, ScenePicker picker) -> {
                // Of a shadow, what throws it is what stands between; of anything else it is that itself.
                Goal act = new Goal.Shadow(picker.findOccluder(from, begin).orElse(from).point());
                drag = new Drag.PlacementDrag(LightPlacement.start(begin, act, from.point()), picker);
                drag(pointer, isSnapping);
            }
            case Drag.DistanceDrag(Ring begin, Viewport.Pixel from) -> {
                Viewport.Pixel center = ringCenter(begin, pointer.canvas());
                Vec3 point = begin.hit().point();
                double factor = pointer.position().distance(center) / Math.max(1, from.distance(center));
                double distance = begin.light().position().minus(point).length() * factor;
                show(begin.placing(), begin.hit(),
                        begin.placing().moveToDistance(begin.light(), point, isSnapping ? Snapping.snapDistance(distance) : distance),
                        Optional.empty());
            }
        }
    }

    private void place(LightPlacement placing, ScenePicker.SurfaceHit found, boolean isSnapping) {
        boolean isPool = placing.goal() instanceof Goal.Pool;
        LightPlacement rounded = isSnapping && !isPool ? placing.withDistance(Snapping.snapDistance(placing.distance())) : placing;
        try {
            Light light = rounded.place(found);
            Optional<Snapping> snap = isSnapping && isPool ? Optional.of(Snapping.ofDirection(light)) : Optional.empty();
            show(rounded, found, snap.map(Snapping::light).orElse(light), snap.map(Snapping::message));
        } catch (IllegalArgumentException e) {
            editor.message().show(ErrorMessage.of(e));
        }
    }

    private void show(LightPlacement placing, ScenePicker.SurfaceHit hit, Light light, Optional<String> snapText) {
        if (editor.editOrReport(scene -> LightEdits.edit(scene, light.name(), _ -> light), gesture).isEmpty()) {
            ring = new Ring(placing, hit, light);
            double distance = light.position().minus(hit.point()).length();
            editor.message().show(snapText.map(s -> Messages.tr("Snapped: {0}", s))
                    .orElse(light.type().hasPosition() ? Messages.tr("Distance {0}", Snapping.numberText(distance)) : ""));
        }
    }

    /** @param isClick whether the mouse has not moved since the press */
    void release(boolean isClick) {
        if (drag instanceof Drag.ShadowDrag(Light _, ScenePicker.SurfaceHit from, ScenePicker _) && isClick) {
            selectTool(Messages.tr("Click or drag where the shadow should fall"), new Goal.Shadow(from.point()));
        } else {
            clearTool();
        }
        drag = null;
    }

    /** Takes back what the drag did, and puts the tool away. */
    void cancelDrag() {
        editor.edit(scene -> LightEdits.edit(scene, startLight.name(), _ -> startLight), gesture);
        drag = null;
        ring = null;
        clearTool();
    }
}
