package lightning.editor.window.model;

import java.util.List;
import javafx.scene.canvas.GraphicsContext;
import javafx.scene.paint.Color;
import lightning.editor.document.LightGizmo;
import lightning.editor.document.NodeGizmo;
import lightning.editor.document.PreviewCamera;
import lightning.editor.document.Viewport;

/** How gizmos look over either picture: their colors, and thin lines with a dark edge, so that they are seen before bright surfaces too. */
public final class GizmoPainter {
    public static final Color SELECTED = Color.web("#FFD60A");
    /** Of lights that are not selected, and shine. */
    public static final Color UNSELECTED = Color.web("#E8EAF0");
    /** Of lights that are not selected, and do not shine. */
    public static final Color UNLIT = Color.web("#E8EAF0", 0.4);
    public static final Color OUTLINE = Color.gray(0, 0.65);
    /** Of line and edge together, pixels. */
    public static final double OUTLINE_WIDTH = 3;
    private static final List<Color> AXES = List.of(Color.web("#FF6B5E"), Color.web("#7ADB5C"), Color.web("#5CA8FF"));
    private static final double LINE_WIDTH = 1.25;
    private static final double HANDLE_WIDTH = 2 * LINE_WIDTH;

    private GizmoPainter() {}

    /** A light's wireframe, or those of several. */
    public static void drawWireframe(GraphicsContext g, List<LightGizmo.Stroke> strokes, Color color) {
        drawLines(g, strokes, color, LINE_WIDTH, OUTLINE_WIDTH);
    }

    /** What is dragged beside a light or a shape, as thick as their handles. */
    public static void drawMark(GraphicsContext g, List<LightGizmo.Stroke> strokes) {
        drawLines(g, strokes, SELECTED, HANDLE_WIDTH, OUTLINE_WIDTH);
    }

    /**
     * All handles of a shape or a group.
     *
     * @param outlineWidth of line and edge together, pixels
     */
    public static void drawHandles(GraphicsContext g, NodeGizmo gizmo, PreviewCamera camera, Viewport canvas, double outlineWidth) {
        gizmo.handles()
                .forEach(handle -> drawLines(g, NodeGizmo.strokes(handle, camera, canvas), color(handle), HANDLE_WIDTH, outlineWidth));
    }

    /** Red, green and blue for x, y and z, as the axes have everywhere. */
    private static Color color(NodeGizmo.Handle handle) {
        return switch (handle.action()) {
            case MOVE, ROTATE -> AXES.get(handle.axis());
            case SCALE, MOVE_IN_VIEW -> SELECTED;
        };
    }

    private static void drawLines(GraphicsContext g, List<LightGizmo.Stroke> strokes, Color color, double width, double outlineWidth) {
        g.beginPath();
        for (LightGizmo.Stroke s : strokes) {
            g.moveTo(s.from().x(), s.from().y());
            g.lineTo(s.to().x(), s.to().y());
        }
        g.setStroke(OUTLINE);
        g.setLineWidth(outlineWidth);
        g.stroke();
        g.setStroke(color);
        g.setLineWidth(width);
        g.stroke();
    }
}
