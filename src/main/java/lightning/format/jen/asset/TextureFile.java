package lightning.format.jen.asset;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import lightning.base.file.UnusableFileException;
import lightning.format.image.ImageFile;
import lightning.format.image.ImageFormat;
import lightning.format.image.ImageLimits;
import lightning.format.image.ImageSource;
import lightning.scene.asset.Texture;
import lightning.scene.asset.TextureUsage;

/** Reader for the images that a scene may name as textures. */
public final class TextureFile {
    /** Images whose pixels are reduced. */
    public static final ImageLimits REDUCIBLE = new ImageLimits("texture",
            List.of(ImageFormat.PNG, ImageFormat.JPEG, ImageFormat.HDR, ImageFormat.EXR), JenLimits.TEXTURE_BYTES, JenLimits.TEXTURE_SIDE,
            (long) JenLimits.TEXTURE_SIDE * JenLimits.TEXTURE_SIDE);
    /** Images that are read as a whole. */
    public static final ImageLimits WHOLE = REDUCIBLE.withMaxPixels(JenLimits.TEXTURE_PIXELS);

    private TextureFile() {}

    /**
     * Reads an image in linear light; colors of linear values are not limited to 1.
     *
     * @param name name of the file in messages; its extension says the format
     * @throws UnusableFileException if it is too large, damaged or of another format
     */
    public static Texture read(String name, Path path) throws UnusableFileException {
        return ImageFile.read(name, path, WHOLE, image -> image.texture(TextureUsage.EMISSION, 1));
    }

    /**
     * Decodes an image. One of too many pixels loses rows and columns until it has at most {@link JenLimits#TEXTURE_PIXELS}.
     *
     * @param name name of the file in messages
     * @throws UnusableFileException if it is not a PNG or JPEG, too large or damaged
     */
    public static Texture decode(String name, byte[] file, TextureUsage usage) throws UnusableFileException {
        return ImageFile.read(name, file, REDUCIBLE, image -> reduced(image, usage));
    }

    /** Returns whether a PNG or JPEG has alpha; false if it cannot be decoded. */
    public static boolean hasAlpha(byte[] file) {
        try {
            return ImageFile.read("", file, REDUCIBLE, ImageSource::hasAlpha);
        } catch (UnusableFileException e) {
            return false;
        }
    }

    /** Decodes an opened image. One of too many pixels loses rows and columns. */
    public static Texture reduced(ImageSource image, TextureUsage usage) throws IOException {
        return image.texture(usage, image.step(JenLimits.TEXTURE_PIXELS));
    }
}
