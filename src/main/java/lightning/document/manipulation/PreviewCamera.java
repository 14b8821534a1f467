package lightning.document.manipulation;

import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.base.math.VectorRotation;
import lightning.scene.Camera;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import lightning.scene.value.SceneLimits;

/** Camera of the preview (paper §3.6). It orbits its target and never affects the traced image. */
public final class PreviewCamera {
    /** Zoom of a drag over the whole canvas, as a power of e. */
    private static final double ZOOM_PER_CANVAS = 2;
    /** Rotation of a drag over the whole canvas, in radians. */
    private static final double TURN_PER_CANVAS = Math.PI;
    private static final double MIN_DISTANCE = 1e-4;
    /** Steepest view of an orbit, in radians from the horizon. */
    private static final double MAX_ELEVATION = Math.toRadians(89);
    private static final double MAX_DISTANCE = 1e9;
    private static final double MIN_LIGHT_FOV = 2;
    private static final double MAX_LIGHT_FOV = 150;

    /** Camera whose {@code up} is perpendicular to the view and of length 1. */
    private final Camera camera;
    private final Vec3 forward;
    private final Vec3 right;
    private final double sin;
    private final double cos;

    /** @param source camera whose up direction need not be perpendicular to the view */
    public PreviewCamera(Camera source) {
        forward = source.to().minus(source.from()).normalized();
        Vec3 side = forward.cross(source.up().normalized()).normalized();
        camera = new Camera(source.from(), source.to(), side.cross(forward).normalized(), source.fov(), source.shift());
        right = forward.cross(camera.up()).normalized();
        sin = Transform.sinDegrees(camera.fov() / 2);
        cos = Transform.cosDegrees(camera.fov() / 2);
    }

    public Camera camera() {
        return camera;
    }

    /** Returns the scene's own camera: button Camera. */
    public static PreviewCamera of(Scene scene) {
        return new PreviewCamera(scene.camera());
    }

    /** Returns a view along the x axis: button X. */
    public static PreviewCamera alongX(Scene scene) {
        return along(scene, new Vec3(1, 0, 0), Vec3.Y);
    }

    /** Returns a view from above, along the negative y axis, with −z up: button Top. */
    public static PreviewCamera alongMinusY(Scene scene) {
        return along(scene, new Vec3(0, -1, 0), new Vec3(0, 0, -1));
    }

    private static PreviewCamera along(Scene scene, Vec3 view, Vec3 up) {
        Camera sceneCamera = scene.camera();
        double distance = sceneCamera.to().minus(sceneCamera.from()).length();
        return new PreviewCamera(new Camera(sceneCamera.to().minus(view.times(distance)), sceneCamera.to(), up, sceneCamera.fov()));
    }

    /**
     * Returns the view from a light: from its position along its direction, with a spot's cone filling the image. A point light faces the
     * camera's target. A directional light is placed at the scene camera's distance from that target.
     */
    public static PreviewCamera throughLight(Light light, Scene scene) {
        Camera sceneCamera = scene.camera();
        double distance = sceneCamera.to().minus(sceneCamera.from()).length();
        Vec3 from = light.type().hasPosition() ? light.position()
                : sceneCamera.to().minus(light.direction().normalized().times(distance));
        Vec3 aim = light.type().hasDirection() ? light.direction() : sceneCamera.to().minus(from);
        Vec3 view = aim.maxAbs() >= MIN_DISTANCE ? aim.normalized() : new Vec3(0, 0, -1);
        double targetDistance = Math.max(sceneCamera.to().minus(from).dot(view), distance * MIN_DISTANCE);
        Vec3 up = Math.abs(view.y()) < 0.99 ? Vec3.Y : new Vec3(0, 0, -1);
        double fov = light.type().isSurface() ? MAX_LIGHT_FOV
                : light.type().hasCone() ? Math.clamp(2 * light.angle(), MIN_LIGHT_FOV, MAX_LIGHT_FOV) : sceneCamera.fov();
        return new PreviewCamera(new Camera(from, from.plus(view.times(targetDistance)), up, fov));
    }

    /** Returns the unit view direction. */
    public Vec3 forward() {
        return forward;
    }

    /** Returns the unit direction to the right in the image. */
    public Vec3 right() {
        return right;
    }

    /** Returns the unit direction up in the image. */
    public Vec3 up() {
        return camera.up();
    }

    /** Returns the distance from the camera to its target. */
    public double distance() {
        return camera.to().minus(camera.from()).length();
    }

    /** Returns the depth of a point along the view direction; negative behind the camera. */
    public double depth(Vec3 point) {
        return point.minus(camera.from()).dot(forward);
    }

    /**
     * Returns the length of one pixel at a depth, in scene units.
     *
     * @param depth  as {@link #depth}, &gt; 0
     * @param height height of the canvas, pixels
     */
    public double pixelScale(double depth, double height) {
        return 2 * depth * sin / cos / height;
    }

    /** Zooms in (drag up) or out (down), by a constant factor per distance. */
    public PreviewCamera zoom(double upPixels, Viewport canvas) {
        double requested = distance() * Math.exp(-ZOOM_PER_CANVAS * upPixels / canvas.height());
        double distance = Math.clamp(requested, MIN_DISTANCE, MAX_DISTANCE);
        return moved(camera.to().minus(forward().times(distance)), camera.to(), camera.up());
    }

    /** Pans the view, so that the scene follows the mouse in the view plane through the target. */
    public PreviewCamera pan(double rightPixels, double upPixels, Viewport canvas) {
        double scale = pixelScale(distance(), canvas.height());
        Vec3 step = right().times(-rightPixels * scale).plus(up().times(-upPixels * scale));
        return moved(camera.from().plus(step), camera.to().plus(step), camera.up());
    }

    /** Rotates the view like a trackball around the target. */
    public PreviewCamera trackball(double rightPixels, double upPixels, Viewport canvas) {
        double radiansPerPixel = TURN_PER_CANVAS / Math.min(canvas.width(), canvas.height());
        double angle = Math.hypot(rightPixels, upPixels) * radiansPerPixel;
        if (angle == 0) {
            return this;
        }
        // The near side of the scene follows the mouse, so the camera moves in the opposite direction.
        Vec3 axis = up().times(-rightPixels).plus(right().times(upPixels)).normalized();
        Vec3 eye = VectorRotation.rotate(axis, angle, camera.from().minus(camera.to()));
        return moved(camera.to().plus(eye), camera.to(), VectorRotation.rotate(axis, angle, camera.up()));
    }

    /** Turns the view about the target: sideways about the vertical axis, then up or down to straight above or below. */
    public PreviewCamera orbit(double rightPixels, double upPixels, Viewport canvas) {
        double radiansPerPixel = TURN_PER_CANVAS / Math.min(canvas.width(), canvas.height());
        Vec3 offset = camera.from().minus(camera.to());
        double elevation = Math.asin(Math.clamp(offset.y() / offset.length(), -1, 1));
        // From straight above or below, the image's up direction is the azimuth.
        boolean isSteep = Math.abs(elevation) > MAX_ELEVATION;
        Vec3 horizontal = isSteep ? up().times(-Math.signum(elevation)) : offset;
        double azimuth = Math.atan2(horizontal.x(), horizontal.z()) - rightPixels * radiansPerPixel;
        double tilted = Math.clamp(elevation - upPixels * radiansPerPixel, -MAX_ELEVATION, MAX_ELEVATION);
        Vec3 eye = new Vec3(Math.cos(tilted) * Math.sin(azimuth), Math.sin(tilted), Math.cos(tilted) * Math.cos(azimuth))
                .times(offset.length());
        return rightPixels == 0 && upPixels == 0 ? this : moved(camera.to().plus(eye), camera.to(), Vec3.Y);
    }

    private PreviewCamera moved(Vec3 from, Vec3 to, Vec3 up) {
        boolean isAllowed = from.maxAbs() <= SceneLimits.MAX_COORDINATE && to.maxAbs() <= SceneLimits.MAX_COORDINATE
                && to.minus(from).maxAbs() >= MIN_DISTANCE / 2;
        return isAllowed ? new PreviewCamera(new Camera(from, to, up, camera.fov(), camera.shift())) : this;
    }

    @Override
    public boolean equals(Object o) {
        return o instanceof PreviewCamera other && camera.equals(other.camera);
    }

    @Override
    public int hashCode() {
        return camera.hashCode();
    }

    @Override
    public String toString() {
        return camera.toString();
    }
}
