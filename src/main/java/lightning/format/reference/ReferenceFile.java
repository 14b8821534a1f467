package lightning.format.reference;

import java.io.IOException;
import java.nio.file.Path;
import lightning.base.text.Quote;
import lightning.format.image.ImageFile;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.render.match.ReferenceImage;
import lightning.scene.Scene;
import org.jspecify.annotations.Nullable;

/**
 * Image of another program, to match: PNG, JPEG, OpenEXR, Radiance HDR or PFM.
 *
 * @param isDisplayReferred whether the file contains codes of a display, which were converted to light by the curve of sRGB
 */
public record ReferenceFile(Path file, ReferenceImage image, boolean isDisplayReferred) {

    /**
     * Reads an image to match. Pixels that an image of codes clips at white, or that are infinite or not a number, do not count.
     *
     * @throws IOException as {@link ImageFile#readPicture}, or if no pixel is finite
     */
    public static ReferenceFile read(Path file) throws IOException {
        return ImageFile.readPicture(file, source -> {
            ReferenceImage image = ReferenceImage.of(source.film());
            if (image.invalidPixels() == image.weights().length) {
                throw new IOException("expected an image of numbers, found that all pixels are infinite or not a number");
            }
            return new ReferenceFile(file, source.isDisplayReferred() ? image.withoutClipped() : image, source.isDisplayReferred());
        });
    }

    /**
     * Reads an image as the light that the picture of a scene shall have.
     *
     * @param view   view transform that a display-referred file was made for
     * @param region left column, top row, width and height of the part that counts, in the image's pixels; null for all
     * @throws IOException as {@link #read}, or if the image has another shape than the picture
     */
    public static ReferenceImage readFor(Scene scene, Path file, ViewTransform view, int @Nullable [] region) throws IOException {
        ReferenceFile reference = read(file);
        Film film = reference.image.film();
        int width = scene.picture().width();
        int height = scene.picture().height();
        if (!reference.image.hasShapeOf(width, height)) {
            throw new IOException(Quote.path(file) + ": expected an image of the picture's shape, " + width + " x " + height
                    + " pixels or a multiple, found " + film.width() + " x " + film.height());
        }
        if (region != null) {
            reference = new ReferenceFile(file, reference.image.within((double) region[0] / film.width(),
                    (double) region[1] / film.height(), (double) ((long) region[0] + region[2]) / film.width(),
                    (double) ((long) region[1] + region[3]) / film.height()), reference.isDisplayReferred);
        }
        return reference.light(view, width, height);
    }

    /**
     * Returns the light that a picture shall have. Codes of a display are what a view shall show.
     *
     * @param width  of the picture, pixels
     * @param height of the picture, pixels
     */
    public ReferenceImage light(ViewTransform view, int width, int height) {
        return isDisplayReferred ? image.beforeView(view, width, height) : image;
    }
}
