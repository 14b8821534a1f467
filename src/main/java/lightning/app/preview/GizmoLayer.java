package lightning.app.preview;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javafx.scene.canvas.Canvas;
import javafx.scene.canvas.GraphicsContext;
import javafx.scene.layout.Pane;
import javafx.scene.paint.Color;
import javafx.scene.shape.StrokeLineCap;
import lightning.edit.LightGizmo;
import lightning.edit.NodeGizmo;
import lightning.edit.PreviewCamera;
import lightning.edit.Viewport;
import lightning.scene.Light;
import lightning.scene.Scene;

/**
 * The lights' wireframes over the preview (paper §3.2): yellow the selected one, faint those that do not shine. The selected
 * light, which is the one that is edited, has a canvas of its own; that of the others is drawn again only where one of them or
 * the view is another.
 */
final class GizmoLayer extends Pane {
    static final Color SELECTED = Color.web("#FFD60A");
    private static final Color PLAIN = Color.web("#E8EAF0");
    private static final Color DARK = Color.web("#E8EAF0", 0.4);
    private static final Color EDGE = Color.gray(0, 0.65);
    private static final List<Color> AXES = List.of(Color.web("#FF6B5E"), Color.web("#7ADB5C"), Color.web("#5CA8FF"));
    private static final double LINE = 1.25;
    private static final double EDGE_LINE = 3;
    private static final double DOT = 4;
    /** The sides of the arrow at the border, pixels, and half the angle of its tip, radians. */
    private static final double ARROW = 15;
    private static final double SPREAD = Math.toRadians(26);

    private final Canvas others = new Canvas();
    private final Canvas selected = new Canvas();
    private View seen;
    private List<Light> shining = List.of();
    private List<Light> dark = List.of();
    private int gizmosDrawn;

    /** @param size what multiplies the wireframes' normal size; the markers at the border stay as they are */
    private record View(PreviewCamera camera, Viewport canvas, double size) {}

    GizmoLayer() {
        setMouseTransparent(true);
        getChildren().addAll(others, selected);
    }

    /** @param size what multiplies the wireframes' normal size; the markers at the border stay as they are */
    void draw(Scene scene, Light chosen, PreviewCamera camera, Viewport canvas, double size) {
        View view = new View(camera, canvas, size);
        List<Light> shiningNow = new ArrayList<>();
        List<Light> darkNow = new ArrayList<>();
        for (Light light : scene.lights()) {
            if (!light.equals(chosen)) {
                (scene.shines(light) ? shiningNow : darkNow).add(light);
            }
        }
        if (!view.equals(seen) || !shiningNow.equals(shining) || !darkNow.equals(dark)) {
            GraphicsContext g = clear(others, canvas);
            draw(g, shiningNow, PLAIN, view);
            draw(g, darkNow, DARK, view);
            seen = view;
            shining = shiningNow;
            dark = darkNow;
        }
        draw(clear(selected, canvas), chosen == null ? List.of() : List.of(chosen), SELECTED, view);
    }

    /** The handles of the selected shape, where there are any, over all else; the lights were drawn in the same view. */
    void draw(Optional<NodeGizmo> handles, PreviewCamera camera) {
        GraphicsContext g = selected.getGraphicsContext2D();
        handles.ifPresent(gizmo -> gizmo.handles().forEach(handle -> {
            List<LightGizmo.Stroke> strokes = NodeGizmo.strokes(handle, camera, seen.canvas());
            lines(g, strokes, EDGE, EDGE_LINE + 1);
            lines(g, strokes, color(handle), 2 * LINE);
        }));
    }

    /** Red, green and blue for x, y and z, as the axes have everywhere. */
    private static Color color(NodeGizmo.Handle handle) {
        return switch (handle.act()) {
            case MOVE, TURN -> AXES.get(handle.axis());
            case SCALE, FREE -> SELECTED;
        };
    }

    private static GraphicsContext clear(Canvas canvas, Viewport size) {
        canvas.setWidth(size.width());
        canvas.setHeight(size.height());
        GraphicsContext g = canvas.getGraphicsContext2D();
        g.clearRect(0, 0, size.width(), size.height());
        g.setLineCap(StrokeLineCap.ROUND);
        return g;
    }

    /** How many gizmos were drawn since the start. */
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
                dots.add(view.canvas().pixel(view.camera(), light.position()));
            }
        }
        // A dark edge first, so that the wires are seen before bright surfaces too.
        lines(g, strokes, EDGE, EDGE_LINE);
        lines(g, strokes, color, LINE);
        g.setFill(color);
        for (Viewport.Pixel at : dots) {
            g.fillOval(at.x() - DOT / 2, at.y() - DOT / 2, DOT, DOT);
        }
        for (LightMarker marker : LightMarker.of(lights, view.camera(), view.canvas())) {
            arrow(g, marker, color);
        }
    }

    private static void arrow(GraphicsContext g, LightMarker marker, Color color) {
        double[] x = new double[3];
        double[] y = new double[3];
        for (int i = 0; i < 3; i++) {
            double length = i == 0 ? 0 : ARROW;
            double angle = marker.angle() + (i == 1 ? SPREAD : -SPREAD);
            x[i] = marker.at().x() - length * Math.cos(angle);
            y[i] = marker.at().y() - length * Math.sin(angle);
        }
        g.setStroke(EDGE);
        g.setLineWidth(EDGE_LINE);
        g.strokePolygon(x, y, 3);
        g.setFill(color);
        g.fillPolygon(x, y, 3);
    }

    private static void lines(GraphicsContext g, List<LightGizmo.Stroke> strokes, Color color, double width) {
        g.setStroke(color);
        g.setLineWidth(width);
        g.beginPath();
        for (LightGizmo.Stroke s : strokes) {
            g.moveTo(s.from().x(), s.from().y());
            g.lineTo(s.to().x(), s.to().y());
        }
        g.stroke();
    }
}
