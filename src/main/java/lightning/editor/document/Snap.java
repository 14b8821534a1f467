package lightning.editor.document;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.base.text.Decimal;
import lightning.base.text.Texts;
import lightning.scene.Light;

/**
 * Rounds what a drag makes of a light: places to a grid, directions to whole steps of angle, distances to two digits.
 *
 * @param light as it was rounded
 * @param told  what it was rounded to, for the artist
 */
public record Snap(Light light, String told) {
    /** Degrees. */
    public static final double TURN = 15;
    /** The grid's lines are at least so many pixels apart. */
    private static final double GRID_PIXELS = 8;
    /** A direction so near to upright has no azimuth. */
    private static final double UPRIGHT = 1e-9;

    /**
     * What a drag of its wireframe made of a light: where it moved, its place; where it turned, its direction; where both, as an orbit
     * does, the way from what it aims at.
     */
    public static Snap of(Light begin, Light dragged, PreviewCamera view, Viewport canvas) {
        boolean moved = !begin.position().equals(dragged.position());
        boolean turned = !begin.direction().equals(dragged.direction());
        if (moved && turned) {
            Vec3 target = LightManipulation.aim(begin, view);
            Vec3 way = direction(dragged.position().minus(target));
            return new Snap(dragged.withPosition(target.plus(way)).withDirection(way.normalized().times(-dragged.direction().length())),
                    angles(way));
        }
        if (turned) {
            return ofDirection(dragged);
        }
        double step = step(begin.position(), view, canvas);
        Vec3 at = grid(dragged.position(), step);
        return new Snap(dragged.withPosition(at),
                Texts.of("at {0} {1} {2}, grid {3}", number(at.x()), number(at.y()), number(at.z()), number(step)));
    }

    /** A light whose direction is rounded. */
    public static Snap ofDirection(Light light) {
        Vec3 way = direction(light.direction());
        return new Snap(light.withDirection(way), angles(way));
    }

    /** The step of the grid about a point, as large as this view needs it. */
    static double step(Vec3 about, PreviewCamera view, Viewport canvas) {
        return step(GRID_PIXELS * view.pixelScale(Math.max(view.depth(about), view.distance() / 100), canvas.height()));
    }

    /** The nearest whole number of steps, on each axis. */
    static Vec3 grid(Vec3 point, double step) {
        return new Vec3(whole(point.x(), step), whole(point.y(), step), whole(point.z(), step));
    }

    /** The nearest whole number of steps. */
    static double whole(double v, double step) {
        double count = Math.rint(v / step) + 0.0;
        // 3 · 0.1 is not 0.3, but 3 / 10 is.
        return step < 1 ? count / Math.rint(1 / step) : count * step;
    }

    /** The least of 1, 2 and 5 times a power of ten that is at least so much, &gt; 0. */
    static double step(double least) {
        double power = Math.pow(10, Math.floor(Math.log10(least)));
        for (double digit : new double[] {1, 2, 5}) {
            if (digit * power >= least) {
                return round(digit * power, 1);
            }
        }
        return round(10 * power, 1);
    }

    /** A direction of the same length whose azimuth about y, from z towards x, and elevation are multiples of {@link #TURN}. */
    static Vec3 direction(Vec3 v) {
        double elevation = whole(elevation(v), TURN);
        double azimuth = Math.abs(elevation) == 90 ? 0 : whole(azimuth(v), TURN);
        double level = Transform.cosDegrees(elevation);
        return new Vec3(level * Transform.sinDegrees(azimuth), Transform.sinDegrees(elevation), level * Transform.cosDegrees(azimuth))
                .times(v.length());
    }

    private static double elevation(Vec3 v) {
        return Math.toDegrees(Math.atan2(v.y(), Math.hypot(v.x(), v.z())));
    }

    private static double azimuth(Vec3 v) {
        return Math.hypot(v.x(), v.z()) <= UPRIGHT * v.length() ? 0 : Math.toDegrees(Math.atan2(v.x(), v.z()));
    }

    private static String angles(Vec3 v) {
        return Texts.of("azimuth {0}°, elevation {1}°", number(azimuth(v)), number(elevation(v)));
    }

    /** A distance, &gt; 0, in two digits. */
    public static double distance(double v) {
        return round(v, 2);
    }

    private static double round(double v, int digits) {
        return new BigDecimal(v).round(new MathContext(digits, RoundingMode.HALF_EVEN)).doubleValue();
    }

    /** A number as the status tells it, in four digits. */
    public static String number(double v) {
        return Decimal.text(round(v, 4));
    }
}
