package lightning.editor.document;

import lightning.base.math.Vec3;
import lightning.base.text.Messages;

/**
 * The size of a picture on the screen, pixels, and where the points of a scene fall on it.
 *
 * @param width  ≥ 1
 * @param height ≥ 1
 */
public record Viewport(double width, double height) {
    public Viewport {
        if (!(width >= 1 && height >= 1)) {
            throw new IllegalArgumentException(Messages.tr("expected a canvas of at least 1 × 1 pixel, found {0} × {1}", width, height));
        }
    }

    /** A place on the canvas, pixels from its left and from its top. */
    public record Pixel(double x, double y) {
        public double distance(Pixel other) {
            return Math.hypot(x - other.x, y - other.y);
        }
    }

    /** Where a point before the eye falls; outside the canvas where it is out of view. */
    public Pixel project(PreviewCamera view, Vec3 point) {
        double scale = view.pixelScale(view.depth(point), height);
        Vec3 offset = point.minus(view.camera().from());
        return new Pixel(width / 2 + offset.dot(view.right()) / scale, height / 2 - offset.dot(view.up()) / scale);
    }

    /** The unit direction from the eye through a place. */
    public Vec3 direction(PreviewCamera view, double x, double y) {
        double scale = view.pixelScale(1, height);
        return view.forward().plus(view.right().times((x - width / 2) * scale))
                .plus(view.up().times((height / 2 - y) * scale)).normalized();
    }
}
