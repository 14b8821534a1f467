package lightning.document.manipulation;

import lightning.base.math.Vec3;
import lightning.scene.light.Light;
import lightning.scene.light.LightFlag;
import lightning.scene.value.Placement;

/**
 * Rounding of values that are set by dragging, so that a scene file stores no digits far below a pixel, as in
 * {@code 0.4999999999999742}. The rounded value is the edit; images of it are as exact as of any other.
 *
 * <p>A number that the drag leaves unchanged, up to half a step, keeps its value at the start.
 */
public final class DragRounding {
    /** Maximum step of a position, in pixels at its depth. */
    private static final double PIXELS = 1e-3;
    /** Step of directions and scales, relative to the largest number. */
    private static final double RELATIVE_STEP = 1e-6;
    private static final double DEGREES = 1e-4;
    /** Minimum depth for the size of a pixel, as a share of the viewing distance. */
    private static final double MIN_DEPTH_SHARE = 0.01;

    private DragRounding() {}

    /** Rounds the position and the direction of a dragged light and the place of its flag. */
    public static Light round(Light start, Light dragged, PreviewCamera view, Viewport canvas) {
        Vec3 position = round(dragged.position(), start.position(), positionStep(dragged.position(), view, canvas));
        Vec3 direction = round(dragged.direction(), start.direction(), relativeStep(dragged.direction()));
        Light moved = position.equals(dragged.position()) ? dragged : dragged.withPosition(position);
        Light turned = direction.equals(moved.direction()) ? moved : moved.withDirection(direction);
        LightFlag flag = dragged.flag();
        return flag.equals(start.flag()) ? turned
                : turned.withFlag(flag.withPosition(
                        round(flag.position(), start.flag().position(), positionStep(flag.position(), view, canvas)))
                        .withRotation(round(flag.rotation(), start.flag().rotation(), DEGREES))
                        .withWidth(round(flag.width(), start.flag().width(), positionStep(flag.position(), view, canvas)))
                        .withHeight(round(flag.height(), start.flag().height(), positionStep(flag.position(), view, canvas))));
    }

    /** Rounds the placement of a node that was dragged by its handles. */
    public static Placement round(NodeGizmo gizmo, Placement dragged, PreviewCamera view, Viewport canvas) {
        Placement start = gizmo.part().placement();
        double parentScale = gizmo.toParent().transformVector(view.right()).length();
        Vec3 position = round(dragged.position(), start.position(),
                powerOfTen(positionStep(gizmo.origin(), view, canvas) * parentScale));
        Vec3 rotation = round(dragged.rotation(), start.rotation(), DEGREES);
        return new Placement(position, rotation, round(dragged.scale(), start.scale(), relativeStep(dragged.scale())));
    }

    private static double positionStep(Vec3 position, PreviewCamera view, Viewport canvas) {
        double depth = Math.max(view.depth(position), MIN_DEPTH_SHARE * view.distance());
        return powerOfTen(PIXELS * view.pixelScale(depth, canvas.height()));
    }

    private static double relativeStep(Vec3 v) {
        return powerOfTen(RELATIVE_STEP * v.maxAbs());
    }

    /** Returns the largest power of ten that is at most a maximum. */
    private static double powerOfTen(double max) {
        return Math.pow(10, Math.floor(Math.log10(max)));
    }

    private static Vec3 round(Vec3 v, Vec3 start, double step) {
        return new Vec3(round(v.x(), start.x(), step), round(v.y(), start.y(), step), round(v.z(), start.z(), step));
    }

    private static double round(double v, double start, double step) {
        if (Math.abs(v - start) <= step / 2) {
            return start;
        }
        double rounded = Snapping.snapToStep(v, step);
        // A step outside the range of numbers, as for a view of size 0, leaves the value.
        return Double.isFinite(rounded) ? rounded : v;
    }
}
