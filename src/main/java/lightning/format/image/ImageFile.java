package lightning.format.image;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import lightning.base.file.AtomicFile;
import lightning.base.file.UnusableFileException;
import lightning.base.text.PrintableText;
import lightning.base.work.WorkerPool;
import lightning.format.exr.ExrAttribute;
import lightning.format.exr.ExrPrimaries;
import lightning.format.exr.ExrType;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;

/** Writes and reads image files ({@link ImageFormat}). All images that other files or the user name are opened here. */
public final class ImageFile {
    /** Pictures to compare with, to match and to show; a film takes 12 bytes for each pixel. */
    public static final ImageLimits PICTURES = new ImageLimits("",
            List.of(ImageFormat.PNG, ImageFormat.JPEG, ImageFormat.PFM, ImageFormat.EXR, ImageFormat.HDR), Long.MAX_VALUE, 1 << 14,
            1 << 26);

    private ImageFile() {}

    /**
     * Writes a film with the format's default bit depth. The file is replaced atomically.
     *
     * @param view view transform of display-referred formats; the others store linear values and ignore it
     * @throws IOException if the extension is unknown or the file cannot be written
     */
    public static void write(Path file, Film film, ViewTransform view) throws IOException {
        write(file, film, view, ImageFormat.of(file).bitDepths().getFirst());
    }

    /**
     * Writes a film.
     *
     * @param bits bits per channel, one of {@link ImageFormat#bitDepths}
     * @throws IOException as {@link #write(Path, Film, ViewTransform)}, and as {@link ImageFormat#requireBitDepth}
     */
    public static void write(Path file, Film film, ViewTransform view, int bits) throws IOException {
        try (WorkerPool singleWorker = new WorkerPool(1)) {
            write(file, film, view, bits, singleWorker);
        }
    }

    /**
     * Writes a film; workers compress PNG files in parallel. The file does not depend on their number.
     *
     * @param bits bits per channel, one of {@link ImageFormat#bitDepths}
     * @throws IOException as {@link #write(Path, Film, ViewTransform)}, and as {@link ImageFormat#requireBitDepth}
     */
    public static void write(Path file, Film film, ViewTransform view, int bits, WorkerPool workers) throws IOException {
        ImageFormat format = ImageFormat.of(file);
        format.requireBitDepth(file, bits);
        format.write(file, film, view, bits, workers);
    }

    /**
     * Writes a film as OpenEXR.
     *
     * @param bits 16 for halves, 32 for floats
     * @param attributes header of the file
     * @throws IOException as {@link #write(Path, Film, ViewTransform)}, and as {@link ImageFormat#requireBitDepth}
     */
    public static void writeExr(Path file, Film film, int bits, Map<String, ExrAttribute> attributes) throws IOException {
        writeExr(file, film, bits, attributes, ExrPrimaries.REC_709);
    }

    /**
     * Writes a film as OpenEXR in another color space.
     *
     * @param primaries color space of the file; their attributes replace those of {@code attributes}
     * @throws IOException as above
     */
    public static void writeExr(Path file, Film film, int bits, Map<String, ExrAttribute> attributes, ExrPrimaries primaries)
            throws IOException {
        ImageFormat.EXR.requireBitDepth(file, bits);
        AtomicFile.of(file).writeRandomAccess(
                to -> Exr.write(to, film, bits == Short.SIZE ? ExrType.HALF : ExrType.FLOAT, attributes, primaries));
    }

    /** Returns a film as the content of a Radiance HDR file. */
    public static byte[] toHdr(Film film) throws IOException {
        var out = new ByteArrayOutputStream();
        RadianceHdr.write(out, film);
        return out.toByteArray();
    }

    /** Value that is read from an opened image. */
    @FunctionalInterface
    public interface Reading<T> {
        /** Returns the value. */
        T from(ImageSource image) throws IOException;
    }

    /** Opening of an image. */
    private interface Opening {
        ImageSource open() throws IOException;
    }

    /**
     * Opens an image file and reads a value from it. It has the format that the extension of its name says, or one that Java's decoders
     * recognize.
     *
     * @param name name of the file in messages
     * @param limits what is accepted
     * @throws UnusableFileException if it is missing, unreadable, damaged, too large, or has none of the formats
     */
    public static <T> T read(String name, Path file, ImageLimits limits, Reading<T> reading) throws UnusableFileException {
        return read(name, () -> limits.open(name, file), limits, reading);
    }

    /**
     * Opens an image that Java's decoders recognize, and reads a value from it.
     *
     * @param name name of the image in messages
     * @param limits what is accepted
     * @throws UnusableFileException if it is damaged, too large, or has none of the formats
     */
    public static <T> T read(String name, byte[] file, ImageLimits limits, Reading<T> reading) throws UnusableFileException {
        return read(name, () -> new CodedImage(file, limits.formats()), limits, reading);
    }

    private static <T> T read(String name, Opening opening, ImageLimits limits, Reading<T> reading) throws UnusableFileException {
        try (ImageSource image = opening.open()) {
            limits.check(image.width(), image.height());
            image.check();
            return reading.from(image);
        } catch (UnusableFileException e) {
            throw e;
        } catch (IOException e) {
            throw new UnusableFileException(limits.subject(name) + PrintableText.escape(String.valueOf(e.getMessage())));
        }
    }

    /**
     * Converts an image to PNG, with fewer pixels if it has more than {@code maxPixels}.
     *
     * @param name name of the image in messages
     * @throws UnusableFileException as {@link #read(String, byte[], ImageLimits, Reading)}
     */
    public static byte[] toPng(String name, byte[] file, ImageLimits limits, long maxPixels) throws UnusableFileException {
        return read(name, file, limits, image -> ((CodedImage) image).png(image.step(maxPixels)));
    }

    /**
     * Reads an image as linear light: the floats of PFM, OpenEXR or HDR, the values 0…1 of the sRGB codes of PNG or JPEG (which
     * {@link ViewTransform#DEFAULT} converts back to the same codes). Transparency is ignored.
     *
     * @throws IOException as {@link #readPicture}
     */
    public static Film read(Path file) throws IOException {
        return readPicture(file, ImageSource::film);
    }

    /**
     * Reads a value from a picture: PNG, JPEG, PFM, OpenEXR or Radiance HDR.
     *
     * @throws IOException if the extension is unknown, the file is missing, unreadable, damaged, wider or higher than 16384
     *     pixels or of more than 2²⁶ pixels (checked before decoding); the message is a sentence for the user that begins
     *     with the file's name
     */
    public static <T> T readPicture(Path file, Reading<T> reading) throws IOException {
        ImageFormat.of(file, PICTURES.formats());
        return read(file.toString(), file, PICTURES, reading);
    }
}
