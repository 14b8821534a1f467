package lightning.format.picture;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import lightning.base.file.SafeFile;
import lightning.base.text.Quote;
import lightning.base.work.Workers;
import lightning.format.exr.ExrHeader;
import lightning.format.exr.ExrType;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;

/**
 * Picture files; the extension decides what they hold.
 *
 * <table>
 * <caption>Formats</caption>
 * <tr><th>extension</th><th>holds</th><th>view transform</th></tr>
 * <tr><td>.png</td><td>sRGB of 8 or 16 bits</td><td>applied</td></tr>
 * <tr><td>.xpm</td><td>8-bit sRGB, as text</td><td>applied</td></tr>
 * <tr><td>.pfm</td><td>the linear film, every bit</td><td>not applied</td></tr>
 * <tr><td>.exr</td><td>the linear film, as half or every bit</td><td>not applied</td></tr>
 * <tr><td>.hdr</td><td>the linear film, 8 bits and a shared exponent</td><td>not applied</td></tr>
 * </table>
 *
 * <p>Where a format has several kinds of numbers, the bits of one tell which ({@link #bits}): a PNG has 8 or 16, OpenEXR 16 or 32.
 */
public final class PictureFile {

    private enum Format {
        PNG(8, 16), XPM(8), PFM(32), EXR(16, 32), HDR(8);

        private final List<Integer> bits;

        Format(Integer... bits) {
            this.bits = List.of(bits);
        }

        String extension() {
            return "." + name().toLowerCase(Locale.ROOT);
        }
    }

    private PictureFile() {}

    /** The extensions that can be written, as in {@code .png, .xpm or .pfm}. */
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
            case PFM, EXR, HDR -> false;
        };
    }

    /** The same of a name that was written; false where it is that of no picture. */
    public static boolean isShown(Path file) {
        try {
            return isDisplayed(file);
        } catch (IOException e) {
            return false;
        }
    }

    /**
     * The bits that a number of a file of this name can have, first those that are usual.
     *
     * @throws IOException if the extension is none of {@link #extensions()}
     */
    public static List<Integer> bits(Path file) throws IOException {
        return formatOf(file).bits;
    }

    /**
     * Checks bits before a long computation.
     *
     * @throws IOException if a file of this name cannot have them; the message is a sentence for the user
     */
    public static void requireBits(Path file, int bits) throws IOException {
        List<Integer> can = bits(file);
        if (!can.contains(bits)) {
            throw new IOException(Quote.path(file) + ": such a picture has "
                    + can.stream().map(String::valueOf).collect(Collectors.joining(" or ")) + " bits, not " + bits);
        }
    }

    /** Whether a file of this name can hold layers. */
    public static boolean canHaveLayers(Path file) throws IOException {
        return formatOf(file) == Format.EXR;
    }

    /**
     * The bytes that writing takes beside the film: of XPM the display pixels four times, as they are sorted for the
     * palette (streams of whole numbers collect them in buffers that double); the others are written by rows.
     *
     * @throws IOException if the extension is none of {@link #extensions()}
     */
    public static long bytesToWrite(Path file, int width, int height) throws IOException {
        long pixels = (long) Integer.BYTES * width * height;
        return switch (formatOf(file)) {
            case PNG -> Png.bytesToWrite(width);
            case XPM -> 4 * pixels;
            case PFM, HDR -> 3L * Float.BYTES * width;
            // A chunk, its bytes apart, packed, and as they are written.
            case EXR -> 4L * 3 * Float.BYTES * width * ExrHeader.LINES;
        };
    }

    /**
     * Writes a film with the bits that are usual; {@code file} holds the whole new picture or what it held before, at every moment.
     *
     * @param view what PNG and XPM show; the others keep the linear values and ignore it
     * @throws IOException if the extension is unknown or the file cannot be written
     */
    public static void write(Path file, Film film, ViewTransform view) throws IOException {
        write(file, film, view, bits(file).getFirst());
    }

    /**
     * Writes a film.
     *
     * @param bits of a number, one of {@link #bits(Path)}
     * @throws IOException as {@link #write(Path, Film, ViewTransform)}, and as {@link #requireBits}
     */
    public static void write(Path file, Film film, ViewTransform view, int bits) throws IOException {
        try (Workers alone = new Workers(1)) {
            write(file, film, view, bits, alone);
        }
    }

    /**
     * Writes a film, of a PNG with the help of workers; the file is the same for any number of them.
     *
     * @param bits of a number, one of {@link #bits(Path)}
     * @throws IOException as {@link #write(Path, Film, ViewTransform)}, and as {@link #requireBits}
     */
    public static void write(Path file, Film film, ViewTransform view, int bits, Workers workers) throws IOException {
        requireBits(file, bits);
        switch (formatOf(file)) {
            case PNG -> SafeFile.write(file, out -> Png.write(out, film, view, bits, workers));
            case XPM -> SafeFile.write(file, out -> Xpm.write(out, film.width(), film.height(), view.toPixels(film)));
            case PFM -> SafeFile.write(file, out -> Pfm.write(out, film));
            case EXR -> SafeFile.at(file).writeAnywhere(to -> Exr.write(to, film, bits == Short.SIZE ? ExrType.HALF : ExrType.FLOAT));
            case HDR -> SafeFile.write(file, out -> Radiance.write(out, film));
        }
    }

    /**
     * Reads a picture as a film: the very floats of a PFM or OpenEXR, the linear values 0…1 of the sRGB codes of a PNG or XPM (which
     * {@link ViewTransform#DEFAULT} turns back into the same codes). Transparency is ignored. Radiance's pictures are read elsewhere.
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
                case EXR -> Exr.read(file);
                case HDR -> throw new IOException("is a Radiance picture, which is not read here");
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
