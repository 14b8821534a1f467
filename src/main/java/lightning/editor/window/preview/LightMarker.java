package lightning.editor.window.preview;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import lightning.base.math.Vec3;
import lightning.document.manipulation.PreviewCamera;
import lightning.document.manipulation.Viewport;
import lightning.scene.light.Light;

/**
 * Arrow at the border of the preview that points to a light outside the view. It can be dragged like the light itself.
 *
 * @param tip tip of the arrow, pixels of the canvas
 * @param angle direction of the arrow, radians, clockwise from right
 */
record LightMarker(Light light, Viewport.Pixel tip, double angle) {
    /** Distance from the border, pixels. */
    private static final double INSET = 10;
    private static final double TOLERANCE = 14;

    /** Returns the markers of all lights outside the view. */
    static List<LightMarker> of(List<Light> lights, PreviewCamera view, Viewport canvas) {
        List<LightMarker> markers = new ArrayList<>();
        for (Light light : lights) {
            of(light, view, canvas).ifPresent(markers::add);
        }
        return markers;
    }

    private static Optional<LightMarker> of(Light light, PreviewCamera view, Viewport canvas) {
        if (view.depth(light.position()) > 0) {
            Viewport.Pixel p = canvas.project(view, light.position());
            if (p.x() >= 0 && p.y() >= 0 && p.x() < canvas.width() && p.y() < canvas.height()) {
                return Optional.empty();
            }
        }
        Vec3 direction = light.position().minus(view.camera().from());
        if (direction.maxAbs() == 0) {
            // The view looks through this light, so no direction leads to it.
            return Optional.empty();
        }
        double angle = Math.atan2(-direction.dot(view.up()), direction.dot(view.right()));
        double halfWidth = Math.max(1, canvas.width() / 2 - INSET);
        double halfHeight = Math.max(1, canvas.height() / 2 - INSET);
        double distance = Math.min(halfWidth / Math.abs(Math.cos(angle)), halfHeight / Math.abs(Math.sin(angle)));
        return Optional.of(new LightMarker(light, new Viewport.Pixel(canvas.width() / 2 + distance * Math.cos(angle),
                canvas.height() / 2 + distance * Math.sin(angle)), angle));
    }

    /** Returns the light whose marker is at a point. */
    static Optional<Light> pick(List<Light> lights, PreviewCamera view, Viewport canvas, Viewport.Pixel point) {
        LightMarker best = null;
        for (LightMarker marker : of(lights, view, canvas)) {
            double distance = marker.tip().distance(point);
            if (distance <= TOLERANCE && (best == null || distance < best.tip().distance(point))) {
                best = marker;
            }
        }
        return Optional.ofNullable(best).map(LightMarker::light);
    }

    /** Returns the view moved back until it shows all lights; unchanged if it already does. */
    static PreviewCamera frameLights(List<Light> lights, PreviewCamera view, Viewport canvas) {
        if (of(lights, view, canvas).isEmpty()) {
            return view;
        }
        PreviewCamera zoomedOut = view;
        for (int i = 0; i < 100 && !of(lights, zoomedOut, canvas).isEmpty(); i++) {
            zoomedOut = zoomedOut.zoom(-canvas.height() / 20, canvas);
        }
        return of(lights, zoomedOut, canvas).isEmpty() ? zoomedOut.zoom(-canvas.height() / 20, canvas) : view;
    }
}
