package lightning.document.manipulation;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import lightning.base.math.Vec3;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;

/**
 * Wireframe of a light in the preview (paper §3.2), about equally large on the screen at every distance. Point lights are spheres. Spots
 * are short, wide cones whose opening follows their angle. Directional lights are long, thin cones. Area lights also show their true
 * outline and an arrow in their direction.
 *
 * @param light light of the wireframe
 * @param lines lines in the scene
 */
public record LightGizmo(Light light, List<Segment> lines) {
    /** Radius of the sphere, in pixels. */
    private static final double RADIUS = 12;
    private static final double SPOT_LENGTH = 26;
    private static final double DIRECTIONAL_LENGTH = 48;
    private static final double DIRECTIONAL_RADIUS = 5;
    private static final int SIDES = 24;
    private static final int RIBS = 8;
    private static final double[] COSINES = new double[SIDES];
    private static final double[] SINES = new double[SIDES];
    /** Near plane, as a share of the viewing distance. */
    private static final double NEAR_SHARE = 1e-3;

    static {
        for (int i = 0; i < SIDES; i++) {
            COSINES[i] = Math.cos(2 * Math.PI * i / SIDES);
            SINES[i] = Math.sin(2 * Math.PI * i / SIDES);
        }
    }

    public LightGizmo {
        lines = List.copyOf(lines);
    }

    /** Line between two points of the scene. */
    public record Segment(Vec3 from, Vec3 to) {}

    /** Line on the canvas. */
    public record Stroke(Viewport.Pixel from, Viewport.Pixel to) {
        /** Returns the distance from a position to the nearest point of the line, in pixels. */
        double distance(Viewport.Pixel p) {
            double dx = to.x() - from.x();
            double dy = to.y() - from.y();
            double lengthSquared = dx * dx + dy * dy;
            double along = lengthSquared == 0 ? 0 : ((p.x() - from.x()) * dx + (p.y() - from.y()) * dy) / lengthSquared;
            double t = Math.clamp(along, 0, 1);
            return p.distance(new Viewport.Pixel(from.x() + t * dx, from.y() + t * dy));
        }
    }

    /**
     * Creates the gizmo of a light at the size for this view.
     *
     * @param scale factor of the normal size, &gt; 0
     */
    public static LightGizmo of(Light light, PreviewCamera view, Viewport canvas, double scale) {
        double depth = Math.max(view.depth(light.position()), NEAR_SHARE * view.distance());
        double pixel = scale * view.pixelScale(depth, canvas.height());
        List<Segment> lines = new ArrayList<>(typeSymbol(light, pixel));
        lines.addAll(outline(light));
        return new LightGizmo(light, lines);
    }

    private static List<Segment> typeSymbol(Light light, double pixel) {
        return switch (light.type()) {
            case POINT -> sphere(light.position(), RADIUS * pixel);
            case SPOT -> {
                double halfAngle = Math.toRadians(light.angle());
                Vec3 axis = light.direction().normalized();
                Vec3 base = light.position().plus(axis.times(SPOT_LENGTH * pixel * Math.cos(halfAngle)));
                yield cone(light.position(), base, axis, SPOT_LENGTH * pixel * Math.sin(halfAngle));
            }
            case DIRECTIONAL -> {
                Vec3 axis = light.direction().normalized();
                // The tip points ahead, like an arrow.
                yield cone(light.position().plus(axis.times(DIRECTIONAL_LENGTH * pixel)), light.position(), axis,
                        DIRECTIONAL_RADIUS * pixel);
            }
            case TUBE -> sphere(light.position(), 0.4 * RADIUS * pixel);
            // The shape shows where it is.
            case OBJECT -> List.of();
            case RECT, DISC -> arrow(light.position(), light.direction().normalized(), SPOT_LENGTH * pixel);
        };
    }

    /** Returns the outline of an area light at its true size; empty for a directional light, which has no position. */
    private static List<Segment> outline(Light light) {
        Vec3 axis = light.direction().normalized();
        double radius = light.area().radius();
        return switch (light.type()) {
            case DIRECTIONAL, OBJECT -> List.of();
            case POINT, SPOT -> radius > 0 ? sphere(light.position(), radius) : List.of();
            case DISC -> polygon(circle(light.position(), axis, radius));
            case TUBE ->
                    radius > 0 || light.area().height() > 0 ? tube(light.position(), axis, light.area().height() / 2, radius) : List.of();
            case RECT -> {
                Vec3 right = light.area().right(axis);
                Vec3 half = right.times(light.area().width() / 2);
                Vec3 top = right.cross(axis).times(light.area().height() / 2);
                Vec3 at = light.position();
                yield polygon(List.of(at.plus(half).plus(top), at.minus(half).plus(top), at.minus(half).minus(top),
                        at.plus(half).minus(top)));
            }
        };
    }

    private static List<Segment> tube(Vec3 center, Vec3 axis, double half, double radius) {
        List<Vec3> bottom = circle(center.minus(axis.times(half)), axis, radius);
        List<Vec3> top = circle(center.plus(axis.times(half)), axis, radius);
        List<Segment> lines = new ArrayList<>(polygon(bottom));
        lines.addAll(polygon(top));
        for (int i = 0; i < SIDES; i += SIDES / 4) {
            lines.add(new Segment(bottom.get(i), top.get(i)));
        }
        return lines;
    }

    private static List<Segment> arrow(Vec3 from, Vec3 axis, double length) {
        Vec3 tip = from.plus(axis.times(length));
        List<Segment> lines = new ArrayList<>(List.of(new Segment(from, tip)));
        List<Vec3> rim = circle(from.plus(axis.times(0.7 * length)), axis, 0.15 * length);
        for (int i = 0; i < SIDES; i += SIDES / 4) {
            lines.add(new Segment(tip, rim.get(i)));
        }
        return lines;
    }

    private static List<Segment> sphere(Vec3 center, double radius) {
        List<Segment> lines = new ArrayList<>();
        for (Vec3 axis : List.of(new Vec3(1, 0, 0), Vec3.Y, new Vec3(0, 0, 1))) {
            lines.addAll(polygon(circle(center, axis, radius)));
        }
        return lines;
    }

    private static List<Segment> cone(Vec3 tip, Vec3 base, Vec3 axis, double radius) {
        List<Vec3> rim = circle(base, axis, radius);
        List<Segment> lines = polygon(rim);
        for (int i = 0; i < SIDES; i += SIDES / RIBS) {
            lines.add(new Segment(tip, rim.get(i)));
        }
        return lines;
    }

    private static List<Vec3> circle(Vec3 center, Vec3 axis, double radius) {
        Vec3 u = axis.cross(Math.abs(axis.x()) < 0.9 ? new Vec3(1, 0, 0) : Vec3.Y).normalized();
        Vec3 v = axis.cross(u);
        List<Vec3> points = new ArrayList<>();
        for (int i = 0; i < SIDES; i++) {
            points.add(center.plus(u.times(radius * COSINES[i])).plus(v.times(radius * SINES[i])));
        }
        return points;
    }

    static List<Segment> polygon(List<Vec3> points) {
        List<Segment> lines = new ArrayList<>();
        for (int i = 0; i < points.size(); i++) {
            lines.add(new Segment(points.get(i), points.get((i + 1) % points.size())));
        }
        return lines;
    }

    /** Returns the lines on the canvas, clipped to the near plane. */
    public List<Stroke> strokes(PreviewCamera view, Viewport canvas) {
        double near = NEAR_SHARE * view.distance();
        List<Stroke> strokes = new ArrayList<>();
        for (Segment line : lines) {
            double a = view.depth(line.from());
            double b = view.depth(line.to());
            if (a < near && b < near) {
                continue;
            }
            Vec3 clipped = Math.min(a, b) < near
                    ? line.from().plus(line.to().minus(line.from()).times((near - a) / (b - a))) : null;
            strokes.add(new Stroke(canvas.project(view, clipped != null && a < near ? clipped : line.from()),
                    canvas.project(view, clipped != null && b < near ? clipped : line.to())));
        }
        return strokes;
    }

    /**
     * Returns the distance from a position to the gizmo, in pixels: to its nearest line, or to the light's position if that is in front of
     * the camera. Infinite if nothing is visible.
     */
    public double distance(PreviewCamera view, Viewport canvas, Viewport.Pixel point) {
        double minDistance = view.depth(light.position()) < NEAR_SHARE * view.distance() ? Double.POSITIVE_INFINITY
                : canvas.project(view, light.position()).distance(point);
        for (Stroke stroke : strokes(view, canvas)) {
            minDistance = Math.min(minDistance, stroke.distance(point));
        }
        return minDistance;
    }

    /** Returns the lights that have a gizmo: all but those of objects, which have no place of their own. */
    public static List<Light> placed(List<Light> lights) {
        return lights.stream().filter(light -> light.type() != LightType.OBJECT).toList();
    }

    /**
     * Returns the light whose gizmo is nearest to a position, at most {@code tolerance} pixels away; among equals, the one nearest to the
     * camera.
     */
    public static Optional<Light> pick(List<Light> lights, PreviewCamera view, Viewport canvas, double size, Viewport.Pixel point,
            double tolerance) {
        Light best = null;
        double minDistance = tolerance;
        for (Light light : lights) {
            double distance = of(light, view, canvas, size).distance(view, canvas, point);
            boolean nearer = distance < minDistance || best == null && distance <= minDistance
                    || best != null && distance == minDistance && view.depth(light.position()) < view.depth(best.position());
            if (nearer) {
                best = light;
                minDistance = distance;
            }
        }
        return Optional.ofNullable(best);
    }
}
