package lightning.editor.window.traced;

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
import lightning.base.text.Texts;
import lightning.editor.document.LightDrag;
import lightning.editor.document.LightEdits;
import lightning.editor.document.LightGizmo;
import lightning.editor.document.NodeEdits;
import lightning.editor.document.NodeGizmo;
import lightning.editor.document.PreviewCamera;
import lightning.editor.document.Snap;
import lightning.editor.document.Viewport;
import lightning.editor.window.model.GizmoPaint;
import lightning.editor.window.model.Grip;
import lightning.editor.window.model.PreviewLook;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.widget.PictureView;
import lightning.scene.Light;

/**
 * The wireframe of the selected light, or the handles of the selected shape, over the traced picture while the mouse is there: taken and
 * dragged as in the preview. G hides them in both.
 */
final class TracedGizmo extends Pane {
    private static final int RING_SIDES = 48;
    static final double TOLERANCE = 8;

    private final SceneEditor editor;
    private final PreviewLook look;
    private final PictureView picture;
    private final LightPlacer placer;
    private final Canvas canvas = new Canvas();
    private Drag drag;

    /** What a press took. */
    private sealed interface Taken {}

    private record OfLight(Light begin, LightDrag by) implements Taken {}

    private record OfHandle(NodeGizmo gizmo, NodeGizmo.Handle handle) implements Taken {}

    /** @param from the place of the press, of the whole picture as it is shown */
    private record Drag(Taken taken, Viewport.Pixel from) {}

    /** @param look how large lights are drawn, and whether at all */
    TracedGizmo(SceneEditor editor, PreviewLook look, PictureView picture, LightPlacer placer) {
        this.editor = editor;
        this.look = look;
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
        editor.situationProperty().subscribe(_ -> draw());
        look.gizmosHiddenProperty().subscribe(_ -> draw());
        look.sizeProperty().subscribe(_ -> draw());
        picture.placeProperty().subscribe(_ -> draw());
        picture.hoverProperty().subscribe(_ -> draw());
    }

    /** The whole picture as it is shown. */
    Viewport viewport() {
        Bounds place = picture.placeProperty().getValue();
        return new Viewport(Math.max(1, place.getWidth()), Math.max(1, place.getHeight()));
    }

    private PreviewCamera view() {
        return PreviewCamera.of(editor.scene());
    }

    private boolean isThere() {
        return !picture.isEmpty() && !look.gizmosHiddenProperty().get();
    }

    private Optional<LightGizmo> light() {
        return isThere() ? Optional.ofNullable(editor.selection().light())
                .map(l -> LightGizmo.of(l, view(), viewport(), look.sizeProperty().get().factor())) : Optional.empty();
    }

    private Optional<NodeGizmo> handles() {
        return isThere() ? editor.selection().node().flatMap(n -> NodeGizmo.of(editor.scene(), n, view(), viewport())) : Optional.empty();
    }

    /** Where the mouse is in it. */
    Viewport.Pixel place(MouseEvent e) {
        Bounds place = picture.placeProperty().getValue();
        return new Viewport.Pixel(e.getX() - place.getMinX(), e.getY() - place.getMinY());
    }

    /** Takes what is under the mouse; returns whether there is something. */
    boolean press(MouseEvent e) {
        Viewport.Pixel at = place(e);
        Optional<NodeGizmo> gizmo = e.getButton() == MouseButton.PRIMARY ? handles() : Optional.empty();
        Optional<Taken> taken = gizmo.flatMap(g -> g.pick(view(), viewport(), at, TOLERANCE).map(h -> new OfHandle(g, h)));
        if (taken.isEmpty()) {
            taken = light().filter(g -> g.distance(view(), viewport(), at) <= TOLERANCE)
                    .map(_ -> new OfLight(editor.selection().light(), Grip.of(e)));
        }
        drag = taken.map(t -> new Drag(t, at)).orElse(null);
        return drag != null;
    }

    /** Drags what was taken. */
    void drag(MouseEvent e) {
        Viewport.Pixel to = place(e);
        switch (drag.taken()) {
            case OfHandle(NodeGizmo gizmo, NodeGizmo.Handle handle) -> {
                PreviewCamera view = view();
                Viewport shown = viewport();
                Viewport.Pixel from = drag.from();
                editor.editOrReport(scene -> NodeEdits.placement(scene, gizmo.node().name(),
                        _ -> gizmo.dragged(handle, view, shown, from, to, e.isShiftDown())), drag);
            }
            case OfLight(Light begin, LightDrag by) -> {
                Light moved = by.applied(begin, view(), viewport(), to.x() - drag.from().x(), drag.from().y() - to.y());
                Optional<Snap> snap = e.isShiftDown() && !moved.equals(begin) ? Optional.of(Snap.of(begin, moved, view(), viewport()))
                        : Optional.empty();
                Light snapped = snap.map(Snap::light).orElse(moved);
                if (editor.editOrReport(scene -> LightEdits.with(scene, begin.name(), _ -> snapped), drag).isEmpty()) {
                    snap.ifPresent(s -> editor.message().show(Texts.of("Snapped: {0}", s.told())));
                }
            }
        }
    }

    /** Whether something is dragged. */
    boolean isTaken() {
        return drag != null;
    }

    void release() {
        drag = null;
        draw();
    }

    /** Takes back what the drag did. */
    void giveUp() {
        switch (drag.taken()) {
            case OfHandle(NodeGizmo gizmo, NodeGizmo.Handle _) -> editor
                    .edit(scene -> NodeEdits.placement(scene, gizmo.node().name(), _ -> gizmo.node().placement()), drag);
            case OfLight(Light begin, LightDrag _) -> editor.edit(scene -> LightEdits.with(scene, begin.name(), _ -> begin), drag);
        }
        release();
    }

    /** Draws all anew. A canvas that is changed has the window draw all that lies under it again, even one that is empty before and after. */
    void draw() {
        canvas.setVisible(picture.isHover() || drag != null || placer.isDragging());
        if (!canvas.isVisible()) {
            return;
        }
        canvas.setWidth(picture.getWidth());
        canvas.setHeight(picture.getHeight());
        GraphicsContext g = canvas.getGraphicsContext2D();
        g.clearRect(0, 0, canvas.getWidth(), canvas.getHeight());
        Bounds place = picture.placeProperty().getValue();
        g.save();
        g.translate(place.getMinX(), place.getMinY());
        if (!picture.isEmpty()) {
            placer.mark(viewport()).ifPresent(mark -> ring(g, mark));
        }
        light().ifPresent(gizmo -> GizmoPaint.wires(g, gizmo.strokes(view(), viewport()), GizmoPaint.SELECTED));
        handles().ifPresent(gizmo -> GizmoPaint.handles(g, gizmo, view(), viewport(), GizmoPaint.EDGE_LINE));
        g.restore();
    }

    /** The ring about where a light was placed, and how far the light is from there. */
    private static void ring(GraphicsContext g, LightPlacer.Mark mark) {
        List<LightGizmo.Stroke> strokes = new ArrayList<>();
        for (int i = 0; i < RING_SIDES; i++) {
            strokes.add(new LightGizmo.Stroke(onRing(mark.middle(), i), onRing(mark.middle(), i + 1)));
        }
        GizmoPaint.mark(g, strokes);
        double x = mark.middle().x() + LightPlacer.RING + 6;
        double y = mark.middle().y() + 4;
        g.setLineWidth(GizmoPaint.EDGE_LINE);
        g.setStroke(GizmoPaint.EDGE);
        g.strokeText(Snap.number(mark.distance()), x, y);
        g.setFill(GizmoPaint.SELECTED);
        g.fillText(Snap.number(mark.distance()), x, y);
    }

    private static Viewport.Pixel onRing(Viewport.Pixel middle, int i) {
        double angle = 2 * Math.PI * i / RING_SIDES;
        return new Viewport.Pixel(middle.x() + LightPlacer.RING * Math.cos(angle), middle.y() + LightPlacer.RING * Math.sin(angle));
    }
}
