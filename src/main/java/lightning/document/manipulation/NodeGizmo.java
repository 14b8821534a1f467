package lightning.document.manipulation;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.scene.Scene;
import lightning.scene.Stage;
import lightning.scene.node.NodeGroup;
import lightning.scene.node.SceneNode;
import lightning.scene.value.Placement;

/**
 * Transform handles at the origin of a part of the scene in a picture: the selected shape or group, a flag, a filter or the box of the fog. It has an arrow and a ring per axis of its parent space, a
 * square for scale, and the origin. The handles are about equally large on the screen at every distance.
 *
 * @param part     part when the handles were created
 * @param origin   its origin in scene space
 * @param axes     unit directions of the parent's x, y and z in scene space
 * @param toParent maps directions from scene space to parent space
 * @param handles  handles, without those seen edge-on
 */
public record NodeGizmo(PlacedPart part, Vec3 origin, List<Vec3> axes, Transform toParent, List<Handle> handles) {
    /** Start of an arrow, in pixels from the origin. */
    private static final double ARROW_START = 14;
    private static final double ARROW = 84;
    private static final double TIP = 12;
    private static final double RING = 56;
    private static final double SIZE = 70;
    private static final double SQUARE = 5;
    private static final int SIDES = 48;
    /** Angle to the view direction below which a ring or an arrow is hidden as edge-on, in radians. */
    private static final double EDGE_ON = 0.12;
    private static final double NEAR_SHARE = 1e-3;
    private static final double SCALE_STEP = 0.1;

    /** Action of a handle. */
    public enum Action {
        MOVE,
        ROTATE,
        SCALE,
        /** Moves in the view plane. */
        MOVE_IN_VIEW
    }

    /**
     * Handle that can be dragged.
     *
     * @param axis  0, 1 or 2; ignored by actions without an axis
     * @param lines lines in the scene
     */
    public record Handle(Action action, int axis, List<LightGizmo.Segment> lines) {}

    /** Returns the handles of parts that are in front of the camera. */
    public static List<NodeGizmo> of(Scene scene, List<PlacedPart> parts, PreviewCamera view, Viewport canvas) {
        return parts.stream().flatMap(part -> of(scene, part, view, canvas).stream()).toList();
    }

    /** Returns the handles of a node; empty if it is behind the camera. */
    public static Optional<NodeGizmo> of(Scene scene, SceneNode node, PreviewCamera view, Viewport canvas) {
        return of(scene, new PlacedPart.OfNode(node), view, canvas);
    }

    private static Optional<NodeGizmo> of(Scene scene, PlacedPart part, PreviewCamera view, Viewport canvas) {
        Transform outer = Transform.IDENTITY;
        Transform toParent = Transform.IDENTITY;
        Stage stage = scene.stage();
        List<NodeGroup> groups = part instanceof PlacedPart.OfNode(SceneNode node) ? stage.enclosingGroups(node.name()) : List.of();
        for (NodeGroup group : groups) {
            outer = outer.times(group.placement().transform());
            toParent = group.placement().directionsToLocal().times(toParent);
        }
        Vec3 origin = outer.transformPoint(part.placement().position());
        if (view.depth(origin) < NEAR_SHARE * view.distance()) {
            return Optional.empty();
        }
        Transform linear = outer.linearPart();
        List<Vec3> axes = IntStream.range(0, 3).mapToObj(i -> linear.transformVector(unit(i)).normalized()).toList();
        double pixel = view.pixelScale(view.depth(origin), canvas.height());
        Vec3 viewDirection = origin.minus(view.camera().from()).normalized();
        List<Handle> handles = new ArrayList<>();
        for (int i = 0; i < 3; i++) {
            double cosine = Math.abs(viewDirection.dot(axes.get(i)));
            if (cosine < Math.cos(EDGE_ON)) {
                handles.add(new Handle(Action.MOVE, i, arrow(origin, axes.get(i), view, pixel)));
            }
            if (part.canRotate() && cosine > Math.sin(EDGE_ON)) {
                handles.add(new Handle(Action.ROTATE, i, ring(origin, axes.get(i), RING * pixel)));
            }
        }
        Vec3 corner = origin.plus(view.right().plus(view.up()).times(SIZE * pixel * Math.sqrt(0.5)));
        handles.add(new Handle(Action.SCALE, 0, square(corner, view, SQUARE * pixel)));
        handles.add(new Handle(Action.MOVE_IN_VIEW, 0, square(origin, view, SQUARE * pixel)));
        return Optional.of(new NodeGizmo(part, origin, axes, toParent, handles));
    }

    static Vec3 unit(int axis) {
        return new Vec3(axis == 0 ? 1 : 0, axis == 1 ? 1 : 0, axis == 2 ? 1 : 0);
    }

    private static List<LightGizmo.Segment> arrow(Vec3 origin, Vec3 axis, PreviewCamera view, double pixel) {
        Vec3 tip = origin.plus(axis.times(ARROW * pixel));
        Vec3 side = axis.cross(view.forward()).normalized().times(TIP * pixel / 2.5);
        Vec3 base = origin.plus(axis.times((ARROW - TIP) * pixel));
        return List.of(new LightGizmo.Segment(origin.plus(axis.times(ARROW_START * pixel)), tip),
                new LightGizmo.Segment(tip, base.plus(side)),
                new LightGizmo.Segment(tip, base.minus(side)), new LightGizmo.Segment(base.plus(side), base.minus(side)));
    }

    /** Returns two unit directions perpendicular to an axis and to each other, the second a quarter turn after the first. */
    private static Vec3 perpendicular(Vec3 axis) {
        Vec3 other = Math.abs(axis.y()) < 0.9 ? Vec3.Y : unit(0);
        return other.minus(axis.times(axis.dot(other))).normalized();
    }

    private static List<LightGizmo.Segment> ring(Vec3 origin, Vec3 axis, double radius) {
        Vec3 one = perpendicular(axis).times(radius);
        Vec3 two = axis.cross(one);
        List<LightGizmo.Segment> lines = new ArrayList<>();
        for (int i = 0; i < SIDES; i++) {
            lines.add(new LightGizmo.Segment(ringPoint(origin, one, two, i), ringPoint(origin, one, two, i + 1)));
        }
        return lines;
    }

    private static Vec3 ringPoint(Vec3 origin, Vec3 one, Vec3 two, int i) {
        double angle = 2 * Math.PI * i / SIDES;
        return origin.plus(one.times(Math.cos(angle))).plus(two.times(Math.sin(angle)));
    }

    private static List<LightGizmo.Segment> square(Vec3 at, PreviewCamera view, double half) {
        Vec3 x = view.right().times(half);
        Vec3 y = view.up().times(half);
        List<Vec3> corners = List.of(at.plus(x).plus(y), at.minus(x).plus(y), at.minus(x).minus(y), at.plus(x).minus(y));
        return IntStream.range(0, 4).mapToObj(i -> new LightGizmo.Segment(corners.get(i), corners.get((i + 1) % 4))).toList();
    }

    /** Returns the lines of a handle on the canvas. */
    public static List<LightGizmo.Stroke> strokes(Handle handle, PreviewCamera view, Viewport canvas) {
        double near = NEAR_SHARE * view.distance();
        return handle.lines().stream().filter(l -> view.depth(l.from()) > near && view.depth(l.to()) > near)
                .map(l -> new LightGizmo.Stroke(canvas.project(view, l.from()), canvas.project(view, l.to()))).toList();
    }

    /** Gizmo and its handle at a position. */
    public record Grip(NodeGizmo gizmo, Handle handle) {}

    /** Returns the handle nearest to a position, at most {@code tolerance} pixels away, of any of several gizmos. */
    public static Optional<Grip> pick(List<NodeGizmo> gizmos, PreviewCamera view, Viewport canvas, Viewport.Pixel point, double tolerance) {
        Grip best = null;
        for (NodeGizmo gizmo : gizmos) {
            Optional<Handle> handle = gizmo.pick(view, canvas, point, tolerance);
            if (handle.isPresent()
                    && (best == null || distance(handle.get(), view, canvas, point) < distance(best.handle, view, canvas, point))) {
                best = new Grip(gizmo, handle.get());
            }
        }
        return Optional.ofNullable(best);
    }

    private static double distance(Handle handle, PreviewCamera view, Viewport canvas, Viewport.Pixel point) {
        return strokes(handle, view, canvas).stream().mapToDouble(stroke -> stroke.distance(point)).min().orElse(Double.POSITIVE_INFINITY);
    }

    /** Returns the handle nearest to a position, at most {@code tolerance} pixels away; later handles are on top. */
    public Optional<Handle> pick(PreviewCamera view, Viewport canvas, Viewport.Pixel point, double tolerance) {
        Handle best = null;
        double minDistance = tolerance;
        for (Handle handle : handles) {
            for (LightGizmo.Stroke stroke : strokes(handle, view, canvas)) {
                double distance = stroke.distance(point);
                if (distance <= minDistance) {
                    minDistance = distance;
                    best = handle;
                }
            }
        }
        return Optional.ofNullable(best);
    }

    /**
     * Returns the placement after dragging a handle. It depends only on the node at the start and both ends of the movement, so that
     * returning to the start restores it.
     */
    public Placement drag(Handle handle, PreviewCamera view, Viewport canvas, Viewport.Pixel from, Viewport.Pixel to) {
        return drag(handle, view, canvas, from, to, false);
    }

    /**
     * Returns the placement after dragging a handle.
     *
     * @param isSnapping whether it moves, rotates and scales in round steps: see {@link Snapping}
     */
    public Placement drag(Handle handle, PreviewCamera view, Viewport canvas, Viewport.Pixel from, Viewport.Pixel to, boolean isSnapping) {
        Placement p = part.placement();
        return switch (handle.action()) {
            case MOVE -> {
                Vec3 axis = axes.get(handle.axis());
                double offset = axisCoordinate(axis, view, canvas, to) - axisCoordinate(axis, view, canvas, from);
                yield moved(axis.times(isSnapping ? Snapping.snapToStep(offset, Snapping.gridStep(origin, view, canvas)) : offset));
            }
            case MOVE_IN_VIEW -> {
                double pixel = view.pixelScale(view.depth(origin), canvas.height());
                Vec3 offset = view.right().times((to.x() - from.x()) * pixel).plus(view.up().times((from.y() - to.y()) * pixel));
                yield moved(isSnapping ? Snapping.snapToGrid(offset, Snapping.gridStep(origin, view, canvas)) : offset);
            }
            case ROTATE -> {
                double degrees = Math.toDegrees(ringAngle(handle.axis(), view, canvas, to) - ringAngle(handle.axis(), view, canvas, from));
                yield new Placement(p.position(),
                        EulerRotation.rotate(p.rotation(), handle.axis(),
                                isSnapping ? Snapping.snapToStep(degrees, Snapping.ANGLE_STEP) : degrees),
                        p.scale());
            }
            case SCALE -> {
                Viewport.Pixel center = canvas.project(view, origin);
                double factor = Math.rint(1e4 * to.distance(center) / Math.max(1, from.distance(center))) / 1e4;
                double rounded = isSnapping ? Math.max(Snapping.snapToStep(factor, SCALE_STEP), SCALE_STEP) : Math.max(factor, 1e-3);
                yield new Placement(p.position(), p.rotation(), p.scale().times(rounded));
            }
        };
    }

    private Placement moved(Vec3 offset) {
        Placement p = part.placement();
        return new Placement(p.position().plus(toParent.transformVector(offset)), p.rotation(), p.scale());
    }

    /** Returns the coordinate along an axis through the origin that is nearest to the view ray of a position. */
    private double axisCoordinate(Vec3 axis, PreviewCamera view, Viewport canvas, Viewport.Pixel point) {
        Vec3 viewDirection = canvas.direction(view, point.x(), point.y());
        Vec3 offset = view.camera().from().minus(origin);
        double cosine = axis.dot(viewDirection);
        return (offset.dot(axis) - offset.dot(viewDirection) * cosine) / Math.max(1 - cosine * cosine, EDGE_ON * EDGE_ON / 4);
    }

    /**
     * Returns the angle about an axis of a position's intersection with the ring's plane, from the next axis to the one after, in radians.
     */
    private double ringAngle(int axis, PreviewCamera view, Viewport canvas, Viewport.Pixel point) {
        Vec3 normal = axes.get(axis);
        Vec3 viewDirection = canvas.direction(view, point.x(), point.y());
        Vec3 offset = origin.minus(view.camera().from());
        Vec3 at = viewDirection.times(offset.dot(normal) / viewDirection.dot(normal)).minus(offset);
        Vec3 firstAxis = axes.get((axis + 1) % 3);
        Vec3 first = firstAxis.minus(normal.times(normal.dot(firstAxis))).normalized();
        Vec3 secondAxis = axes.get((axis + 2) % 3);
        Vec3 orthogonal = secondAxis.minus(normal.times(normal.dot(secondAxis)));
        Vec3 second = orthogonal.minus(first.times(first.dot(orthogonal))).normalized();
        return Math.atan2(at.dot(second), at.dot(first));
    }
}
