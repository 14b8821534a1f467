package lightning.editor.window.preview;

import java.util.ArrayList;
import java.util.List;
import javafx.scene.canvas.Canvas;
import javafx.scene.canvas.GraphicsContext;
import javafx.scene.layout.Pane;
import javafx.scene.paint.Color;
import javafx.scene.shape.StrokeLineCap;
import lightning.base.math.Vec3;
import lightning.document.manipulation.FilterOutline;
import lightning.document.manipulation.GroupBounds;
import lightning.document.manipulation.LightGizmo;
import lightning.document.manipulation.NodeGizmo;
import lightning.document.manipulation.PreviewCamera;
import lightning.document.manipulation.Viewport;
import lightning.editor.window.model.GizmoPainter;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import lightning.scene.value.Fog;
import org.jspecify.annotations.Nullable;

/**
 * Wireframes of the lights over the preview (paper §3.2): yellow for the selected light, faint for lights that are off. The selected light
 * and the marks of the selected shape have a separate canvas. Each canvas is redrawn only if its content or the view changed, since a
 * change also redraws the preview below it.
 */
final class GizmoLayer extends Pane {
    private static final double HANDLE_EDGE = 4;
    private static final double DOT_SIZE = 4;
    /** Length of the sides of a border arrow, pixels. Half the angle of its tip is {@link #ARROW_HALF_ANGLE}, radians. */
    private static final double ARROW_LENGTH = 15;
    private static final double ARROW_HALF_ANGLE = Math.toRadians(26);

    private final Canvas others = new Canvas();
    private final Canvas selected = new Canvas();
    private @Nullable View drawnView;
    private @Nullable Fog drawnFog;
    private List<Light> shining = List.of();
    private List<Light> dark = List.of();
    private @Nullable SelectedDrawing drawnSelection;
    private int gizmosDrawn;

    /**
     * View in which the wireframes are drawn.
     *
     * @param size scale of the wireframes; the markers at the border are not scaled
     */
    private record View(PreviewCamera camera, Viewport canvas, double size) {}

    /**
     * Marks of a selected shape or group.
     *
     * @param box wireframe around a group
     * @param handles handles of a shape or group, or of what belongs to the light or the world, drawn on top
     */
    record Marks(List<LightGizmo.Stroke> box, List<NodeGizmo> handles) {
        static final Marks NONE = new Marks(List.of(), List.of());
    }

    /**
     * Content of the canvas of the selection.
     *
     * @param lines    wireframe of the selected light in scene space; empty if no light is selected
     * @param filters  outlines of its flag and filter
     * @param position position of the selected light; null if no light is selected
     */
    private record SelectedDrawing(View view, List<LightGizmo.Segment> lines, List<LightGizmo.Segment> filters, @Nullable Vec3 position,
            Marks marks) {}

    GizmoLayer() {
        setMouseTransparent(true);
        getChildren().addAll(others, selected);
    }

    /**
     * Redraws the canvases that changed.
     *
     * @param size scale of the wireframes; the markers at the border are not scaled
     */
    void draw(Scene scene, @Nullable Light selectedLight, Marks marks, PreviewCamera camera, Viewport canvas, double size) {
        View view = new View(camera, canvas, size);
        List<Light> shiningNow = new ArrayList<>();
        List<Light> darkNow = new ArrayList<>();
        for (Light light : LightGizmo.placed(scene.lights())) {
            if (!light.equals(selectedLight)) {
                (scene.isActive(light) ? shiningNow : darkNow).add(light);
            }
        }
        Fog fogNow = scene.world().fog();
        if (!view.equals(drawnView) || !fogNow.equals(drawnFog) || !shiningNow.equals(shining) || !darkNow.equals(dark)) {
            GraphicsContext g = clear(others, canvas);
            draw(g, shiningNow, GizmoPainter.UNSELECTED, view);
            draw(g, darkNow, GizmoPainter.UNLIT, view);
            GizmoPainter.drawWireframe(g, GroupBounds.strokes(FilterOutline.of(fogNow), camera, canvas), GizmoPainter.UNLIT);
            drawnFog = fogNow;
            drawnView = view;
            shining = shiningNow;
            dark = darkNow;
        }
        SelectedDrawing newSelection = selectedLight == null ? new SelectedDrawing(view, List.of(), List.of(), null, marks)
                : new SelectedDrawing(view, LightGizmo.of(selectedLight, camera, canvas, size).lines(),
                        FilterOutline.of(selectedLight), selectedLight.position(),
                        marks);
        if (!newSelection.equals(drawnSelection)) {
            GraphicsContext g = clear(selected, canvas);
            draw(g, selectedLight == null ? List.of() : LightGizmo.placed(List.of(selectedLight)), GizmoPainter.SELECTED, view);
            GizmoPainter.drawWireframe(g, GroupBounds.strokes(newSelection.filters(), camera, canvas), GizmoPainter.SELECTED);
            GizmoPainter.drawWireframe(g, marks.box(), GizmoPainter.SELECTED);
            marks.handles().forEach(gizmo -> GizmoPainter.drawHandles(g, gizmo, camera, canvas, HANDLE_EDGE));
            drawnSelection = newSelection;
        }
    }

    private static GraphicsContext clear(Canvas canvas, Viewport size) {
        canvas.setWidth(size.width());
        canvas.setHeight(size.height());
        GraphicsContext g = canvas.getGraphicsContext2D();
        g.clearRect(0, 0, size.width(), size.height());
        g.setLineCap(StrokeLineCap.ROUND);
        return g;
    }

    /** Returns the number of gizmos drawn since the start, for tests. */
    int gizmosDrawn() {
        return gizmosDrawn;
    }

    private void draw(GraphicsContext g, List<Light> lights, Color color, View view) {
        List<LightGizmo.Stroke> strokes = new ArrayList<>();
        List<Viewport.Pixel> dots = new ArrayList<>();
        for (Light light : lights) {
            gizmosDrawn++;
            int before = strokes.size();
            strokes.addAll(LightGizmo.of(light, view.camera(), view.canvas(), view.size()).strokes(view.camera(), view.canvas()));
            if (strokes.size() > before) {
                dots.add(view.canvas().project(view.camera(), light.position()));
            }
        }
        GizmoPainter.drawWireframe(g, strokes, color);
        g.setFill(color);
        for (Viewport.Pixel at : dots) {
            g.fillOval(at.x() - DOT_SIZE / 2, at.y() - DOT_SIZE / 2, DOT_SIZE, DOT_SIZE);
        }
        for (LightMarker marker : LightMarker.of(lights, view.camera(), view.canvas())) {
            drawArrow(g, marker, color);
        }
    }

    private static void drawArrow(GraphicsContext g, LightMarker marker, Color color) {
        double[] x = new double[3];
        double[] y = new double[3];
        for (int i = 0; i < 3; i++) {
            double length = i == 0 ? 0 : ARROW_LENGTH;
            double angle = marker.angle() + (i == 1 ? ARROW_HALF_ANGLE : -ARROW_HALF_ANGLE);
            x[i] = marker.tip().x() - length * Math.cos(angle);
            y[i] = marker.tip().y() - length * Math.sin(angle);
        }
        g.setStroke(GizmoPainter.OUTLINE);
        g.setLineWidth(GizmoPainter.OUTLINE_WIDTH);
        g.strokePolygon(x, y, 3);
        g.setFill(color);
        g.fillPolygon(x, y, 3);
    }
}
