package lightning.editor.window.preview;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javafx.beans.property.ObjectProperty;
import lightning.editor.document.CameraDrag;
import lightning.editor.document.LightDrag;
import lightning.editor.document.LightEdits;
import lightning.editor.document.LightGizmo;
import lightning.editor.document.NodeEdits;
import lightning.editor.document.NodeGizmo;
import lightning.editor.document.PreviewCamera;
import lightning.editor.document.Viewport;
import lightning.editor.window.model.PreviewSettings;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.model.SceneSelection;
import lightning.scene.Light;

/**
 * What a drag in the preview does (paper §3.2, §3.6), free of the toolkit's events: the left button rotates the light
 * under the mouse, with Ctrl about what it aims at, the middle one moves it along the view, the right one in the viewing plane; a handle of the selected shape is taken
 * with the left one; with Shift any button moves the camera.
 */
final class PreviewMouse {
    /** How near a click must come to a gizmo, pixels. */
    private static final double TOLERANCE = 8;
    /** How far a drag goes before it is told whether it is vertical, pixels. */
    private static final double DECISION_DISTANCE = 4;

    private final SceneEditor editor;
    private final SceneSelection selection;
    private final PreviewSettings settings;
    private final ObjectProperty<PreviewCamera> camera;
    private Viewport canvas = new Viewport(1, 1);
    private Object gesture;
    private Light startLight;
    /** What a click selects that does not become a drag; null where that is what the press selected. */
    private Light nextLight;
    private LightDrag lightDrag;
    private PreviewCamera startCamera;
    private CameraDrag cameraDrag;
    private NodeGizmo gizmo;
    private NodeGizmo.Handle handle;
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

    /** The lights whose gizmos, or whose markers at the border, are under a place of the canvas; the nearest first, none while they are hidden. */
    List<Light> lightsAt(double x, double y) {
        if (settings.gizmosHiddenProperty().get()) {
            return List.of();
        }
        double size = settings.gizmoSizeProperty().get().factor();
        PreviewCamera view = camera.get();
        var point = new Viewport.Pixel(x, y);
        List<Light> candidates = new ArrayList<>(editor.scene().lights());
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

    /** The handles of the selected shape or group; empty where none is selected, while they are hidden, or where it is behind the eye. */
    Optional<NodeGizmo> handles() {
        return settings.gizmosHiddenProperty().get() ? Optional.empty()
                : selection.node().flatMap(n -> NodeGizmo.of(editor.scene(), n, camera.get(), canvas));
    }

    /** Whether a drag from a place takes a light or a handle. */
    boolean canGrab(double x, double y) {
        return !lightsAt(x, y).isEmpty() || handles().flatMap(g -> pick(g, x, y)).isPresent();
    }

    private Optional<NodeGizmo.Handle> pick(NodeGizmo nodeGizmo, double x, double y) {
        return nodeGizmo.pick(camera.get(), canvas, new Viewport.Pixel(x, y), TOLERANCE);
    }

    /** @param shift moves the camera, whatever is taken */
    void press(double x, double y, LightDrag dragKind, boolean shift) {
        pressX = x;
        pressY = y;
        if (shift) {
            startCamera = camera.get();
            cameraDrag = null;
            return;
        }
        gizmo = handles().orElse(null);
        handle = gizmo == null || dragKind != LightDrag.ROTATE ? null : pick(gizmo, x, y).orElse(null);
        if (handle != null) {
            gesture = new Object();
            return;
        }
        List<Light> hits = lightsAt(x, y);
        if (hits.isEmpty()) {
            return;
        }
        Light selected = selection.light();
        // The selected light is taken again where others lie over it; a click without a drag goes on to them.
        boolean hitsSelected = hits.contains(selected);
        nextLight = hitsSelected ? hits.get((hits.indexOf(selected) + 1) % hits.size()) : null;
        startLight = hitsSelected ? selected : hits.getFirst();
        lightDrag = dragKind;
        gesture = new Object();
        selection.selectLight(startLight.name());
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
            editor.editOrReport(
                    scene -> NodeEdits.setPlacement(scene, draggedGizmo.node().name(),
                            _ -> draggedGizmo.drag(draggedHandle, view, canvas, from, to)),
                    gesture);
        } else if (startLight != null) {
            PreviewCamera view = camera.get();
            Light moved = lightDrag.apply(startLight, view, canvas, right, -down);
            editor.editOrReport(scene -> LightEdits.edit(scene, startLight.name(), _ -> moved), gesture);
        }
    }

    private void dragCamera(double right, double down) {
        if (cameraDrag == null && Math.hypot(right, down) >= DECISION_DISTANCE) {
            cameraDrag = CameraDrag.of(canvas, pressX, pressY, right, down);
        }
        if (cameraDrag != null) {
            camera.set(cameraDrag.apply(startCamera, canvas, right, down));
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
