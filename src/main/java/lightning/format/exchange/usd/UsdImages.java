package lightning.format.exchange.usd;

import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import lightning.base.file.UnusableFileException;
import lightning.format.image.ImageFile;
import lightning.format.image.ImageFormat;
import lightning.format.image.ImageLimits;
import lightning.format.jen.asset.JenLimits;
import lightning.format.jen.asset.TextureFile;
import lightning.scene.asset.Texture;
import lightning.scene.asset.TextureUsage;
import lightning.scene.value.SceneLimits;

/** Reader of the images that stages name: PNG, JPEG and OpenEXR. */
final class UsdImages {
    private static final ImageLimits CODES = new ImageLimits("texture", List.of(ImageFormat.PNG, ImageFormat.JPEG),
            JenLimits.TEXTURE_BYTES, JenLimits.TEXTURE_SIDE, TextureFile.REDUCIBLE.maxPixels());
    private static final ImageLimits EXR = new ImageLimits("texture", List.of(ImageFormat.EXR), Long.MAX_VALUE, 1 << 16, 64 << 20);

    private UsdImages() {}

    static boolean isExr(Path file) {
        return file.toString().toLowerCase(Locale.ROOT).endsWith(".exr");
    }

    /**
     * Reads a value from an image.
     *
     * @throws UnusableFileException if the format is not supported, or the file too large or damaged
     */
    static <T> T read(Path file, ImageFile.Reading<T> reading) throws UnusableFileException {
        return ImageFile.read(file.toString(), file, isExr(file) ? EXR : CODES, reading);
    }

    /**
     * Decodes an image. Larger ones than textures can be lose rows and columns. Values of OpenEXR can be beyond 0…1.
     *
     * @throws UnusableFileException as above
     */
    static Texture read(Path file, TextureUsage usage) throws UnusableFileException {
        return read(file, image -> image.texture(usage, image.step(JenLimits.TEXTURE_PIXELS), (float) -SceneLimits.MAX_EMISSION));
    }
}
