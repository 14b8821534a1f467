package lightning.document.manipulation;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.base.text.DecimalNumber;
import lightning.base.text.Messages;
import lightning.scene.light.Light;
import lightning.scene.value.Placement;

/**
 * Snapping of a dragged light: positions to a grid, directions to angle steps, distances to two digits.
 *
 * @param light   snapped light
 * @param message snapped values, for the artist
 */
public record Snapping(Light light, String message) {
    /** Angle step, in degrees. */
    public static final double ANGLE_STEP = 15;
    /** Minimum spacing of the grid, in pixels. */
    private static final double GRID_PIXELS = 8;
    /** Horizontal length below which a direction has no azimuth. */
    private static final double UPRIGHT = 1e-9;

    /**
     * Snaps the result of dragging a light: its position if it moved, its direction if it turned, or in an orbit the offset from its
     * target.
     */
    public static Snapping of(Light start, Light dragged, PreviewCamera view, Viewport canvas) {
        boolean hasMoved = !start.position().equals(dragged.position());
        boolean hasTurned = !start.direction().equals(dragged.direction());
        if (hasMoved && hasTurned) {
            Vec3 target = LightManipulation.aimPoint(start, view);
            Vec3 offset = snapDirection(dragged.position().minus(target));
            return new Snapping(
                    dragged.withPosition(target.plus(offset)).withDirection(offset.normalized().times(-dragged.direction().length())),
                    angleText(offset));
        }
        if (hasTurned) {
            return ofDirection(dragged);
        }
        double step = gridStep(start.position(), view, canvas);
        Vec3 position = snapToGrid(dragged.position(), step);
        return new Snapping(dragged.withPosition(position),
                Messages.tr("at {0} {1} {2}, grid {3}", numberText(position.x()), numberText(position.y()), numberText(position.z()),
                        numberText(step)));
    }

    /** Snaps the direction of a light. */
    public static Snapping ofDirection(Light light) {
        Vec3 direction = snapDirection(light.direction());
        return new Snapping(light.withDirection(direction), angleText(direction));
    }

    /** Returns the grid step around a point for this view. */
    static double gridStep(Vec3 about, PreviewCamera view, Viewport canvas) {
        return roundStep(GRID_PIXELS * view.pixelScale(Math.max(view.depth(about), view.distance() / 100), canvas.height()));
    }

    /** Rounds each coordinate to a multiple of the step. */
    static Vec3 snapToGrid(Vec3 point, double step) {
        return new Vec3(snapToStep(point.x(), step), snapToStep(point.y(), step), snapToStep(point.z(), step));
    }

    /** Rounds to a multiple of the step. */
    static double snapToStep(double v, double step) {
        double count = Math.rint(v / step) + 0.0;
        // 3 · 0.1 is not 0.3, but 3 / 10 is.
        return step < 1 ? count / Math.rint(1 / step) : count * step;
    }

    /** Returns the smallest of 1, 2 and 5 times a power of ten that is at least {@code minStep} &gt; 0. */
    static double roundStep(double minStep) {
        double power = Math.pow(10, Math.floor(Math.log10(minStep)));
        for (double digit : new double[] {1, 2, 5}) {
            if (digit * power >= minStep) {
                return round(digit * power, 1);
            }
        }
        return round(10 * power, 1);
    }

    /** Rounds azimuth about y (from z towards x) and elevation to multiples of {@link #ANGLE_STEP}, keeping the length. */
    static Vec3 snapDirection(Vec3 v) {
        double elevation = snapToStep(elevation(v), ANGLE_STEP);
        double azimuth = Math.abs(elevation) == 90 ? 0 : snapToStep(azimuth(v), ANGLE_STEP);
        double cosElevation = Transform.cosDegrees(elevation);
        return new Vec3(cosElevation * Transform.sinDegrees(azimuth), Transform.sinDegrees(elevation),
                cosElevation * Transform.cosDegrees(azimuth))
                .times(v.length());
    }

    /** Describes a dragged light: its position, its distance from the point that it aims at, or its angles. */
    public static String describe(Light start, Light dragged, PreviewCamera view) {
        boolean hasMoved = !start.position().equals(dragged.position());
        boolean hasTurned = !start.direction().equals(dragged.direction());
        Vec3 offset = dragged.position().minus(LightManipulation.aimPoint(start, view));
        return !hasMoved && !hasTurned ? ""
                : !hasMoved ? angleText(dragged.direction())
                : Messages.tr("{0}, distance {1}", hasTurned ? angleText(offset) : positionText(dragged.position()),
                        numberText(offset.length()));
    }

    /** Describes a dragged object: what changed of its position, its rotation and its scale. */
    public static String describe(Placement start, Placement dragged) {
        return !start.position().equals(dragged.position()) ? positionText(dragged.position())
                : !start.rotation().equals(dragged.rotation()) ? vectorText(Messages.key("rotation {0}° {1}° {2}°"), dragged.rotation())
                : !start.scale().equals(dragged.scale()) ? vectorText(Messages.key("scale {0} {1} {2}"), dragged.scale()) : "";
    }

    private static String positionText(Vec3 position) {
        return vectorText(Messages.key("at {0} {1} {2}"), position);
    }

    private static String vectorText(String pattern, Vec3 v) {
        return Messages.tr(pattern, numberText(v.x()), numberText(v.y()), numberText(v.z()));
    }

    private static double elevation(Vec3 v) {
        return Math.toDegrees(Math.atan2(v.y(), Math.hypot(v.x(), v.z())));
    }

    private static double azimuth(Vec3 v) {
        return Math.hypot(v.x(), v.z()) <= UPRIGHT * v.length() ? 0 : Math.toDegrees(Math.atan2(v.x(), v.z()));
    }

    private static String angleText(Vec3 v) {
        return Messages.tr("azimuth {0}°, elevation {1}°", numberText(azimuth(v)), numberText(elevation(v)));
    }

    /** Rounds a distance &gt; 0 to two digits. */
    public static double snapDistance(double v) {
        return round(v, 2);
    }

    private static double round(double v, int digits) {
        return new BigDecimal(v).round(new MathContext(digits, RoundingMode.HALF_EVEN)).doubleValue();
    }

    /** Formats a number with four digits for the status line. */
    public static String numberText(double v) {
        return DecimalNumber.format(round(v, 4));
    }
}
