package lightning.scene;

import lightning.math.Vec3;

/**
 * A pinhole camera.
 *
 * @param from where it stands
 * @param to   what it looks at, another point than {@code from}
 * @param up   the direction that is up in the picture, not along the view
 * @param fov  the vertical opening angle, degrees
 */
public record Camera(Vec3 from, Vec3 to, Vec3 up, double fov) {
    public static final Camera DEFAULT = new Camera(new Vec3(0, 0, 10), Vec3.ZERO, Vec3.Y, 40);

    public Camera {
        Limits.position("from", from);
        Limits.position("to", to);
        Limits.direction("up", up);
        Limits.range("fov", fov, Limits.MIN_FOV, Limits.MAX_FOV);
        Vec3 view = to.minus(from);
        if (!(view.maxAbs() >= 1e-12)) {
            throw new IllegalArgumentException("from and to must be two different points");
        }
        if (!(view.normalized().cross(up.normalized()).length() >= 1e-9)) {
            throw new IllegalArgumentException("up must not be along the view");
        }
    }
}
