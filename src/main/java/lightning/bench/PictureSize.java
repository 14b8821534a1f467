package lightning.bench;

import lightning.scene.Scene;

/** Image size in pixels. */
public record PictureSize(int width, int height) {
    /** Returns the scene at this size. */
    Scene of(Scene scene) {
        return scene.withPicture(scene.picture().withSize(width, height));
    }

    long pixels() {
        return (long) width * height;
    }

    @Override
    public String toString() {
        return width + "x" + height;
    }
}
