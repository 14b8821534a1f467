package lightning.document.manipulation;

import java.util.Optional;
import lightning.base.math.Vec3;
import lightning.scene.Scene;

/**
 * Point that the scene's camera looks at: the camera's target, or the surface in the middle of the picture where that says more. Imported
 * cameras often have a target one unit away, whatever the scene's size.
 */
public final class ViewFocus {
    /** A target that is so many times nearer than the surface behind it is no place in the scene. */
    private static final double TARGET_TO_SURFACE = 8;
    /** More shapes would take too long to search. */
    private static final int MAX_SHAPES = 50_000;

    private ViewFocus() {}

    /** Returns the point in the scene. */
    public static Vec3 of(Scene scene) {
        var view = PreviewCamera.of(scene);
        Vec3 from = view.camera().from();
        double target = view.distance();
        double surface = surfacePoint(scene).map(p -> p.minus(from).length()).orElse(target);
        return surface < target || surface > TARGET_TO_SURFACE * target ? from.plus(view.forward().times(surface)) : view.camera().to();
    }

    private static Optional<Vec3> surfacePoint(Scene scene) {
        return scene.stage().shapeCount() > MAX_SHAPES ? Optional.empty()
                : new ScenePicker(scene).pickPixel(scene.picture().width() / 2, scene.picture().height() / 2)
                        .map(ScenePicker.SurfaceHit::point);
    }
}
