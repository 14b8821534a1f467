package lightning.editor.document;

import lightning.base.math.Vec3;
import lightning.base.math.VectorRotation;
import lightning.scene.Light;
import lightning.scene.SceneLimits;

/**
 * What dragging a light in the preview does (paper §3.2). Each method takes the light as it was when the drag began and
 * the whole way of the mouse since, so that a drag back to its begin restores the light.
 *
 * <p>Positions stay within the limits of a scene: a step that would leave them leaves the light where it is.
 */
public final class LightManipulation {
    /** A drag over the shorter side of the canvas turns a light by this angle, radians. */
    private static final double TURN_PER_CANVAS = Math.PI;
    /** A light at the eye or behind it moves as if it were this share of the viewing distance before it. */
    private static final double MIN_DEPTH_SHARE = 0.01;

    private LightManipulation() {}

    /**
     * Turns the light: the end that it shines to goes with the mouse. A light that shines towards the eye turns so that
     * its beam goes with the mouse too. A point light does not turn.
     *
     * @param right pixels; likewise {@code up}
     */
    public static Light rotate(Light light, PreviewCamera view, Viewport canvas, double right, double up) {
        if (!light.type().hasDirection()) {
            return light;
        }
        double radiansPerPixel = TURN_PER_CANVAS / Math.min(canvas.width(), canvas.height());
        double sign = light.direction().dot(view.forward()) >= 0 ? 1 : -1;
        Vec3 yawed = VectorRotation.rotate(view.up(), -sign * right * radiansPerPixel, light.direction());
        return light.withDirection(VectorRotation.rotate(view.right(), sign * up * radiansPerPixel, yawed));
    }

    /**
     * Moves the light along the view: up is away. One pixel moves it by one pixel's length at its distance.
     *
     * @param up pixels
     */
    public static Light dolly(Light light, PreviewCamera view, Viewport canvas, double up) {
        return moved(light, view.forward().times(up * scale(light, view, canvas)));
    }

    /**
     * Moves the light in the viewing plane, so that it stays under the mouse.
     *
     * @param right pixels; likewise {@code up}
     */
    public static Light translate(Light light, PreviewCamera view, Viewport canvas, double right, double up) {
        double scale = scale(light, view, canvas);
        return moved(light, view.right().times(right * scale).plus(view.up().times(up * scale)));
    }

    /**
     * Carries the light about what it aims at, at the same distance, so that it aims there still: a point light about what the view looks at,
     * any other about the point of its axis that is nearest to that.
     *
     * @param right pixels; likewise {@code up}
     */
    public static Light orbit(Light light, PreviewCamera view, Viewport canvas, double right, double up) {
        Vec3 target = aimPoint(light, view);
        Vec3 offset = light.position().minus(target);
        double radiansPerPixel = TURN_PER_CANVAS / Math.min(canvas.width(), canvas.height());
        // The light goes with the mouse on this side of what it aims at, and on the other.
        double sign = offset.dot(view.forward()) <= 0 ? 1 : -1;
        Light orbited =
                light.withPosition(target.plus(rotated(offset, view, sign * right * radiansPerPixel, -sign * up * radiansPerPixel)));
        if (orbited.position().maxAbs() > SceneLimits.MAX_COORDINATE) {
            return light;
        }
        return light.type().hasDirection()
                ? orbited.withDirection(rotated(light.direction(), view, sign * right * radiansPerPixel, -sign * up * radiansPerPixel))
                : orbited;
    }

    private static Vec3 rotated(Vec3 v, PreviewCamera view, double aboutUp, double aboutRight) {
        return VectorRotation.rotate(view.right(), aboutRight, VectorRotation.rotate(view.up(), aboutUp, v));
    }

    /** What a light aims at: see {@link #orbit}. */
    static Vec3 aimPoint(Light light, PreviewCamera view) {
        Vec3 cameraTarget = view.camera().to();
        if (!light.type().hasDirection()) {
            return cameraTarget;
        }
        Vec3 axis = light.direction().normalized();
        double distance = cameraTarget.minus(light.position()).dot(axis);
        return light.position().plus(axis.times(distance > 0 ? distance : view.distance()));
    }

    private static double scale(Light light, PreviewCamera view, Viewport canvas) {
        double depth = Math.max(view.depth(light.position()), MIN_DEPTH_SHARE * view.distance());
        return view.pixelScale(depth, canvas.height());
    }

    private static Light moved(Light light, Vec3 step) {
        Vec3 position = light.position().plus(step);
        return position.maxAbs() <= SceneLimits.MAX_COORDINATE ? light.withPosition(position) : light;
    }
}
