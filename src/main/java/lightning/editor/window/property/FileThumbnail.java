package lightning.editor.window.property;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import javafx.scene.image.ImageView;
import lightning.editor.window.widget.PixelImage;
import lightning.format.image.ImageFile;
import lightning.format.image.ImageLimits;
import lightning.format.image.ImageSource;
import lightning.format.jen.asset.FileKind;
import lightning.format.jen.asset.TextureFile;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.scene.asset.Texture;
import lightning.scene.asset.TextureUsage;

/**
 * Thumbnail of an image file.
 *
 * @param pixels  {@code int[width * height]}, opaque 0xFFRRGGBB
 */
record FileThumbnail(int width, int height, int[] pixels) {
    /** Longer side, pixels. */
    private static final int MAX_SIDE = 40;
    /** Larger images get no thumbnail. */
    private static final ImageLimits LIMITS = TextureFile.REDUCIBLE.withMaxPixels(1 << 26);
    /** Larger files of linear values get no thumbnail, because all pixels are decoded before the menu lists them. */
    private static final long MAX_LINEAR_BYTES = 8 << 20;

    /**
     * Reads the thumbnail of a file of the scene's folder; empty if the file is missing, unreadable or too large. Runs in the background.
     */
    static Optional<FileThumbnail> of(FileKind kind, Path folder, String name) {
        try {
            Optional<Path> file = kind.find(folder, name);
            return file.isEmpty() ? Optional.empty()
                    : ImageFile.read(name, file.get(), LIMITS, image -> of(image, Files.size(file.get())));
        } catch (IOException | RuntimeException e) {
            // An unreadable image is listed by name only.
            return Optional.empty();
        }
    }

    private static Optional<FileThumbnail> of(ImageSource image, long bytes) throws IOException {
        if (!image.isDisplayReferred() && bytes > MAX_LINEAR_BYTES) {
            return Optional.empty();
        }
        Texture small = image.texture(TextureUsage.EMISSION, Math.max(1, Math.max(image.width(), image.height()) / MAX_SIDE));
        float[] rgb = small.values();
        // Linear values need an exposure.
        return Optional.of(new FileThumbnail(small.width(), small.height(), image.isDisplayReferred()
                ? ViewTransform.DEFAULT.toPixels(Film.ofScanlines(small.width(), small.height(), rgb)) : AutoExposure.toPixels(rgb)));
    }

    ImageView view() {
        var view = new ImageView(PixelImage.of(width, height, pixels));
        view.setPreserveRatio(true);
        view.setFitWidth(MAX_SIDE);
        view.setFitHeight(MAX_SIDE);
        return view;
    }
}
