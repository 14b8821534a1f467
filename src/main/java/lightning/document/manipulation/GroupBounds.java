package lightning.document.manipulation;

import java.util.ArrayList;
import java.util.List;
import java.util.function.IntFunction;
import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.scene.Scene;
import lightning.scene.node.NodeBounds;
import lightning.scene.node.NodeGroup;
import lightning.scene.node.SceneNode;

/** Bounding box of a group, oriented along the group's axes, that marks a selected group. */
public final class GroupBounds {
    private static final double NEAR_SHARE = 1e-3;

    private List<SceneNode> measuredChildren = List.of();
    private NodeBounds box = NodeBounds.of(measuredChildren);

    /** Returns the box's twelve edges in the scene; none for an empty group. Measures the group's content once. */
    public List<LightGizmo.Segment> lines(Scene scene, NodeGroup group) {
        if (group.children() != measuredChildren) {
            measuredChildren = group.children();
            box = NodeBounds.of(measuredChildren);
        }
        Transform toScene = Transform.IDENTITY;
        for (NodeGroup ancestor : scene.stage().enclosingGroups(group.name())) {
            toScene = toScene.times(ancestor.placement().transform());
        }
        Transform transform = toScene.times(group.placement().transform());
        return box.isEmpty() ? List.of() : edges(corner -> transform.transformPoint(box.corner(corner)));
    }

    /**
     * Returns the twelve edges of a box.
     *
     * @param corners returns a corner by its bits: 1 for the end of x, 2 for that of y, 4 for that of z
     */
    static List<LightGizmo.Segment> edges(IntFunction<Vec3> corners) {
        List<LightGizmo.Segment> lines = new ArrayList<>();
        for (int corner = 0; corner < NodeBounds.CORNERS; corner++) {
            for (int axis = 0; axis < 3; axis++) {
                if ((corner >> axis & 1) == 0) {
                    lines.add(new LightGizmo.Segment(corners.apply(corner), corners.apply(corner | 1 << axis)));
                }
            }
        }
        return lines;
    }

    /** Returns the visible parts of these edges on the canvas, in front of the camera. */
    public static List<LightGizmo.Stroke> strokes(List<LightGizmo.Segment> lines, PreviewCamera view, Viewport canvas) {
        double near = NEAR_SHARE * view.distance();
        List<LightGizmo.Stroke> strokes = new ArrayList<>();
        for (LightGizmo.Segment line : lines) {
            if (view.depth(line.from()) > near || view.depth(line.to()) > near) {
                strokes.add(new LightGizmo.Stroke(canvas.project(view, clipToNear(line.from(), line.to(), view, near)),
                        canvas.project(view, clipToNear(line.to(), line.from(), view, near))));
            }
        }
        return strokes;
    }

    /** Returns the end of a line, clipped to the near plane. */
    private static Vec3 clipToNear(Vec3 end, Vec3 other, PreviewCamera view, double near) {
        double depth = view.depth(end);
        return depth >= near ? end : end.plus(other.minus(end).times((near - depth) / (view.depth(other) - depth)));
    }
}
