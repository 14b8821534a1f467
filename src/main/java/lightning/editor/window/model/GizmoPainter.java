package lightning.editor.window.model;

import java.util.List;
import javafx.scene.canvas.GraphicsContext;
import javafx.scene.paint.Color;
import lightning.document.manipulation.LightGizmo;
import lightning.document.manipulation.NodeGizmo;
import lightning.document.manipulation.PreviewCamera;
import lightning.document.manipulation.Viewport;

/**
 * Paints gizmos over the preview and the traced picture. Lines are thin with a dark outline, so that they stay visible on bright surfaces.
 */
public final class GizmoPainter {
    public static final Color SELECTED = Color.web("#FFD60A");
    /** Color of unselected lights that are on. */
    public static final Color UNSELECTED = Color.web("#E8EAF0");
    /** Color of unselected lights that are off. */
    public static final Color UNLIT = Color.web("#E8EAF0", 0.4);
    public static final Color OUTLINE = Color.gray(0, 0.65);
    /** Width of a line and its outline together, pixels. */
    public static final double OUTLINE_WIDTH = 3;
    private static final List<Color> AXES = List.of(Color.web("#FF6B5E"), Color.web("#7ADB5C"), Color.web("#5CA8FF"));
    private static final double LINE_WIDTH = 1.25;
    private static final double HANDLE_WIDTH = 2 * LINE_WIDTH;

    private GizmoPainter() {}

    /** Draws the wireframes of one or more lights. */
    public static void drawWireframe(GraphicsContext g, List<LightGizmo.Stroke> strokes, Color color) {
        drawLines(g, strokes, color, LINE_WIDTH, OUTLINE_WIDTH);
    }

    /** Draws a drag handle of a light or a shape, as thick as node handles. */
    public static void drawMark(GraphicsContext g, List<LightGizmo.Stroke> strokes) {
        drawLines(g, strokes, SELECTED, HANDLE_WIDTH, OUTLINE_WIDTH);
    }

    /**
     * Draws all handles of a shape or a group.
     *
     * @param outlineWidth  width of a line and its outline together, pixels
     */
    public static void drawHandles(GraphicsContext g, NodeGizmo gizmo, PreviewCamera camera, Viewport canvas, double outlineWidth) {
        gizmo.handles()
                .forEach(handle -> drawLines(g, NodeGizmo.strokes(handle, camera, canvas), color(handle), HANDLE_WIDTH, outlineWidth));
    }

    /** Returns the color of a handle. */
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
