package lightning.image;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;
import java.util.stream.Collectors;
import lightning.file.SafeFile;
import lightning.text.Quote;

/**
 * Picture files; the extension decides what they hold.
 *
 * <table>
 * <caption>Formats</caption>
 * <tr><th>extension</th><th>holds</th><th>view transform</th></tr>
 * <tr><td>.png</td><td>8-bit sRGB</td><td>applied</td></tr>
 * <tr><td>.xpm</td><td>8-bit sRGB, as text</td><td>applied</td></tr>
 * <tr><td>.pfm</td><td>the linear film, every bit</td><td>not applied</td></tr>
 * </table>
 */
public final class PictureFile {

    private enum Format {
        PNG, XPM, PFM;

        String extension() {
            return "." + name().toLowerCase(Locale.ROOT);
        }
    }

    private PictureFile() {}

    /** The extensions that can be written and read, as in {@code .png, .xpm or .pfm}. */
    public static String extensions() {
        String all = Arrays.stream(Format.values()).map(Format::extension).collect(Collectors.joining(", "));
        int last = all.lastIndexOf(", ");
        return all.substring(0, last) + " or " + all.substring(last + 2);
    }

    /**
     * Checks a name before a long computation, whose result could not be written under it.
     *
     * @throws IOException if the extension is none of {@link #extensions()}; the message is a sentence for the user
     */
    public static void requireKnownExtension(Path file) throws IOException {
        formatOf(file);
    }

    /**
     * Whether a file of this name holds what is displayed, clamped to 8 bits, rather than the film itself.
     *
     * @throws IOException if the extension is none of {@link #extensions()}
     */
    public static boolean isDisplayed(Path file) throws IOException {
        return switch (formatOf(file)) {
            case PNG, XPM -> true;
            case PFM -> false;
        };
    }

    /**
     * The bytes that writing takes beside the film: of PNG the display pixels, of XPM those four times, as they are sorted for the
     * palette (streams of whole numbers collect them in buffers that double); PFM is written row by row.
     *
     * @throws IOException if the extension is none of {@link #extensions()}
     */
    public static long bytesToWrite(Path file, int width, int height) throws IOException {
        long pixels = (long) Integer.BYTES * width * height;
        return switch (formatOf(file)) {
            case PNG -> pixels;
            case XPM -> 4 * pixels;
            case PFM -> 3L * Float.BYTES * width;
        };
    }

    /**
     * Writes a film; {@code file} holds the whole new picture or what it held before, at every moment.
     *
     * @param view what PNG and XPM show; PFM keeps the linear values and ignores it
     * @throws IOException if the extension is unknown or the file cannot be written
     */
    public static void write(Path file, Film film, ViewTransform view) throws IOException {
        Format format = formatOf(file);
        SafeFile.write(file, out -> {
            switch (format) {
                case PNG -> Png.write(out, film.width(), film.height(), view.toPixels(film));
                case XPM -> Xpm.write(out, film.width(), film.height(), view.toPixels(film));
                case PFM -> Pfm.write(out, film);
            }
        });
    }

    /**
     * Reads a picture as a film: the very floats of a PFM, the linear values 0…1 of the sRGB codes of a PNG or XPM (which
     * {@link ViewTransform#DEFAULT} turns back into the same codes). Transparency is ignored.
     *
     * @throws IOException if the extension is unknown, the file is missing, unreadable, damaged, wider or higher than
     *                     16384 pixels or of more than 2²⁶ pixels (which the header tells, before anything is decoded);
     *                     the message is a sentence for the user that begins with the file's name
     */
    public static Film read(Path file) throws IOException {
        Format format = formatOf(file);
        if (!Files.isRegularFile(file)) {
            throw new IOException(Quote.path(file) + ": " + (Files.exists(file) ? "is no file" : "no such file"));
        }
        try {
            return switch (format) {
                case PNG -> Png.read(file);
                case XPM -> Xpm.read(file);
                case PFM -> Pfm.read(file);
            };
        } catch (IOException e) {
            throw new IOException(Quote.path(file) + ": " + e.getMessage(), e);
        }
    }

    private static Format formatOf(Path file) throws IOException {
        Path name = file.getFileName();
        String lower = name == null ? "" : name.toString().toLowerCase(Locale.ROOT);
        for (Format format : Format.values()) {
            if (lower.endsWith(format.extension())) {
                return format;
            }
        }
        throw new IOException(Quote.path(file) + ": a picture's name must end in " + extensions());
    }
}
