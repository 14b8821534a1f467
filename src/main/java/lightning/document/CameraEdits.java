package lightning.document;

import lightning.base.math.Vec3;
import lightning.base.text.Messages;
import lightning.base.text.RefusalException;
import lightning.document.manipulation.PreviewCamera;
import lightning.document.manipulation.ViewFocus;
import lightning.scene.AntialiasMode;
import lightning.scene.Camera;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;
import lightning.scene.value.Lens;

/** Edits of the scene's camera. */
public final class CameraEdits {
    /** Aperture of a pinhole that is opened, relative to the focus distance: a blur that can be seen. */
    private static final double NEW_APERTURE = 0.01;

    private CameraEdits() {}

    /** Returns the view of the scene's camera, with the surface in its middle as the target if that says more: drags turn about it. */
    public static PreviewCamera focused(Scene scene) {
        Camera camera = scene.camera();
        return new PreviewCamera(camera.withView(camera.from(), ViewFocus.of(scene), camera.up()));
    }

    /** Returns the scene seen as in a view; shift and lens of its camera stay. */
    public static EditOutcome use(Scene scene, PreviewCamera view) {
        Camera seen = view.camera();
        return EditOutcome
                .of(() -> scene.withCamera(Camera.FOV.with(scene.camera().withView(seen.from(), seen.to(), seen.up()), seen.fov())));
    }

    /**
     * Returns the scene with the plane of focus through a point. A pinhole is opened, and anti-aliasing switched on at edges, because without
     * both everything stays sharp.
     *
     * @param point in front of the camera, scene units
     */
    public static EditOutcome focus(Scene scene, Vec3 point) {
        return EditOutcome.of(() -> {
            Camera camera = scene.camera();
            Vec3 view = camera.to().minus(camera.from()).normalized();
            double distance = point.minus(camera.from()).dot(view);
            if (!(distance > 0)) {
                throw new RefusalException(Messages.tr("the point is not in front of the camera"));
            }
            Lens lens = camera.lens().withFocus(distance);
            SamplingSettings sampling = scene.picture().sampling();
            return scene.withCamera(camera.withLens(lens.isOpen() ? lens : lens.withAperture(NEW_APERTURE * distance)))
                    .withPicture(scene.picture().withSampling(
                            sampling.isSupersampled() ? sampling : new SamplingSettings(AntialiasMode.EDGES, sampling.grid())));
        });
    }
}
