package lightning.document.manipulation;

import lightning.base.math.Vec3;
import lightning.base.text.Messages;

/**
 * Size of an image on the screen in pixels, with the projection of scene points to it.
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

    /** Position on the canvas, in pixels from its left and top. */
    public record Pixel(double x, double y) {
        public double distance(Pixel other) {
            return Math.hypot(x - other.x, y - other.y);
        }
    }

    /** Projects a point in front of the camera; outside the canvas if it is out of view. */
    public Pixel project(PreviewCamera view, Vec3 point) {
        double scale = view.pixelScale(view.depth(point), height);
        Vec3 offset = point.minus(view.camera().from());
        return new Pixel(centerX(view) + offset.dot(view.right()) / scale, centerY(view) - offset.dot(view.up()) / scale);
    }

    /** Returns where the view direction is on the canvas: at its center if the camera has no shift. */
    private double centerX(PreviewCamera view) {
        return width * (0.5 - view.camera().shift().x());
    }

    private double centerY(PreviewCamera view) {
        return height * (0.5 + view.camera().shift().y());
    }

    /** Returns the unit direction from the camera through a position. */
    public Vec3 direction(PreviewCamera view, double x, double y) {
        double scale = view.pixelScale(1, height);
        return view.forward().plus(view.right().times((x - centerX(view)) * scale))
                .plus(view.up().times((centerY(view) - y) * scale)).normalized();
    }
}
