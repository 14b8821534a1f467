package lightning.format.image;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import lightning.base.text.Quote;
import lightning.base.work.WorkerPool;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;

/** Writes and reads picture files of the format that their name asks for: {@link ImageFormat}. */
public final class ImageFile {

    private ImageFile() {}

    /**
     * Writes a film with the bits that are usual; {@code file} holds the whole new picture or what it held before, at every moment.
     *
     * @param view what formats that are displayed show; the others keep the linear values and ignore it
     * @throws IOException if the extension is unknown or the file cannot be written
     */
    public static void write(Path file, Film film, ViewTransform view) throws IOException {
        write(file, film, view, ImageFormat.of(file).bitDepths().getFirst());
    }

    /**
     * Writes a film.
     *
     * @param bits of a number, one of {@link ImageFormat#bitDepths}
     * @throws IOException as {@link #write(Path, Film, ViewTransform)}, and as {@link ImageFormat#requireBitDepth}
     */
    public static void write(Path file, Film film, ViewTransform view, int bits) throws IOException {
        try (WorkerPool singleWorker = new WorkerPool(1)) {
            write(file, film, view, bits, singleWorker);
        }
    }

    /**
     * Writes a film, of a PNG with the help of workers; the file is the same for any number of them.
     *
     * @param bits of a number, one of {@link ImageFormat#bitDepths}
     * @throws IOException as {@link #write(Path, Film, ViewTransform)}, and as {@link ImageFormat#requireBitDepth}
     */
    public static void write(Path file, Film film, ViewTransform view, int bits, WorkerPool workers) throws IOException {
        ImageFormat format = ImageFormat.of(file);
        format.requireBitDepth(file, bits);
        format.write(file, film, view, bits, workers);
    }

    /**
     * Reads a picture as a film: the very floats of a PFM or OpenEXR, the linear values 0…1 of the sRGB codes of a PNG (which
     * {@link ViewTransform#DEFAULT} turns back into the same codes). Transparency is ignored. Radiance's pictures are read elsewhere, XPM
     * nowhere.
     *
     * @throws IOException if the extension is unknown, the file is missing, unreadable, damaged, wider or higher than
     *                     16384 pixels or of more than 2²⁶ pixels (which the header tells, before anything is decoded);
     *                     the message is a sentence for the user that begins with the file's name
     */
    public static Film read(Path file) throws IOException {
        ImageFormat format = ImageFormat.of(file);
        if (!Files.isRegularFile(file)) {
            throw new IOException(Quote.path(file) + ": " + (Files.exists(file) ? "is no file" : "no such file"));
        }
        try {
            return format.read(file);
        } catch (IOException e) {
            throw new IOException(Quote.path(file) + ": " + e.getMessage(), e);
        }
    }
}
