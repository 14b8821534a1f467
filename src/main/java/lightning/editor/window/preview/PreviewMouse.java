package lightning.editor.window.preview;

import static java.util.Objects.requireNonNull;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javafx.beans.property.ObjectProperty;
import lightning.document.EditOutcome;
import lightning.document.LightEdits;
import lightning.document.manipulation.CameraDrag;
import lightning.document.manipulation.DragRounding;
import lightning.document.manipulation.LightDrag;
import lightning.document.manipulation.LightGizmo;
import lightning.document.manipulation.NodeGizmo;
import lightning.document.manipulation.PlacedPart;
import lightning.document.manipulation.PreviewCamera;
import lightning.document.manipulation.Snapping;
import lightning.document.manipulation.Viewport;
import lightning.editor.window.model.PreviewSettings;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.model.SceneSelection;
import lightning.scene.light.Light;
import lightning.scene.value.Placement;
import org.jspecify.annotations.Nullable;

/**
 * Mouse drags in the preview (paper §3.2, §3.6), independent of the toolkit's events. The left button rotates the light under the mouse, or
 * orbits it around its target with Ctrl; the middle button moves it along the view axis, the right button in the view plane. The left
 * button also drags a handle of the selected shape. {@link lightning.editor.window.model.CameraNavigation} decides which drags move the
 * camera.
 */
final class PreviewMouse {
    /** Maximum distance of a click from a gizmo, pixels. */
    private static final double TOLERANCE = 8;
    /** Distance after which a camera drag counts as vertical or horizontal, pixels. */
    private static final double DECISION_DISTANCE = 4;

    private final SceneEditor editor;
    private final SceneSelection selection;
    private final PreviewSettings settings;
    private final ObjectProperty<PreviewCamera> camera;
    private Viewport canvas = new Viewport(1, 1);
    private @Nullable Object gesture;
    private @Nullable Light startLight;
    /** Light that a click without a drag selects; null if it is the light that the press selected. */
    private @Nullable Light nextLight;
    private @Nullable LightDrag lightDrag;
    private @Nullable PreviewCamera startCamera;
    private @Nullable CameraDrag cameraDrag;
    private @Nullable NodeGizmo gizmo;
    private NodeGizmo.@Nullable Handle handle;
    private double pressX;
    private double pressY;

    PreviewMouse(SceneEditor editor, PreviewSettings settings) {
        this.editor = editor;
        this.settings = settings;
        selection = editor.selection();
        camera = settings.cameraProperty();
    }

    void setCanvas(Viewport v) {
        canvas = v;
    }

    Viewport canvas() {
        return canvas;
    }

    /** Returns the lights whose gizmos or border markers are at a point of the canvas, nearest first. Empty while the gizmos are hidden. */
    List<Light> lightsAt(double x, double y) {
        if (settings.gizmosHiddenProperty().get()) {
            return List.of();
        }
        double size = settings.gizmoSizeProperty().get().factor();
        PreviewCamera view = camera.get();
        var point = new Viewport.Pixel(x, y);
        List<Light> candidates = new ArrayList<>(LightGizmo.placed(editor.scene().lights()));
        List<Light> hits = new ArrayList<>();
        Optional<Light> hit = LightGizmo.pick(candidates, view, canvas, size, point, TOLERANCE);
        while (hit.isPresent()) {
            hits.add(hit.get());
            candidates.remove(hit.get());
            hit = LightGizmo.pick(candidates, view, canvas, size, point, TOLERANCE);
        }
        if (hits.isEmpty()) {
            LightMarker.pick(candidates, view, canvas, point).ifPresent(hits::add);
        }
        return hits;
    }

    /**
     * Returns the handles of the selected shape or group, or of what belongs to the selected light, and of the box of the fog. Empty if the handles are
     * hidden; without what is behind the camera.
     */
    List<NodeGizmo> handles() {
        return settings.gizmosHiddenProperty().get() ? List.of()
                : NodeGizmo.of(editor.scene(), PlacedPart.of(editor.scene(), selection.node().orElse(null), selection.light(),
                        settings.fogHandlesProperty().get()), camera.get(), canvas);
    }

    /** Returns whether a drag from this point would move a light or a handle. */
    boolean canGrab(double x, double y) {
        return !lightsAt(x, y).isEmpty() || pick(x, y).isPresent();
    }

    private Optional<NodeGizmo.Grip> pick(double x, double y) {
        return NodeGizmo.pick(handles(), camera.get(), canvas, new Viewport.Pixel(x, y), TOLERANCE);
    }

    /**
     * Starts a drag.
     *
     * @param dragKind action on a light at the point
     */
    void press(double x, double y, LightDrag dragKind) {
        pressX = x;
        pressY = y;
        Optional<NodeGizmo.Grip> grip = dragKind == LightDrag.ROTATE ? pick(x, y) : Optional.empty();
        gizmo = grip.map(NodeGizmo.Grip::gizmo).orElse(null);
        handle = grip.map(NodeGizmo.Grip::handle).orElse(null);
        if (handle != null) {
            gesture = new Object();
            return;
        }
        List<Light> hits = lightsAt(x, y);
        if (hits.isEmpty()) {
            return;
        }
        Light selected = selection.light();
        // The selected light has priority over lights above it; a click without a drag cycles through them.
        boolean hitsSelected = hits.contains(selected);
        nextLight = hitsSelected ? hits.get((hits.indexOf(selected) + 1) % hits.size()) : null;
        Light dragged = selected != null && hitsSelected ? selected : hits.getFirst();
        startLight = dragged;
        lightDrag = dragKind;
        gesture = new Object();
        selection.selectLight(dragged.name());
    }

    /**
     * Starts a drag of the camera, whatever is at the point.
     *
     * @param kind action; empty if the point and the first movement decide
     */
    void pressForCamera(double x, double y, Optional<CameraDrag> kind) {
        pressX = x;
        pressY = y;
        startCamera = camera.get();
        cameraDrag = kind.orElse(null);
    }

    void drag(double x, double y) {
        double right = x - pressX;
        double down = y - pressY;
        nextLight = null;
        if (startCamera != null) {
            dragCamera(right, down);
        } else if (handle != null) {
            var from = new Viewport.Pixel(pressX, pressY);
            var to = new Viewport.Pixel(x, y);
            PreviewCamera view = camera.get();
            NodeGizmo draggedGizmo = gizmo;
            NodeGizmo.Handle draggedHandle = handle;
            Placement placed = DragRounding.round(requireNonNull(draggedGizmo),
                    requireNonNull(draggedGizmo).drag(draggedHandle, view, canvas, from, to), view, canvas);
            if (editor.editOrReport(scene -> EditOutcome.of(() -> draggedGizmo.part().place(scene, placed)), gesture).isEmpty()) {
                editor.message().show(Snapping.describe(draggedGizmo.part().placement(), placed));
            }
        } else if (startLight != null) {
            PreviewCamera view = camera.get();
            Light moved =
                    DragRounding.round(startLight, requireNonNull(lightDrag).apply(startLight, view, canvas, right, -down), view, canvas);
            if (editor.editOrReport(scene -> LightEdits.edit(scene, requireNonNull(startLight).name(), _ -> moved), gesture).isEmpty()) {
                editor.message().show(Snapping.describe(startLight, moved, view));
            }
        }
    }

    private void dragCamera(double right, double down) {
        if (cameraDrag == null && Math.hypot(right, down) >= DECISION_DISTANCE) {
            cameraDrag = CameraDrag.of(canvas, pressX, pressY, right, down);
        }
        if (cameraDrag != null) {
            camera.set(cameraDrag.apply(requireNonNull(startCamera), canvas, right, down));
        }
    }

    void release() {
        if (nextLight != null) {
            selection.selectLight(nextLight.name());
        }
        nextLight = null;
        startLight = null;
        gizmo = null;
        handle = null;
        gesture = null;
        startCamera = null;
        cameraDrag = null;
    }
}
