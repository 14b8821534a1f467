package lightning.editor.window.traced;

import static java.util.Objects.requireNonNull;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javafx.geometry.Bounds;
import javafx.scene.canvas.Canvas;
import javafx.scene.canvas.GraphicsContext;
import javafx.scene.input.MouseButton;
import javafx.scene.input.MouseEvent;
import javafx.scene.layout.Pane;
import javafx.scene.shape.Rectangle;
import lightning.base.text.Messages;
import lightning.document.EditOutcome;
import lightning.document.LightEdits;
import lightning.document.manipulation.DragRounding;
import lightning.document.manipulation.LightDrag;
import lightning.document.manipulation.LightGizmo;
import lightning.document.manipulation.NodeGizmo;
import lightning.document.manipulation.PlacedPart;
import lightning.document.manipulation.PreviewCamera;
import lightning.document.manipulation.Snapping;
import lightning.document.manipulation.Viewport;
import lightning.editor.window.model.GizmoMouseBinding;
import lightning.editor.window.model.GizmoPainter;
import lightning.editor.window.model.PreviewSettings;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.widget.PictureView;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.value.Placement;
import org.jspecify.annotations.Nullable;

/**
 * Wireframe of the selected light, or handles of the selected shape, over the traced picture while the mouse is over it. Draggable as in
 * the preview. G hides them in both views.
 */
final class TracedGizmo extends Pane {
    private static final int RING_SIDES = 48;
    static final double TOLERANCE = 8;

    private final SceneEditor editor;
    private final PreviewSettings settings;
    private final PictureView picture;
    private final LightPlacer placer;
    private final Canvas canvas = new Canvas();
    private @Nullable Drag drag;

    /** Target of a drag. */
    private sealed interface DragTarget {}

    private record LightTarget(Light startLight, LightDrag lightDrag) implements DragTarget {}

    private record HandleTarget(NodeGizmo gizmo, NodeGizmo.Handle handle) implements DragTarget {}

    /**
     * Drag in progress.
     *
     * @param start position of the press on the canvas of the whole picture
     */
    private record Drag(DragTarget target, Viewport.Pixel start) {}

    /**
     * Creates the overlay.
     *
     * @param settings visibility and size of the light handles
     */
    TracedGizmo(SceneEditor editor, PreviewSettings settings, PictureView picture, LightPlacer placer) {
        this.editor = editor;
        this.settings = settings;
        this.placer = placer;
        this.picture = picture;
        setId("traced-gizmo");
        setMouseTransparent(true);
        var clip = new Rectangle();
        clip.widthProperty().bind(widthProperty());
        clip.heightProperty().bind(heightProperty());
        setClip(clip);
        getChildren().add(canvas);
        editor.sceneProperty().subscribe(_ -> draw());
        editor.editorStateProperty().subscribe(_ -> draw());
        settings.gizmosHiddenProperty().subscribe(_ -> draw());
        settings.fogHandlesProperty().subscribe(_ -> draw());
        settings.gizmoSizeProperty().subscribe(_ -> draw());
        picture.pictureBoundsProperty().subscribe(_ -> draw());
        picture.hoverProperty().subscribe(_ -> draw());
    }

    /** Returns the size of the whole picture as displayed. */
    Viewport viewport() {
        Bounds bounds = picture.pictureBoundsProperty().getValue();
        return new Viewport(Math.max(1, bounds.getWidth()), Math.max(1, bounds.getHeight()));
    }

    private PreviewCamera view() {
        return PreviewCamera.of(editor.scene());
    }

    private boolean isEnabled() {
        return !picture.isEmpty() && !settings.gizmosHiddenProperty().get();
    }

    private Optional<LightGizmo> light() {
        return isEnabled() ? Optional.ofNullable(editor.selection().light())
                .filter(l -> l.type() != LightType.OBJECT)
                .map(l -> LightGizmo.of(l, view(), viewport(), settings.gizmoSizeProperty().get().factor())) : Optional.empty();
    }

    private List<NodeGizmo> handles() {
        return !isEnabled() ? List.of()
                : NodeGizmo.of(editor.scene(),
                        PlacedPart.of(editor.scene(), editor.selection().node().orElse(null), editor.selection().light(),
                                settings.fogHandlesProperty().get()),
                        view(), viewport());
    }

    /** Returns the mouse position on the canvas of the whole picture. */
    Viewport.Pixel toCanvas(MouseEvent e) {
        Bounds bounds = picture.pictureBoundsProperty().getValue();
        return new Viewport.Pixel(e.getX() - bounds.getMinX(), e.getY() - bounds.getMinY());
    }

    /** Starts a drag of the handle under the mouse. Returns false if there is none. */
    boolean press(MouseEvent e) {
        Viewport.Pixel point = toCanvas(e);
        Optional<DragTarget> target = e.getButton() != MouseButton.PRIMARY ? Optional.empty()
                : NodeGizmo.pick(handles(), view(), viewport(), point, TOLERANCE)
                        .map(grip -> new HandleTarget(grip.gizmo(), grip.handle()));
        if (target.isEmpty()) {
            target = light().filter(g -> g.distance(view(), viewport(), point) <= TOLERANCE)
                    .map(_ -> new LightTarget(requireNonNull(editor.selection().light()), GizmoMouseBinding.lightDrag(e)));
        }
        drag = target.map(t -> new Drag(t, point)).orElse(null);
        return drag != null;
    }

    /** Continues the drag. */
    void drag(MouseEvent e) {
        Viewport.Pixel point = toCanvas(e);
        switch (requireNonNull(drag).target()) {
            case HandleTarget(NodeGizmo gizmo, NodeGizmo.Handle handle) -> {
                PreviewCamera view = view();
                Viewport viewport = viewport();
                Viewport.Pixel from = drag.start();
                Placement placed =
                        DragRounding.round(gizmo, gizmo.drag(handle, view, viewport, from, point, e.isShiftDown()), view, viewport);
                if (editor.editOrReport(scene -> EditOutcome.of(() -> gizmo.part().place(scene, placed)), drag).isEmpty()) {
                    editor.message().show(Snapping.describe(gizmo.part().placement(), placed));
                }
            }
            case LightTarget(Light lightAtStart, LightDrag dragKind) -> {
                Light moved = dragKind.apply(lightAtStart, view(), viewport(), point.x() - drag.start().x(),
                        drag.start().y() - point.y());
                Optional<Snapping> snap =
                        e.isShiftDown() && !moved.equals(lightAtStart) ? Optional.of(Snapping.of(lightAtStart, moved, view(), viewport()))
                                : Optional.empty();
                Light snapped = snap.map(Snapping::light).orElseGet(() -> DragRounding.round(lightAtStart, moved, view(), viewport()));
                if (editor.editOrReport(scene -> LightEdits.edit(scene, lightAtStart.name(), _ -> snapped), drag).isEmpty()) {
                    editor.message().show(snap.map(s -> Messages.tr("Snapped: {0}", s.message()))
                            .orElseGet(() -> Snapping.describe(lightAtStart, snapped, view())));
                }
            }
        }
    }

    /** Returns true while a drag is in progress. */
    boolean isDragging() {
        return drag != null;
    }

    void release() {
        drag = null;
        draw();
    }

    /** Reverts the drag. */
    void cancelDrag() {
        switch (requireNonNull(drag).target()) {
            case HandleTarget(NodeGizmo gizmo, NodeGizmo.Handle _) -> editor
                    .edit(scene -> EditOutcome.of(() -> gizmo.part().place(scene, gizmo.part().placement())), drag);
            case LightTarget(Light lightAtStart, LightDrag _) ->
                    editor.edit(scene -> LightEdits.edit(scene, lightAtStart.name(), _ -> lightAtStart), drag);
        }
        release();
    }

    /** Redraws the overlay. Avoid needless calls: any change of a canvas redraws everything below it, even if the canvas stays empty. */
    void draw() {
        canvas.setVisible(picture.isHover() || drag != null || placer.isDragging());
        if (!canvas.isVisible()) {
            return;
        }
        canvas.setWidth(picture.getWidth());
        canvas.setHeight(picture.getHeight());
        GraphicsContext g = canvas.getGraphicsContext2D();
        g.clearRect(0, 0, canvas.getWidth(), canvas.getHeight());
        Bounds bounds = picture.pictureBoundsProperty().getValue();
        g.save();
        g.translate(bounds.getMinX(), bounds.getMinY());
        if (!picture.isEmpty()) {
            placer.ringMark(viewport()).ifPresent(mark -> drawRing(g, mark));
        }
        light().ifPresent(gizmo -> GizmoPainter.drawWireframe(g, gizmo.strokes(view(), viewport()), GizmoPainter.SELECTED));
        handles().forEach(gizmo -> GizmoPainter.drawHandles(g, gizmo, view(), viewport(), GizmoPainter.OUTLINE_WIDTH));
        g.restore();
    }

    /** Draws the ring around a placed light's point, and its distance. */
    private static void drawRing(GraphicsContext g, LightPlacer.RingMark mark) {
        List<LightGizmo.Stroke> strokes = new ArrayList<>();
        for (int i = 0; i < RING_SIDES; i++) {
            strokes.add(new LightGizmo.Stroke(ringPoint(mark.center(), i), ringPoint(mark.center(), i + 1)));
        }
        GizmoPainter.drawMark(g, strokes);
        double x = mark.center().x() + LightPlacer.RING_RADIUS + 6;
        double y = mark.center().y() + 4;
        g.setLineWidth(GizmoPainter.OUTLINE_WIDTH);
        g.setStroke(GizmoPainter.OUTLINE);
        g.strokeText(Snapping.numberText(mark.distance()), x, y);
        g.setFill(GizmoPainter.SELECTED);
        g.fillText(Snapping.numberText(mark.distance()), x, y);
    }

    private static Viewport.Pixel ringPoint(Viewport.Pixel middle, int i) {
        double angle = 2 * Math.PI * i / RING_SIDES;
        return new Viewport.Pixel(middle.x() + LightPlacer.RING_RADIUS * Math.cos(angle),
                middle.y() + LightPlacer.RING_RADIUS * Math.sin(angle));
    }
}
