package lightning.scene;

import java.util.List;
import java.util.stream.Stream;
import lightning.base.math.Vec3;
import lightning.base.text.RefusalException;
import lightning.scene.attribute.NumericKind;
import lightning.scene.attribute.SceneAttribute;
import lightning.scene.value.Lens;
import lightning.scene.value.LensShift;
import lightning.scene.value.SceneLimits;

/**
 * Camera with a thin lens, a pinhole unless its aperture is opened.
 *
 * @param from   position
 * @param to     target, different from {@code from}
 * @param up     up direction of the image, not parallel to the view direction
 * @param fov    vertical field of view, degrees
 * @param shift  moves the picture in the image plane
 * @param lens   blurs points off the plane of focus, if finer samples are traced
 * @param origin origin of render space, in which rays and shapes are computed: {@code from} for every final image. A camera that moves
 *     continuously, such as a preview's, may keep another origin to avoid recomputing the shapes; its images then differ in their last
 *     bits.
 */
public record Camera(Vec3 from, Vec3 to, Vec3 up, double fov, LensShift shift, Lens lens, Vec3 origin) {
    public static final Camera DEFAULT = new Camera(new Vec3(0, 0, 10), Vec3.ZERO, Vec3.Y, 40);

    public static final SceneAttribute<Camera, Vec3> FROM =
            new SceneAttribute<>("from", "from", NumericKind.position(), DEFAULT.from, "scene units",
                    Camera::from, (c, v) -> c.withView(v, c.to, c.up));
    public static final SceneAttribute<Camera, Vec3> TO =
            new SceneAttribute<>("to", "to", NumericKind.position(), DEFAULT.to, "scene units",
                    Camera::to, (c, v) -> c.withView(c.from, v, c.up));
    public static final SceneAttribute<Camera, Vec3> UP =
            new SceneAttribute<>("up", "up", NumericKind.direction(), DEFAULT.up, "any nonzero vector",
                    Camera::up, (c, v) -> c.withView(c.from, c.to, v));
    public static final SceneAttribute<Camera, Double> FOV = new SceneAttribute<>("fov", "fov",
            NumericKind.degrees(SceneLimits.MIN_FOV, SceneLimits.MAX_FOV, 1), DEFAULT.fov, "degrees, vertical", Camera::fov,
            (c, v) -> new Camera(c.from, c.to, c.up, v, c.shift, c.lens));
    public static final SceneAttribute<Camera, LensShift> SHIFT = new SceneAttribute<>("shift", "lens shift", NumericKind.shift(),
            LensShift.NONE, "of the picture's width and height", Camera::shift, Camera::withShift);

    /** Attributes that depend on each other and must be set together, in file order. */
    public static final List<SceneAttribute<Camera, ?>> VIEW = List.of(FROM, TO, UP);
    /** Attributes that can be set one by one, in file order. */
    public static final List<SceneAttribute<Camera, ?>> OPTICS =
            Stream.concat(Stream.of(FOV, SHIFT), LensAttributes.ALL.stream()).toList();
    /** All attributes, in file order. */
    public static final List<SceneAttribute<Camera, ?>> ATTRIBUTES = Stream.concat(VIEW.stream(), OPTICS.stream()).toList();

    /** Creates a pinhole without shift, and with render space at its position. */
    public Camera(Vec3 from, Vec3 to, Vec3 up, double fov) {
        this(from, to, up, fov, LensShift.NONE);
    }

    /** Creates a pinhole with render space at its position. */
    public Camera(Vec3 from, Vec3 to, Vec3 up, double fov, LensShift shift) {
        this(from, to, up, fov, shift, Lens.PINHOLE);
    }

    /** Creates a camera with render space at its position. */
    public Camera(Vec3 from, Vec3 to, Vec3 up, double fov, LensShift shift, Lens lens) {
        this(from, to, up, fov, shift, lens, from);
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

    /** Returns the same camera at another place, with render space there. */
    public Camera withView(Vec3 newFrom, Vec3 newTo, Vec3 newUp) {
        return new Camera(newFrom, newTo, newUp, fov, shift, lens);
    }

    /** Returns the same view with another shift. */
    public Camera withShift(LensShift v) {
        return new Camera(from, to, up, fov, v, lens, origin);
    }

    /** Returns the same view through another lens. */
    public Camera withLens(Lens v) {
        return new Camera(from, to, up, fov, shift, v, origin);
    }

    /** Returns the same view with another origin of render space. */
    public Camera withOrigin(Vec3 v) {
        return new Camera(from, to, up, fov, shift, lens, v);
    }

    /** Returns whether another camera sees the same, as far as it is sharp. */
    public boolean hasSameView(Camera o) {
        return equals(o.withLens(lens));
    }

    /** Returns the distance of the plane of focus along the view direction, scene units. */
    public double focusDistance() {
        return lens.focus() > 0 ? lens.focus() : to.minus(from).length();
    }
}
