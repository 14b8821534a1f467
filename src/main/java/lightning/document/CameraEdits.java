package lightning.document;

import java.util.ArrayList;
import java.util.List;
import lightning.base.math.Vec3;
import lightning.base.text.Messages;
import lightning.base.text.Quote;
import lightning.base.text.RefusalException;
import lightning.document.manipulation.PreviewCamera;
import lightning.document.manipulation.ViewFocus;
import lightning.scene.AntialiasMode;
import lightning.scene.Camera;
import lightning.scene.NamedCamera;
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

    /** Returns the name of the kept camera that the picture is seen from; empty if it is not kept. */
    public static String keptName(Scene scene) {
        return scene.cameras().stream().filter(kept -> kept.camera().equals(scene.camera())).map(NamedCamera::name).findFirst().orElse("");
    }

    /** Returns the scene seen from a kept camera. */
    public static EditOutcome choose(Scene scene, String name) {
        return scene.namedCamera(name).<EditOutcome>map(camera -> new EditOutcome.Applied(scene.withCamera(camera)))
                .orElseGet(() -> new EditOutcome.Refused(Messages.tr("there is no camera {0}", Quote.of(name))));
    }

    /** Returns the scene with its camera kept under a name, in place of one that has it, or as the last one. */
    public static EditOutcome keep(Scene scene, String name) {
        return EditOutcome.of(() -> {
            List<NamedCamera> cameras = new ArrayList<>(scene.cameras());
            int old = scene.cameraNames().indexOf(name);
            NamedCamera kept = new NamedCamera(name, scene.camera());
            if (old < 0) {
                cameras.add(kept);
            } else {
                cameras.set(old, kept);
            }
            return scene.withCameras(cameras);
        });
    }

    /** Returns a name that no kept camera has. */
    public static String freeName(Scene scene) {
        List<String> used = scene.cameraNames();
        String name = "camera";
        for (int number = 2; used.contains(name); number++) {
            name = "camera " + number;
        }
        return name;
    }

    /** Returns the scene without a kept camera. Its picture stays. */
    public static EditOutcome delete(Scene scene, String name) {
        return EditOutcome.of(() -> scene.withCameras(scene.cameras().stream().filter(kept -> !kept.name().equals(name)).toList()));
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
