package lightning.bench;

import lightning.scene.Scene;

/** A picture's size, pixels. */
public record PictureSize(int width, int height) {
    /** The scene with a picture of this size. */
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
