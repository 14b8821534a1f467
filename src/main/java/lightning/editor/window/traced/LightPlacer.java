package lightning.editor.window.traced;

import static java.util.Objects.requireNonNull;

import java.util.Optional;
import javafx.beans.property.ReadOnlyStringProperty;
import javafx.beans.property.ReadOnlyStringWrapper;
import lightning.base.math.Vec3;
import lightning.base.text.Messages;
import lightning.base.text.RefusalException;
import lightning.document.LightEdits;
import lightning.document.loop.Frame;
import lightning.document.manipulation.DragRounding;
import lightning.document.manipulation.LightPlacement;
import lightning.document.manipulation.LightPlacement.Goal;
import lightning.document.manipulation.PreviewCamera;
import lightning.document.manipulation.ScenePicker;
import lightning.document.manipulation.SightPlacement;
import lightning.document.manipulation.Snapping;
import lightning.document.manipulation.Viewport;
import lightning.editor.Command;
import lightning.editor.window.model.CommandRegistry;
import lightning.editor.window.model.ErrorMessage;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.widget.PictureView;
import lightning.scene.light.Light;
import org.jspecify.annotations.Nullable;

/**
 * Places the selected light by its effect in the traced picture: a press or a drag sets the effect's position on a surface. Afterwards a
 * ring around the position changes the light's distance when dragged. The next other edit removes the ring.
 */
final class LightPlacer {
    /** Radius of the ring, pixels. */
    static final double RING_RADIUS = 40;

    private static final String NO_SURFACE = Messages.key("No object here");

    private final SceneEditor editor;
    private final ReadOnlyStringWrapper prompt = new ReadOnlyStringWrapper("");
    private @Nullable Tool tool;
    private @Nullable Drag drag;
    /** Identifies the current drag as one undo step. */
    private @Nullable Object gesture;
    private @Nullable Light startLight;
    private @Nullable Ring ring;
    /** Distance or snapped value of the placed light as shown in the status line; empty for none. */
    private String readOut = "";

    /** Tool for the next press. */
    private sealed interface Tool {
        /** Places the light for a goal. */
        record PlacementTool(Goal act) implements Tool {}

        /** Selects a shadow or its caster. */
        record ShadowTool() implements Tool {}

        /**
         * Selects the caster of a shadow.
         *
         * @param target surface point on which the shadow falls
         */
        record CasterTool(ScenePicker.SurfaceHit target) implements Tool {}
    }

    /** Drag in progress. */
    private sealed interface Drag {
        /**
         * Drag of the effect's position.
         *
         * @param picker finds surfaces of the displayed picture
         */
        record PlacementDrag(LightPlacement placing, ScenePicker picker) implements Drag {}

        /**
         * Drag of a shadow or its caster.
         *
         * @param startHit surface point of the press
         */
        record ShadowDrag(Light startLight, ScenePicker.SurfaceHit startHit, ScenePicker picker) implements Drag {}

        record DistanceDrag(@Nullable Ring ring, Viewport.Pixel start) implements Drag {}

        /** Drag of the caster's point, whose shadow falls on a fixed point. */
        record CasterDrag(ScenePicker.SurfaceHit target, ScenePicker picker) implements Drag {}
    }

    /**
     * Placed light with its ring.
     *
     * @param light light as placed, including its current distance
     */
    private record Ring(LightPlacement placing, ScenePicker.SurfaceHit hit, Light light, ScenePicker picker) {}

    private LightPlacer(SceneEditor editor) {
        this.editor = editor;
        editor.editorStateProperty().subscribe(_ -> {
            if (drag == null && ring != null && !ring.light().equals(editor.selection().light())) {
                clearRing();
            }
        });
    }

    /** Creates the placer and registers the commands that place a light. */
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
        commands.setAction(Command.PLACE_FLAG,
                () -> placer.selectTool(Messages.tr("Click or drag where the light should be blocked"), new Goal.Flag()));
        return placer;
    }

    private void selectTool(String hint, Goal act) {
        selectTool(new Tool.PlacementTool(act), hint);
    }

    private void selectTool(Tool newTool, String hint) {
        tool = newTool;
        clearRing();
        prompt.set(hint);
    }

    /**
     * Position of the mouse.
     *
     * @param pixel pixel of the picture; empty outside it
     * @param canvas size of the whole picture as displayed
     * @param position position on the canvas
     */
    record Pointer(Optional<PictureView.Pixel> pixel, Viewport canvas, Viewport.Pixel position) {
        Optional<ScenePicker.SurfaceHit> pick(ScenePicker picker) {
            return pixel.flatMap(p -> picker.pickPixel(p.x(), p.y()));
        }
    }

    /** Returns the instructions for the current tool; empty without a tool. */
    ReadOnlyStringProperty promptProperty() {
        return prompt.getReadOnlyProperty();
    }

    /** Cancels the current tool. */
    void clearTool() {
        tool = null;
        prompt.set("");
    }

    /** Removes the ring and, if no later message replaced it, the placed light's read-out. Returns false if there was no ring. */
    boolean clearRing() {
        boolean hadRing = ring != null;
        ring = null;
        if (!readOut.isEmpty() && readOut.equals(editor.message().textProperty().get())) {
            editor.message().clear();
        }
        readOut = "";
        return hadRing;
    }

    /** Returns true while a drag is in progress. */
    boolean isDragging() {
        return drag != null;
    }

    /** Returns the position of the ring on a canvas that shows the whole picture; empty without a ring. */
    Optional<RingMark> ringMark(Viewport canvas) {
        return Optional.ofNullable(ring).filter(r -> r.light().type().hasPosition())
                .map(r -> new RingMark(ringCenter(r, canvas), r.light().position().minus(r.hit().point()).length()));
    }

    /**
     * Position of the ring.
     *
     * @param distance current distance of the light from the point
     */
    record RingMark(Viewport.Pixel center, double distance) {}

    private Viewport.Pixel ringCenter(Ring r, Viewport canvas) {
        return canvas.project(PreviewCamera.of(editor.scene()), r.hit().point());
    }

    /** Starts a drag with the tool or of the ring. Returns false if there is nothing to drag. */
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
            pointer.pick(picker).ifPresentOrElse(hit -> {
                switch (requireNonNull(tool)) {
                    case Tool.PlacementTool(Goal act) -> {
                        var placing = LightPlacement.start(draggedLight(), act, hit.point());
                        drag = new Drag.PlacementDrag(placing, picker);
                        place(placing, hit, picker, pointer.canvas(), false);
                    }
                    case Tool.ShadowTool() -> drag = new Drag.ShadowDrag(draggedLight(), hit, picker);
                    case Tool.CasterTool(ScenePicker.SurfaceHit target) -> {
                        drag = new Drag.CasterDrag(target, picker);
                        placeShadow(target, hit, picker, pointer.canvas(), false);
                    }
                }
            }, () -> editor.message().show(Messages.tr(NO_SURFACE)));
        }
        return drag != null;
    }

    /**
     * Continues the drag.
     *
     * @param isSnapping true to snap distances and aim points to round values
     */
    void drag(Pointer pointer, boolean isSnapping) {
        switch (requireNonNull(drag)) {
            case Drag.PlacementDrag(LightPlacement placing, ScenePicker picker) ->
                    pointer.pick(picker).ifPresent(hit -> place(placing, hit, picker, pointer.canvas(), isSnapping));
            case Drag.ShadowDrag(Light lightAtStart, ScenePicker.SurfaceHit pressHit, ScenePicker picker) -> {
                // If the point is in shadow, the occluder is the caster; otherwise the point itself is on the caster.
                Goal newGoal = new Goal.Shadow(picker.findOccluder(pressHit, lightAtStart).orElse(pressHit).point());
                drag = new Drag.PlacementDrag(LightPlacement.start(lightAtStart, newGoal, pressHit.point()), picker);
                drag(pointer, isSnapping);
            }
            case Drag.CasterDrag(ScenePicker.SurfaceHit target, ScenePicker picker) ->
                    pointer.pick(picker).ifPresent(hit -> placeShadow(target, hit, picker, pointer.canvas(), isSnapping));
            case Drag.DistanceDrag(Ring startRing, Viewport.Pixel startPosition) -> {
                Viewport.Pixel center = ringCenter(startRing, pointer.canvas());
                Vec3 point = startRing.hit().point();
                double factor = pointer.position().distance(center) / Math.max(1, startPosition.distance(center));
                double distance = startRing.light().position().minus(point).length() * factor;
                show(startRing.placing(), startRing.hit(), startRing.picker(),
                        SightPlacement.atDistance(startRing.placing(), startRing.light(), startRing.hit(),
                                isSnapping ? Snapping.snapDistance(distance) : distance, startRing.picker()),
                        pointer.canvas(), Optional.empty());
            }
        }
    }

    /**
     * Places the selected light for a goal at a surface point, in one undo step.
     *
     * @param picker finds surfaces of the displayed picture
     */
    void placeAt(ScenePicker.SurfaceHit hit, Goal goal, ScenePicker picker, Viewport canvas) {
        clearTool();
        gesture = new Object();
        Light light = requireNonNull(editor.selection().light());
        startLight = light;
        place(LightPlacement.start(light, goal, hit.point()), hit, picker, canvas, false);
    }

    /** Lets the user pick the object whose shadow falls on a surface point. */
    void pickCaster(ScenePicker.SurfaceHit target) {
        selectTool(new Tool.CasterTool(target), Messages.tr("Click the object that should cast the shadow there"));
    }

    private void placeShadow(ScenePicker.SurfaceHit target, ScenePicker.SurfaceHit caster, ScenePicker picker, Viewport canvas,
            boolean isSnapping) {
        place(LightPlacement.start(draggedLight(), new Goal.Shadow(caster.point()), target.point()), target, picker, canvas,
                isSnapping);
    }

    private void place(LightPlacement placing, ScenePicker.SurfaceHit hit, ScenePicker picker, Viewport canvas, boolean isSnapping) {
        boolean isPool = placing.goal() instanceof Goal.Pool;
        LightPlacement rounded = isSnapping && !isPool ? placing.withDistance(Snapping.snapDistance(placing.distance())) : placing;
        try {
            SightPlacement placed = SightPlacement.of(rounded, hit, picker);
            Optional<Snapping> snap = isSnapping && isPool ? Optional.of(Snapping.ofDirection(placed.light())) : Optional.empty();
            show(rounded, hit, picker, snap.map(s -> placed.withLight(s.light())).orElse(placed), canvas, snap.map(Snapping::message));
        } catch (RefusalException e) {
            editor.message().show(ErrorMessage.of(e));
        }
    }

    private void show(LightPlacement placing, ScenePicker.SurfaceHit hit, ScenePicker picker, SightPlacement placed, Viewport canvas,
            Optional<String> snapText) {
        Light light = snapText.isPresent() ? placed.light()
                : placed.rounded(hit, picker, DragRounding.round(draggedLight(), placed.light(), PreviewCamera.of(editor.scene()), canvas));
        if (editor.editOrReport(scene -> LightEdits.edit(scene, light.name(), _ -> light), gesture).isEmpty()) {
            boolean isFlag = placing.goal() instanceof Goal.Flag;
            ring = isFlag ? null : new Ring(placing, hit, light, picker);
            double distance = light.position().minus(hit.point()).length();
            readOut = snapText.map(s -> Messages.tr("Snapped: {0}", s))
                    .orElseGet(() -> readOut(placed, light.type().hasPosition() && !isFlag ? Snapping.numberText(distance) : ""));
            editor.message().show(readOut);
        }
    }

    /**
     * Returns the text of a placement.
     *
     * @param distance distance as shown; empty for none
     */
    private static String readOut(SightPlacement placed, String distance) {
        if (placed.blocker().isEmpty()) {
            return distance.isEmpty() ? "" : Messages.tr("Distance {0}", distance);
        }
        String blocker = placed.blocker().get();
        return switch (placed.change()) {
            case NONE -> Messages.tr("{0} blocks the light at this point", blocker);
            case CLOSER -> Messages.tr("Distance {0}: moved in front of {1}, which would block the light", distance, blocker);
            case TILTED -> Messages.tr("Turned away from {0}, which would block the light", blocker);
        };
    }

    /**
     * Ends the drag.
     *
     * @param isClick true if the mouse did not move since the press
     */
    void release(boolean isClick) {
        if (drag instanceof Drag.ShadowDrag(Light _, ScenePicker.SurfaceHit pressHit, ScenePicker _) && isClick) {
            selectTool(Messages.tr("Click or drag where the shadow should fall"), new Goal.Shadow(pressHit.point()));
        } else {
            clearTool();
        }
        drag = null;
    }

    /** Reverts the drag and cancels the tool. */
    void cancelDrag() {
        editor.edit(scene -> LightEdits.edit(scene, draggedLight().name(), _ -> draggedLight()), gesture);
        drag = null;
        clearRing();
        clearTool();
    }

    /** Returns the light as it was when the drag or the tool began. */
    private Light draggedLight() {
        return requireNonNull(startLight);
    }
}
