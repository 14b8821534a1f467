package lightning.editor.window.model;

import java.util.List;
import javafx.scene.canvas.GraphicsContext;
import javafx.scene.paint.Color;
import lightning.editor.document.LightGizmo;
import lightning.editor.document.NodeGizmo;
import lightning.editor.document.PreviewCamera;
import lightning.editor.document.Viewport;

/** How gizmos look over either picture: their colours, and thin lines with a dark edge, so that they are seen before bright surfaces too. */
public final class GizmoPaint {
    public static final Color SELECTED = Color.web("#FFD60A");
    /** Of lights that are not selected, and shine. */
    public static final Color PLAIN = Color.web("#E8EAF0");
    /** Of lights that are not selected, and do not shine. */
    public static final Color DARK = Color.web("#E8EAF0", 0.4);
    public static final Color EDGE = Color.gray(0, 0.65);
    /** Of line and edge together, pixels. */
    public static final double EDGE_LINE = 3;
    private static final List<Color> AXES = List.of(Color.web("#FF6B5E"), Color.web("#7ADB5C"), Color.web("#5CA8FF"));
    private static final double LINE = 1.25;
    private static final double HANDLE_LINE = 2 * LINE;

    private GizmoPaint() {}

    /** A light's wireframe, or those of several. */
    public static void wires(GraphicsContext g, List<LightGizmo.Stroke> strokes, Color color) {
        lines(g, strokes, color, LINE, EDGE_LINE);
    }

    /** What is dragged beside a light or a shape, as thick as their handles. */
    public static void mark(GraphicsContext g, List<LightGizmo.Stroke> strokes) {
        lines(g, strokes, SELECTED, HANDLE_LINE, EDGE_LINE);
    }

    /**
     * All handles of a shape or a group.
     *
     * @param edge of line and edge together, pixels
     */
    public static void handles(GraphicsContext g, NodeGizmo gizmo, PreviewCamera camera, Viewport canvas, double edge) {
        gizmo.handles().forEach(handle -> lines(g, NodeGizmo.strokes(handle, camera, canvas), color(handle), HANDLE_LINE, edge));
    }

    /** Red, green and blue for x, y and z, as the axes have everywhere. */
    private static Color color(NodeGizmo.Handle handle) {
        return switch (handle.act()) {
            case MOVE, TURN -> AXES.get(handle.axis());
            case SCALE, FREE -> SELECTED;
        };
    }

    private static void lines(GraphicsContext g, List<LightGizmo.Stroke> strokes, Color color, double width, double edge) {
        g.beginPath();
        for (LightGizmo.Stroke s : strokes) {
            g.moveTo(s.from().x(), s.from().y());
            g.lineTo(s.to().x(), s.to().y());
        }
        g.setStroke(EDGE);
        g.setLineWidth(edge);
        g.stroke();
        g.setStroke(color);
        g.setLineWidth(width);
        g.stroke();
    }
}
