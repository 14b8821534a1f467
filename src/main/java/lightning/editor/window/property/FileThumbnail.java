package lightning.editor.window.property;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import javafx.scene.image.ImageView;
import javax.imageio.ImageReader;
import lightning.base.file.RegularFile;
import lightning.editor.window.widget.PixelImage;
import lightning.format.jen.asset.FileKind;
import lightning.format.jen.asset.JenLimits;
import lightning.format.jen.asset.LinearTextureReader;
import lightning.format.jen.asset.TextureDecoder;
import lightning.format.jen.asset.UnusableFileException;
import lightning.scene.asset.Texture;

/**
 * Thumbnail of an image file.
 *
 * @param pixels  {@code int[width * height]}, opaque 0xFFRRGGBB
 */
record FileThumbnail(int width, int height, int[] pixels) {
    /** Longer side, pixels. */
    private static final int MAX_SIDE = 40;
    /** Larger images get no thumbnail. */
    private static final long MAX_PIXELS = 1L << 26;
    /** Larger files of linear values get no thumbnail, because they are decoded as a whole before the menu lists them. */
    private static final long MAX_LINEAR_BYTES = 8 << 20;

    /**
     * Reads the thumbnail of a file of the scene's folder; empty if the file is missing, unreadable or too large. Runs in the background.
     */
    static Optional<FileThumbnail> of(FileKind kind, Path folder, String name) {
        try {
            Optional<Path> file = kind.find(folder, name);
            return file.isEmpty() ? Optional.empty() : LinearTextureReader.isLinear(name) ? readLinear(name, file.get())
                    : read(name, file.get());
        } catch (IOException | UnusableFileException | RuntimeException e) {
            // An unreadable image is listed by name only.
            return Optional.empty();
        }
    }

    /** Reads linear values, which need an exposure. */
    private static Optional<FileThumbnail> readLinear(String name, Path path) throws IOException, UnusableFileException {
        if (Files.size(path) > MAX_LINEAR_BYTES) {
            return Optional.empty();
        }
        Texture image = LinearTextureReader.read(name, path);
        int step = Math.max(1, Math.max(image.width(), image.height()) / MAX_SIDE);
        int width = (image.width() + step - 1) / step;
        int height = (image.height() + step - 1) / step;
        float[] rgb = new float[3 * width * height];
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] = image.channel(i / 3 % width * step, i / 3 / width * step, i % 3);
        }
        return Optional.of(new FileThumbnail(width, height, AutoExposure.toPixels(rgb)));
    }

    private static Optional<FileThumbnail> read(String name, Path path) throws IOException, UnusableFileException {
        byte[] file = RegularFile.readBytes(path, "a PNG or JPEG file", JenLimits.TEXTURE_BYTES);
        return TextureDecoder.read(name, file, reader -> (long) reader.getWidth(0) * reader.getHeight(0) > MAX_PIXELS ? Optional.empty()
                : Optional.of(subsample(reader)));
    }

    private static FileThumbnail subsample(ImageReader reader) throws IOException {
        int step = Math.max(1, Math.max(reader.getWidth(0), reader.getHeight(0)) / MAX_SIDE);
        var parameters = reader.getDefaultReadParam();
        parameters.setSourceSubsampling(step, step, 0, 0);
        BufferedImage subsampled = reader.read(0, parameters);
        int[] pixels = subsampled.getRGB(0, 0, subsampled.getWidth(), subsampled.getHeight(), null, 0, subsampled.getWidth());
        for (int i = 0; i < pixels.length; i++) {
            pixels[i] |= 0xFF000000;
        }
        return new FileThumbnail(subsampled.getWidth(), subsampled.getHeight(), pixels);
    }

    ImageView view() {
        var view = new ImageView(PixelImage.of(width, height, pixels));
        view.setPreserveRatio(true);
        view.setFitWidth(MAX_SIDE);
        view.setFitHeight(MAX_SIDE);
        return view;
    }
}
