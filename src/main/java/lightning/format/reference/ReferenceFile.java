package lightning.format.reference;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Set;
import lightning.base.file.RegularFile;
import lightning.base.text.Quote;
import lightning.format.hdr.HdrReader;
import lightning.format.image.ImageFile;
import lightning.format.image.ImageFormat;
import lightning.format.jen.asset.JenLimits;
import lightning.format.jen.asset.TextureDecoder;
import lightning.format.jen.asset.UnusableFileException;
import lightning.format.mesh.MeshException;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.render.match.ReferenceImage;
import lightning.scene.Scene;
import lightning.scene.asset.EnvironmentMap;
import lightning.scene.asset.Texture;
import org.jspecify.annotations.Nullable;

/** Reader for images of other programs: PNG, JPEG, OpenEXR, Radiance HDR and PFM. */
public final class ReferenceFile {
    private static final Set<String> JPEG = Set.of("jpg", "jpeg");

    private ReferenceFile() {}

    /**
     * Reads an image to match. Pixels that an image of codes clips at white, or that are infinite or not a number, do not count.
     *
     * @throws IOException as {@link #readFilm}, or if no pixel is finite
     */
    public static ReferenceImage read(Path file) throws IOException {
        ReferenceImage image = ReferenceImage.of(readFilm(file));
        if (image.invalidPixels() == image.weights().length) {
            throw new IOException(Quote.path(file) + ": expected an image of numbers, found that all pixels are infinite or not a number");
        }
        return isDisplayReferred(file) ? image.withoutClipped() : image;
    }

    /**
     * Reads an image as the light that the picture of a scene shall have. Codes of a display are what a view shall show.
     *
     * @param view   view transform that a display-referred file was made for
     * @param region left column, top row, width and height of the part that counts, in the image's pixels; null for all
     * @throws IOException as {@link #readFilm}, or if the image has another shape than the picture
     */
    public static ReferenceImage readFor(Scene scene, Path file, ViewTransform view, int @Nullable [] region) throws IOException {
        ReferenceImage image = read(file);
        Film film = image.film();
        int width = scene.picture().width();
        int height = scene.picture().height();
        if (!image.hasShapeOf(width, height)) {
            throw new IOException(Quote.path(file) + ": expected an image of the picture's shape, " + width + " x " + height
                    + " pixels or a multiple, found " + film.width() + " x " + film.height());
        }
        if (region != null) {
            image = image.within((double) region[0] / film.width(), (double) region[1] / film.height(),
                    (double) ((long) region[0] + region[2]) / film.width(), (double) ((long) region[1] + region[3]) / film.height());
        }
        return isDisplayReferred(file) ? image.beforeView(view, width, height) : image;
    }

    /**
     * Returns whether a file contains codes of a display, which were converted to light by the curve of sRGB.
     *
     * @throws IOException if the extension is unknown
     */
    public static boolean isDisplayReferred(Path file) throws IOException {
        return isJpeg(file) || format(file).isDisplayReferred();
    }

    /**
     * Returns whether a file stores all bits of a float.
     *
     * @throws IOException if the extension is unknown, or the file cannot be read
     */
    public static boolean hasFullFloats(Path file) throws IOException {
        return !isJpeg(file) && format(file).hasFullFloats(file);
    }

    /**
     * Reads an image as linear light: the floats of PFM, OpenEXR or HDR, the values 0…1 of the sRGB codes of PNG or JPEG.
     *
     * @throws IOException if the extension is unknown, or the file is missing, unreadable, damaged or too large; the message is a sentence for
     *     the user that begins with the file's name
     */
    public static Film readFilm(Path file) throws IOException {
        if (isJpeg(file)) {
            return readJpeg(file);
        }
        if (format(file) != ImageFormat.HDR) {
            return ImageFile.read(file);
        }
        EnvironmentMap map = readHdr(file);
        float[] rgb = new float[3 * map.width() * map.height()];
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] = map.channel(i / 3 % map.width(), i / 3 / map.width(), i % 3);
        }
        return Film.ofScanlines(map.width(), map.height(), rgb);
    }

    private static EnvironmentMap readHdr(Path file) throws IOException {
        try {
            return HdrReader.read(file);
        } catch (MeshException e) {
            throw new IOException(e.getMessage(), e);
        }
    }

    /** Returns the format of an image that is no JPEG. */
    private static ImageFormat format(Path file) throws IOException {
        return ImageFormat.find(file).orElseThrow(
                () -> new IOException(Quote.path(file) + ": an image's name must end in .png, .jpg, .xpm, .pfm, .exr or .hdr"));
    }

    private static boolean isJpeg(Path file) {
        String name = file.getFileName().toString().toLowerCase(Locale.ROOT);
        return JPEG.contains(name.substring(name.lastIndexOf('.') + 1));
    }

    private static Film readJpeg(Path file) throws IOException {
        try {
            Texture image =
                    TextureDecoder.decodeColors(Quote.path(file), RegularFile.readBytes(file, "a JPEG file", JenLimits.TEXTURE_BYTES));
            float[] rgb = new float[3 * image.width() * image.height()];
            for (int i = 0; i < rgb.length; i++) {
                rgb[i] = image.channel(i / 3 % image.width(), i / 3 / image.width(), i % 3);
            }
            return Film.ofScanlines(image.width(), image.height(), rgb);
        } catch (UnusableFileException e) {
            throw new IOException(e.getMessage(), e);
        }
    }
}
