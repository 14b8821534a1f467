package lightning.editor.document;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import lightning.base.math.Vec3;
import lightning.scene.Light;

/**
 * The wireframe that stands for a light in the preview (paper §3.2): a sphere for a point light, a short fat cone for a
 * spot, whose opening follows its angle, a long thin cone for a directional light. About the same size on the screen at
 * every distance. A light that is larger than a point shows its outline besides, as large as it is, and a surface an arrow to where
 * it shines.
 *
 * @param light the light
 * @param lines in the scene
 */
public record LightGizmo(Light light, List<Line> lines) {
    /** The sphere's radius, pixels. */
    private static final double RADIUS = 12;
    private static final double SPOT_LENGTH = 26;
    private static final double LONG_LENGTH = 48;
    private static final double THIN_RADIUS = 5;
    private static final int SIDES = 24;
    private static final int RIBS = 8;
    private static final double[] COSINES = new double[SIDES];
    private static final double[] SINES = new double[SIDES];
    /** What is nearer to the eye than this share of the viewing distance is not drawn. */
    private static final double NEAR = 1e-3;

    static {
        for (int i = 0; i < SIDES; i++) {
            COSINES[i] = Math.cos(2 * Math.PI * i / SIDES);
            SINES[i] = Math.sin(2 * Math.PI * i / SIDES);
        }
    }

    public LightGizmo {
        lines = List.copyOf(lines);
    }

    /** A line from one point of the scene to another. */
    public record Line(Vec3 from, Vec3 to) {}

    /** A line on the canvas. */
    public record Stroke(Viewport.Pixel from, Viewport.Pixel to) {
        /** From a place to the nearest point of the line, pixels. */
        double distance(Viewport.Pixel p) {
            double dx = to.x() - from.x();
            double dy = to.y() - from.y();
            double square = dx * dx + dy * dy;
            double along = square == 0 ? 0 : ((p.x() - from.x()) * dx + (p.y() - from.y()) * dy) / square;
            double t = Math.clamp(along, 0, 1);
            return p.distance(new Viewport.Pixel(from.x() + t * dx, from.y() + t * dy));
        }
    }

    /**
     * The gizmo of a light as large as this view needs it.
     *
     * @param size &gt; 0, what multiplies the normal size
     */
    public static LightGizmo of(Light light, PreviewCamera view, Viewport canvas, double size) {
        double depth = Math.max(view.depth(light.position()), NEAR * view.distance());
        double pixel = size * view.pixelScale(depth, canvas.height());
        List<Line> lines = new ArrayList<>(sign(light, pixel));
        lines.addAll(outline(light));
        return new LightGizmo(light, lines);
    }

    private static List<Line> sign(Light light, double pixel) {
        return switch (light.type()) {
            case POINT -> sphere(light.position(), RADIUS * pixel);
            case SPOT -> {
                double half = Math.toRadians(light.angle());
                Vec3 axis = light.direction().normalized();
                Vec3 mouth = light.position().plus(axis.times(SPOT_LENGTH * pixel * Math.cos(half)));
                yield cone(light.position(), mouth, axis, SPOT_LENGTH * pixel * Math.sin(half));
            }
            case DIRECTIONAL -> {
                Vec3 axis = light.direction().normalized();
                // The tip leads, as an arrow's.
                yield cone(light.position().plus(axis.times(LONG_LENGTH * pixel)), light.position(), axis, THIN_RADIUS * pixel);
            }
            case RECT, DISC -> arrow(light.position(), light.direction().normalized(), SPOT_LENGTH * pixel);
        };
    }

    /** The border of what a light is, in its own size; of a directional light, which is nowhere, nothing. */
    private static List<Line> outline(Light light) {
        Vec3 axis = light.direction().normalized();
        double radius = light.area().radius();
        return switch (light.type()) {
            case DIRECTIONAL -> List.of();
            case POINT, SPOT -> radius > 0 ? sphere(light.position(), radius) : List.of();
            case DISC -> polygon(circle(light.position(), axis, radius));
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

    private static List<Line> arrow(Vec3 from, Vec3 axis, double length) {
        Vec3 tip = from.plus(axis.times(length));
        List<Line> lines = new ArrayList<>(List.of(new Line(from, tip)));
        List<Vec3> rim = circle(from.plus(axis.times(0.7 * length)), axis, 0.15 * length);
        for (int i = 0; i < SIDES; i += SIDES / 4) {
            lines.add(new Line(tip, rim.get(i)));
        }
        return lines;
    }

    private static List<Line> sphere(Vec3 center, double radius) {
        List<Line> lines = new ArrayList<>();
        for (Vec3 axis : List.of(new Vec3(1, 0, 0), Vec3.Y, new Vec3(0, 0, 1))) {
            lines.addAll(polygon(circle(center, axis, radius)));
        }
        return lines;
    }

    private static List<Line> cone(Vec3 tip, Vec3 base, Vec3 axis, double radius) {
        List<Vec3> rim = circle(base, axis, radius);
        List<Line> lines = polygon(rim);
        for (int i = 0; i < SIDES; i += SIDES / RIBS) {
            lines.add(new Line(tip, rim.get(i)));
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

    private static List<Line> polygon(List<Vec3> points) {
        List<Line> lines = new ArrayList<>();
        for (int i = 0; i < points.size(); i++) {
            lines.add(new Line(points.get(i), points.get((i + 1) % points.size())));
        }
        return lines;
    }

    /** The lines on the canvas; what lies behind the eye is cut off. */
    public List<Stroke> strokes(PreviewCamera view, Viewport canvas) {
        double near = NEAR * view.distance();
        List<Stroke> strokes = new ArrayList<>();
        for (Line line : lines) {
            double a = view.depth(line.from());
            double b = view.depth(line.to());
            if (a < near && b < near) {
                continue;
            }
            Vec3 cut = Math.min(a, b) < near
                    ? line.from().plus(line.to().minus(line.from()).times((near - a) / (b - a))) : null;
            strokes.add(new Stroke(canvas.pixel(view, a < near ? cut : line.from()), canvas.pixel(view, b < near ? cut : line.to())));
        }
        return strokes;
    }

    /**
     * From a place to the gizmo, pixels: to its nearest line or, where the light stands before the eye, to its position;
     * infinite where nothing of it is seen.
     */
    public double distance(PreviewCamera view, Viewport canvas, Viewport.Pixel place) {
        double least = view.depth(light.position()) < NEAR * view.distance() ? Double.POSITIVE_INFINITY
                : canvas.pixel(view, light.position()).distance(place);
        for (Stroke stroke : strokes(view, canvas)) {
            least = Math.min(least, stroke.distance(place));
        }
        return least;
    }

    /** The light whose gizmo is nearest to a place, at most {@code tolerance} pixels away; among equals the nearest to the eye. */
    public static Optional<Light> pick(List<Light> lights, PreviewCamera view, Viewport canvas, double size, Viewport.Pixel place,
            double tolerance) {
        Light best = null;
        double least = tolerance;
        for (Light light : lights) {
            double distance = of(light, view, canvas, size).distance(view, canvas, place);
            boolean nearer = distance < least || best == null && distance <= least
                    || best != null && distance == least && view.depth(light.position()) < view.depth(best.position());
            if (nearer) {
                best = light;
                least = distance;
            }
        }
        return Optional.ofNullable(best);
    }
}
