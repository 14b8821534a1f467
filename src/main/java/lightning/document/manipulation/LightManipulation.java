package lightning.document.manipulation;

import lightning.base.math.Vec3;
import lightning.base.math.VectorRotation;
import lightning.scene.light.Light;
import lightning.scene.value.SceneLimits;

/**
 * Light manipulation by dragging in the preview (paper §3.2). Each method takes the light at the start of the drag and the total mouse
 * movement since, so that returning to the start restores the light.
 *
 * <p>Positions stay within the limits of a scene: a step beyond them does not move the light.
 */
public final class LightManipulation {
    /** Rotation for a drag over the shorter side of the canvas, in radians. */
    private static final double TURN_PER_CANVAS = Math.PI;
    /** Minimum depth for moving a light at or behind the camera, as a share of the viewing distance. */
    private static final double MIN_DEPTH_SHARE = 0.01;

    private LightManipulation() {}

    /**
     * Rotates the light: the end that it points to follows the mouse, also if the light points to the camera. Point lights do not rotate.
     *
     * @param right pixels
     * @param up    pixels
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
     * Moves the light along the view direction; up is away. One pixel moves it by the length of a pixel at its distance.
     *
     * @param up pixels
     */
    public static Light dolly(Light light, PreviewCamera view, Viewport canvas, double up) {
        return moved(light, view.forward().times(up * scale(light, view, canvas)));
    }

    /**
     * Moves the light in the view plane, so that it stays under the mouse.
     *
     * @param right pixels
     * @param up    pixels
     */
    public static Light translate(Light light, PreviewCamera view, Viewport canvas, double right, double up) {
        double scale = scale(light, view, canvas);
        return moved(light, view.right().times(right * scale).plus(view.up().times(up * scale)));
    }

    /**
     * Orbits the light around its target at constant distance, keeping its aim. The target of a point light is the view's target. Any other
     * light orbits the point of its axis nearest to that.
     *
     * @param right pixels
     * @param up    pixels
     */
    public static Light orbit(Light light, PreviewCamera view, Viewport canvas, double right, double up) {
        Vec3 target = aimPoint(light, view);
        Vec3 offset = light.position().minus(target);
        double radiansPerPixel = TURN_PER_CANVAS / Math.min(canvas.width(), canvas.height());
        // The light follows the mouse both in front of and behind its target.
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

    /** Returns the target of a light: see {@link #orbit}. */
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
