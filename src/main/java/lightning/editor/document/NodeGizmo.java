package lightning.editor.document;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.scene.Group;
import lightning.scene.Node;
import lightning.scene.Placement;
import lightning.scene.Scene;
import lightning.scene.Stage;

/**
 * The handles about the origin of the selected shape or group in the preview: an arrow along each axis of what it stands in, the scene
 * or its group, a ring about each, a square for its size and the origin itself. About the same size on the screen at every distance.
 *
 * @param node    as it was when the handles were made
 * @param origin  where its own origin is, in the scene
 * @param axes    unit directions of the scene along which x, y and z of its place count
 * @param back    maps directions of the scene to those that its place counts in
 * @param handles the parts; those that this view sees edge-on are left out
 */
public record NodeGizmo(Node node, Vec3 origin, List<Vec3> axes, Transform back, List<Handle> handles) {
    /** Pixels. */
    private static final double INNER = 14;
    private static final double ARROW = 84;
    private static final double TIP = 12;
    private static final double RING = 56;
    private static final double SIZE = 70;
    private static final double SQUARE = 5;
    private static final int SIDES = 48;
    /** A ring or an arrow is left out where its plane, or it itself, is within about this of the direction of the view, radians. */
    private static final double EDGE_ON = 0.12;
    private static final double NEAR = 1e-3;
    private static final double SCALE_STEP = 0.1;

    /** What a handle does. */
    public enum Act {
        MOVE,
        TURN,
        SCALE,
        /** Moves in the viewing plane. */
        FREE
    }

    /**
     * A part that can be taken.
     *
     * @param axis  0, 1 or 2; of no meaning where it does not act along or about an axis
     * @param lines in the scene
     */
    public record Handle(Act act, int axis, List<LightGizmo.Line> lines) {}

    /** The handles of a node of a scene; empty where it is behind the eye. */
    public static Optional<NodeGizmo> of(Scene scene, Node node, PreviewCamera view, Viewport canvas) {
        Transform outer = Transform.IDENTITY;
        Transform back = Transform.IDENTITY;
        Stage stage = scene.stage();
        for (Group group : stage.around(node.name())) {
            outer = outer.times(group.placement().transform());
            back = group.placement().directionsBack().times(back);
        }
        Vec3 origin = outer.point(node.placement().at());
        if (view.depth(origin) < NEAR * view.distance()) {
            return Optional.empty();
        }
        Transform linear = outer.linear();
        List<Vec3> axes = IntStream.range(0, 3).mapToObj(i -> linear.vector(unit(i)).normalized()).toList();
        double pixel = view.pixelScale(view.depth(origin), canvas.height());
        Vec3 sight = origin.minus(view.camera().from()).normalized();
        List<Handle> handles = new ArrayList<>();
        for (int i = 0; i < 3; i++) {
            double along = Math.abs(sight.dot(axes.get(i)));
            if (along < Math.cos(EDGE_ON)) {
                handles.add(new Handle(Act.MOVE, i, arrow(origin, axes.get(i), view, pixel)));
            }
            if (along > Math.sin(EDGE_ON)) {
                handles.add(new Handle(Act.TURN, i, ring(origin, axes.get(i), RING * pixel)));
            }
        }
        Vec3 corner = origin.plus(view.right().plus(view.up()).times(SIZE * pixel * Math.sqrt(0.5)));
        handles.add(new Handle(Act.SCALE, 0, square(corner, view, SQUARE * pixel)));
        handles.add(new Handle(Act.FREE, 0, square(origin, view, SQUARE * pixel)));
        return Optional.of(new NodeGizmo(node, origin, axes, back, handles));
    }

    static Vec3 unit(int axis) {
        return new Vec3(axis == 0 ? 1 : 0, axis == 1 ? 1 : 0, axis == 2 ? 1 : 0);
    }

    private static List<LightGizmo.Line> arrow(Vec3 origin, Vec3 axis, PreviewCamera view, double pixel) {
        Vec3 tip = origin.plus(axis.times(ARROW * pixel));
        Vec3 side = axis.cross(view.forward()).normalized().times(TIP * pixel / 2.5);
        Vec3 base = origin.plus(axis.times((ARROW - TIP) * pixel));
        return List.of(new LightGizmo.Line(origin.plus(axis.times(INNER * pixel)), tip), new LightGizmo.Line(tip, base.plus(side)),
                new LightGizmo.Line(tip, base.minus(side)), new LightGizmo.Line(base.plus(side), base.minus(side)));
    }

    /** Two unit directions at right angles to an axis and to each other, the second a quarter turn after the first. */
    private static Vec3 across(Vec3 axis) {
        Vec3 other = Math.abs(axis.y()) < 0.9 ? Vec3.Y : unit(0);
        return other.minus(axis.times(axis.dot(other))).normalized();
    }

    private static List<LightGizmo.Line> ring(Vec3 origin, Vec3 axis, double radius) {
        Vec3 one = across(axis).times(radius);
        Vec3 two = axis.cross(one);
        List<LightGizmo.Line> lines = new ArrayList<>();
        for (int i = 0; i < SIDES; i++) {
            lines.add(new LightGizmo.Line(on(origin, one, two, i), on(origin, one, two, i + 1)));
        }
        return lines;
    }

    private static Vec3 on(Vec3 origin, Vec3 one, Vec3 two, int i) {
        double angle = 2 * Math.PI * i / SIDES;
        return origin.plus(one.times(Math.cos(angle))).plus(two.times(Math.sin(angle)));
    }

    private static List<LightGizmo.Line> square(Vec3 at, PreviewCamera view, double half) {
        Vec3 x = view.right().times(half);
        Vec3 y = view.up().times(half);
        List<Vec3> corners = List.of(at.plus(x).plus(y), at.minus(x).plus(y), at.minus(x).minus(y), at.plus(x).minus(y));
        return IntStream.range(0, 4).mapToObj(i -> new LightGizmo.Line(corners.get(i), corners.get((i + 1) % 4))).toList();
    }

    /** The lines of a handle on the canvas. */
    public static List<LightGizmo.Stroke> strokes(Handle handle, PreviewCamera view, Viewport canvas) {
        double near = NEAR * view.distance();
        return handle.lines().stream().filter(l -> view.depth(l.from()) > near && view.depth(l.to()) > near)
                .map(l -> new LightGizmo.Stroke(canvas.pixel(view, l.from()), canvas.pixel(view, l.to()))).toList();
    }

    /** The handle nearest to a place, at most {@code tolerance} pixels away; the later ones lie over those before. */
    public Optional<Handle> pick(PreviewCamera view, Viewport canvas, Viewport.Pixel place, double tolerance) {
        Handle best = null;
        double least = tolerance;
        for (Handle handle : handles) {
            for (LightGizmo.Stroke stroke : strokes(handle, view, canvas)) {
                double distance = stroke.distance(place);
                if (distance <= least) {
                    least = distance;
                    best = handle;
                }
            }
        }
        return Optional.ofNullable(best);
    }

    /**
     * The placement after a drag of a handle. It follows from the node as the drag began and both ends of the way of the mouse, so that
     * a drag back to its begin restores it.
     */
    public Placement dragged(Handle handle, PreviewCamera view, Viewport canvas, Viewport.Pixel from, Viewport.Pixel to) {
        return dragged(handle, view, canvas, from, to, false);
    }

    /**
     * The same.
     *
     * @param snapped whether it moves, turns and scales in round steps: see {@link Snap}
     */
    public Placement dragged(Handle handle, PreviewCamera view, Viewport canvas, Viewport.Pixel from, Viewport.Pixel to, boolean snapped) {
        Placement p = node.placement();
        return switch (handle.act()) {
            case MOVE -> {
                Vec3 axis = axes.get(handle.axis());
                double way = along(axis, view, canvas, to) - along(axis, view, canvas, from);
                yield moved(axis.times(snapped ? Snap.whole(way, Snap.step(origin, view, canvas)) : way));
            }
            case FREE -> {
                double pixel = view.pixelScale(view.depth(origin), canvas.height());
                Vec3 way = view.right().times((to.x() - from.x()) * pixel).plus(view.up().times((from.y() - to.y()) * pixel));
                yield moved(snapped ? Snap.grid(way, Snap.step(origin, view, canvas)) : way);
            }
            case TURN -> {
                double turn = Math.toDegrees(angle(handle.axis(), view, canvas, to) - angle(handle.axis(), view, canvas, from));
                yield new Placement(p.at(), Turning.about(p.rotate(), handle.axis(), snapped ? Snap.whole(turn, Snap.TURN) : turn),
                        p.scale());
            }
            case SCALE -> {
                Viewport.Pixel middle = canvas.pixel(view, origin);
                double factor = Math.rint(1e4 * to.distance(middle) / Math.max(1, from.distance(middle))) / 1e4;
                double rounded = snapped ? Math.max(Snap.whole(factor, SCALE_STEP), SCALE_STEP) : Math.max(factor, 1e-3);
                yield new Placement(p.at(), p.rotate(), p.scale().times(rounded));
            }
        };
    }

    private Placement moved(Vec3 way) {
        return new Placement(node.placement().at().plus(back.vector(way)), node.placement().rotate(), node.placement().scale());
    }

    /** How far along an axis through the origin the point lies that comes nearest to what is under a place. */
    private double along(Vec3 axis, PreviewCamera view, Viewport canvas, Viewport.Pixel place) {
        Vec3 sight = canvas.direction(view, place.x(), place.y());
        Vec3 way = view.camera().from().minus(origin);
        double cosine = axis.dot(sight);
        return (way.dot(axis) - way.dot(sight) * cosine) / Math.max(1 - cosine * cosine, EDGE_ON * EDGE_ON / 4);
    }

    /** The angle about an axis, from the one after it to the one after that, of what is under a place in the plane of its ring; radians. */
    private double angle(int axis, PreviewCamera view, Viewport canvas, Viewport.Pixel place) {
        Vec3 normal = axes.get(axis);
        Vec3 sight = canvas.direction(view, place.x(), place.y());
        Vec3 way = origin.minus(view.camera().from());
        Vec3 at = sight.times(way.dot(normal) / sight.dot(normal)).minus(way);
        Vec3 one = axes.get((axis + 1) % 3);
        Vec3 first = one.minus(normal.times(normal.dot(one))).normalized();
        Vec3 two = axes.get((axis + 2) % 3);
        Vec3 straight = two.minus(normal.times(normal.dot(two)));
        Vec3 second = straight.minus(first.times(first.dot(straight))).normalized();
        return Math.atan2(at.dot(second), at.dot(first));
    }
}
