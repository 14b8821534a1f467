package lightning.scene;

import java.util.List;
import lightning.base.math.Vec3;
import lightning.base.text.RefusalException;
import lightning.scene.attribute.NumericKind;
import lightning.scene.attribute.SceneAttribute;
import lightning.scene.value.LensShift;
import lightning.scene.value.SceneLimits;

/**
 * Pinhole camera.
 *
 * @param from   position
 * @param to     target, different from {@code from}
 * @param up     up direction of the image, not parallel to the view direction
 * @param fov    vertical field of view, degrees
 * @param shift  moves the picture in the image plane
 * @param origin origin of render space, in which rays and shapes are computed: {@code from} for every final image. A camera that moves
 *     continuously, such as a preview's, may keep another origin to avoid recomputing the shapes; its images then differ in their last
 *     bits.
 */
public record Camera(Vec3 from, Vec3 to, Vec3 up, double fov, LensShift shift, Vec3 origin) {
    public static final Camera DEFAULT = new Camera(new Vec3(0, 0, 10), Vec3.ZERO, Vec3.Y, 40);

    public static final SceneAttribute<Camera, Vec3> FROM =
            new SceneAttribute<>("from", "from", NumericKind.position(), DEFAULT.from, "scene units",
                    Camera::from, (c, v) -> new Camera(v, c.to, c.up, c.fov, c.shift));
    public static final SceneAttribute<Camera, Vec3> TO =
            new SceneAttribute<>("to", "to", NumericKind.position(), DEFAULT.to, "scene units",
                    Camera::to, (c, v) -> new Camera(c.from, v, c.up, c.fov, c.shift));
    public static final SceneAttribute<Camera, Vec3> UP =
            new SceneAttribute<>("up", "up", NumericKind.direction(), DEFAULT.up, "any nonzero vector",
                    Camera::up, (c, v) -> new Camera(c.from, c.to, v, c.fov, c.shift));
    public static final SceneAttribute<Camera, Double> FOV = new SceneAttribute<>("fov", "fov",
            NumericKind.degrees(SceneLimits.MIN_FOV, SceneLimits.MAX_FOV, 1), DEFAULT.fov, "degrees, vertical", Camera::fov,
            (c, v) -> new Camera(c.from, c.to, c.up, v, c.shift));
    public static final SceneAttribute<Camera, LensShift> SHIFT = new SceneAttribute<>("shift", "lens shift", NumericKind.shift(),
            LensShift.NONE, "of the picture's width and height", Camera::shift, (c, v) -> new Camera(c.from, c.to, c.up, c.fov, v));

    /** All attributes, in file order. Dependent values must be set together. */
    public static final List<SceneAttribute<Camera, ?>> ATTRIBUTES = List.of(FROM, TO, UP, FOV, SHIFT);

    /** Creates a camera without shift, and with render space at its position. */
    public Camera(Vec3 from, Vec3 to, Vec3 up, double fov) {
        this(from, to, up, fov, LensShift.NONE);
    }

    /** Creates a camera with render space at its position. */
    public Camera(Vec3 from, Vec3 to, Vec3 up, double fov, LensShift shift) {
        this(from, to, up, fov, shift, from);
    }

    public Camera {
        SceneLimits.checkPosition("from", from);
        SceneLimits.checkPosition("to", to);
        SceneLimits.checkDirection("up", up);
        SceneLimits.checkRange("fov", fov, SceneLimits.MIN_FOV, SceneLimits.MAX_FOV);
        SceneLimits.checkPosition("origin", origin);
        Vec3 view = to.minus(from);
        if (!(view.maxAbs() >= 1e-12)) {
            throw new RefusalException("from and to must be different points");
        }
        if (!(view.normalized().cross(up.normalized()).length() >= 1e-9)) {
            throw new RefusalException("up must not be parallel to the view direction");
        }
    }

    /** Returns the same view with another origin of render space. */
    public Camera withOrigin(Vec3 v) {
        return new Camera(from, to, up, fov, shift, v);
    }
}
