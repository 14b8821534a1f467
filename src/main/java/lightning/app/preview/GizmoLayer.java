package lightning.app.preview;

import javafx.scene.canvas.Canvas;
import javafx.scene.canvas.GraphicsContext;
import javafx.scene.paint.Color;
import javafx.scene.shape.StrokeLineCap;
import lightning.edit.LightGizmo;
import lightning.edit.PreviewCamera;
import lightning.edit.Viewport;
import lightning.scene.Light;
import lightning.scene.Scene;

/** The lights' wireframes over the preview (paper §3.2): yellow the selected one, faint those that do not shine. */
final class GizmoLayer extends Canvas {
    static final Color SELECTED = Color.web("#FFD60A");
    private static final Color PLAIN = Color.web("#E8EAF0");
    private static final Color DARK = Color.web("#E8EAF0", 0.4);
    private static final Color EDGE = Color.gray(0, 0.65);
    private static final double LINE = 1.25;
    private static final double EDGE_LINE = 3;
    private static final double DOT = 4;
    /** The sides of the arrow at the border, pixels, and half the angle of its tip, radians. */
    private static final double ARROW = 15;
    private static final double SPREAD = Math.toRadians(26);

    GizmoLayer() {
        setMouseTransparent(true);
    }

    /** @param size what multiplies the wireframes' normal size; the markers at the border stay as they are */
    void draw(Scene scene, Light selected, PreviewCamera camera, Viewport canvas, double size) {
        GraphicsContext g = getGraphicsContext2D();
        g.clearRect(0, 0, getWidth(), getHeight());
        g.setLineCap(StrokeLineCap.ROUND);
        for (Light light : scene.lights()) {
            if (!light.equals(selected)) {
                draw(g, light, scene.shines(light) ? PLAIN : DARK, camera, canvas, size);
            }
        }
        if (selected != null) {
            draw(g, selected, SELECTED, camera, canvas, size);
        }
        for (LightMarker marker : LightMarker.of(scene.lights(), camera, canvas)) {
            Light light = marker.light();
            arrow(g, marker, light.equals(selected) ? SELECTED : scene.shines(light) ? PLAIN : DARK);
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

    private static void draw(GraphicsContext g, Light light, Color color, PreviewCamera camera, Viewport canvas, double size) {
        var strokes = LightGizmo.of(light, camera, canvas, size).strokes(camera, canvas);
        // A dark edge first, so that the wires are seen before bright surfaces too.
        lines(g, strokes, EDGE, EDGE_LINE);
        lines(g, strokes, color, LINE);
        if (!strokes.isEmpty()) {
            Viewport.Pixel at = canvas.pixel(camera, light.position());
            g.setFill(color);
            g.fillOval(at.x() - DOT / 2, at.y() - DOT / 2, DOT, DOT);
        }
    }

    private static void lines(GraphicsContext g, Iterable<LightGizmo.Stroke> strokes, Color color, double width) {
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
