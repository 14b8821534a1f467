package lightning.trace;

import lightning.scene.Scene;

/** The eye of a scene: which ray belongs to which pixel. */
public final class Eye {
    private final CameraRays rays;

    public Eye(Scene scene) {
        rays = new CameraRays(scene.camera(), scene.picture());
    }

    /** The ray, of length 1, through the centre of a pixel: {@code x} from the left, {@code y} from the top. */
    public Ray through(int x, int y) {
        return rays.through(x, y);
    }
}
