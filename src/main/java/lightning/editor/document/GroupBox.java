package lightning.editor.document;

import java.util.ArrayList;
import java.util.List;
import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.scene.Group;
import lightning.scene.Node;
import lightning.scene.NodeBox;
import lightning.scene.Scene;

/** The box around all that a group holds, in the group's own directions: what marks it where it is selected. */
public final class GroupBox {
    private static final double NEAR = 1e-3;

    private List<Node> measured = List.of();
    private NodeBox box = NodeBox.of(measured);

    /** Its twelve edges in the scene; none where the group holds nothing. What is in the group is measured once. */
    public List<LightGizmo.Line> lines(Scene scene, Group group) {
        if (group.children() != measured) {
            measured = group.children();
            box = NodeBox.of(measured);
        }
        Transform toScene = Transform.IDENTITY;
        for (Group around : scene.stage().around(group.name())) {
            toScene = toScene.times(around.placement().transform());
        }
        return edges(toScene.times(group.placement().transform()));
    }

    private List<LightGizmo.Line> edges(Transform toScene) {
        List<LightGizmo.Line> lines = new ArrayList<>();
        for (int corner = 0; corner < NodeBox.CORNERS && !box.isEmpty(); corner++) {
            for (int axis = 0; axis < 3; axis++) {
                if ((corner >> axis & 1) == 0) {
                    lines.add(new LightGizmo.Line(toScene.point(box.corner(corner)), toScene.point(box.corner(corner | 1 << axis))));
                }
            }
        }
        return lines;
    }

    /** These edges on the canvas, as far as they are before the eye. */
    public static List<LightGizmo.Stroke> strokes(List<LightGizmo.Line> lines, PreviewCamera view, Viewport canvas) {
        double near = NEAR * view.distance();
        List<LightGizmo.Stroke> strokes = new ArrayList<>();
        for (LightGizmo.Line line : lines) {
            if (view.depth(line.from()) > near || view.depth(line.to()) > near) {
                strokes.add(new LightGizmo.Stroke(canvas.pixel(view, before(line.from(), line.to(), view, near)),
                        canvas.pixel(view, before(line.to(), line.from(), view, near))));
            }
        }
        return strokes;
    }

    /** An end of a line, or where the line comes before the eye. */
    private static Vec3 before(Vec3 end, Vec3 other, PreviewCamera view, double near) {
        double depth = view.depth(end);
        return depth >= near ? end : end.plus(other.minus(end).times((near - depth) / (view.depth(other) - depth)));
    }
}
