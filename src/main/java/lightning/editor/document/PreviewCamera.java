package lightning.editor.document;

import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.base.math.VectorRotation;
import lightning.scene.Camera;
import lightning.scene.Light;
import lightning.scene.Scene;
import lightning.scene.SceneLimits;

/**
 * The preview's own camera (paper §3.6). It turns about the point that it looks at, and never touches the traced
 * picture.
 *
 * @param camera {@code up} is always square to the view and of length 1
 */
public final class PreviewCamera {
    /** A drag over the whole canvas zooms by this power of e. */
    private static final double ZOOM_PER_CANVAS = 2;
    /** A drag over the whole canvas turns the scene by this angle, radians. */
    private static final double TURN_PER_CANVAS = Math.PI;
    private static final double MIN_DISTANCE = 1e-4;
    private static final double MAX_DISTANCE = 1e9;
    private static final double MIN_LIGHT_FOV = 2;
    private static final double MAX_LIGHT_FOV = 150;

    private final Camera camera;
    private final Vec3 forward;
    private final Vec3 right;
    private final double sin;
    private final double cos;

    /** @param source its direction that is up need not be at a right angle to the view */
    public PreviewCamera(Camera source) {
        forward = source.to().minus(source.from()).normalized();
        Vec3 side = forward.cross(source.up().normalized()).normalized();
        camera = new Camera(source.from(), source.to(), side.cross(forward).normalized(), source.fov());
        right = forward.cross(camera.up()).normalized();
        sin = Transform.sinDegrees(camera.fov() / 2);
        cos = Transform.cosDegrees(camera.fov() / 2);
    }

    public Camera camera() {
        return camera;
    }

    /** The scene's own camera: button −Z (Reset). */
    public static PreviewCamera of(Scene scene) {
        return new PreviewCamera(scene.camera());
    }

    /** The scene seen along the x axis: button X. */
    public static PreviewCamera alongX(Scene scene) {
        return along(scene, new Vec3(1, 0, 0), Vec3.Y);
    }

    /** The scene seen from above, along the negative y axis, with −z up: button −Y. */
    public static PreviewCamera alongMinusY(Scene scene) {
        return along(scene, new Vec3(0, -1, 0), new Vec3(0, 0, -1));
    }

    private static PreviewCamera along(Scene scene, Vec3 view, Vec3 up) {
        Camera sceneCamera = scene.camera();
        double distance = sceneCamera.to().minus(sceneCamera.from()).length();
        return new PreviewCamera(new Camera(sceneCamera.to().minus(view.times(distance)), sceneCamera.to(), up, sceneCamera.fov()));
    }

    /**
     * The scene as a light sees it: from its position along its direction, a spot's cone filling the picture. A point
     * light looks at what the scene's camera looks at; a directional one looks at it from the scene camera's distance.
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

    /** The unit direction of the view. */
    public Vec3 forward() {
        return forward;
    }

    /** The unit direction that is right in the picture. */
    public Vec3 right() {
        return right;
    }

    /** The unit direction that is up in the picture. */
    public Vec3 up() {
        return camera.up();
    }

    /** From the eye to the point that it looks at. */
    public double distance() {
        return camera.to().minus(camera.from()).length();
    }

    /** How far a point lies before the eye, along the view; negative behind it. */
    public double depth(Vec3 point) {
        return point.minus(camera.from()).dot(forward);
    }

    /**
     * How long one pixel is at a depth, in scene units.
     *
     * @param depth  as {@link #depth}, &gt; 0
     * @param height of the canvas, pixels
     */
    public double pixelScale(double depth, double height) {
        return 2 * depth * sin / cos / height;
    }

    /** The eye comes nearer (drag up) or goes away (down), by the same factor for the same way. */
    public PreviewCamera zoom(double upPixels, Viewport canvas) {
        double requested = distance() * Math.exp(-ZOOM_PER_CANVAS * upPixels / canvas.height());
        double distance = Math.clamp(requested, MIN_DISTANCE, MAX_DISTANCE);
        return moved(camera.to().minus(forward().times(distance)), camera.to(), camera.up());
    }

    /** The scene follows the mouse in the viewing plane through the point looked at. */
    public PreviewCamera pan(double rightPixels, double upPixels, Viewport canvas) {
        double scale = pixelScale(distance(), canvas.height());
        Vec3 step = right().times(-rightPixels * scale).plus(up().times(-upPixels * scale));
        return moved(camera.from().plus(step), camera.to().plus(step), camera.up());
    }

    /** The scene turns with the mouse as if it were enclosed in a sphere about the point looked at. */
    public PreviewCamera trackball(double rightPixels, double upPixels, Viewport canvas) {
        double radiansPerPixel = TURN_PER_CANVAS / Math.min(canvas.width(), canvas.height());
        double angle = Math.hypot(rightPixels, upPixels) * radiansPerPixel;
        if (angle == 0) {
            return this;
        }
        // The near side of the scene goes with the mouse, so the eye goes the other way.
        Vec3 axis = up().times(-rightPixels).plus(right().times(upPixels)).normalized();
        Vec3 eye = VectorRotation.rotate(axis, angle, camera.from().minus(camera.to()));
        return moved(camera.to().plus(eye), camera.to(), VectorRotation.rotate(axis, angle, camera.up()));
    }

    private PreviewCamera moved(Vec3 from, Vec3 to, Vec3 up) {
        boolean isAllowed = from.maxAbs() <= SceneLimits.MAX_COORDINATE && to.maxAbs() <= SceneLimits.MAX_COORDINATE
                && to.minus(from).maxAbs() >= MIN_DISTANCE / 2;
        return isAllowed ? new PreviewCamera(new Camera(from, to, up, camera.fov())) : this;
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
