package lightning.format.image;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import lightning.base.file.AtomicFile;
import lightning.base.text.Quote;
import lightning.base.work.WorkerPool;
import lightning.format.exr.ExrAttribute;
import lightning.format.exr.ExrPrimaries;
import lightning.format.exr.ExrType;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;

/** Writes and reads image files in the format of their extension: {@link ImageFormat}. */
public final class ImageFile {

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

    /**
     * Reads an image as a film: the exact floats of PFM or OpenEXR, the linear values 0…1 of the sRGB codes of PNG (which
     * {@link ViewTransform#DEFAULT} converts back to the same codes). Transparency is ignored. Radiance HDR and XPM are not
     * supported.
     *
     * @throws IOException if the extension is unknown, the file is missing, unreadable, damaged, wider or higher than 16384
     *     pixels or of more than 2²⁶ pixels (checked before decoding); the message is a sentence for the user that begins
     *     with the file's name
     */
    public static Film read(Path file) throws IOException {
        ImageFormat format = ImageFormat.of(file);
        if (!Files.isRegularFile(file)) {
            throw new IOException(Quote.path(file) + ": " + (Files.exists(file) ? "is not a regular file" : "no such file"));
        }
        try {
            return format.read(file);
        } catch (IOException e) {
            throw new IOException(Quote.path(file) + ": " + e.getMessage(), e);
        }
    }
}
