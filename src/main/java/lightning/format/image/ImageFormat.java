package lightning.format.image;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import lightning.base.file.AtomicFile;
import lightning.base.text.Quote;
import lightning.base.work.WorkerPool;
import lightning.format.exr.ExrHeader;
import lightning.format.exr.ExrType;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;

/** The formats in which pictures are written; the ending of a file's name says which. */
public enum ImageFormat {
    /** sRGB, as the picture is displayed. */
    PNG("PNG", true, 8, 16) {
        @Override
        void write(Path file, Film film, ViewTransform view, int bits, WorkerPool workers) throws IOException {
            AtomicFile.write(file, out -> Png.write(out, film, view, bits, workers));
        }

        @Override
        Film read(Path file) throws IOException {
            return Png.read(file);
        }

        @Override
        public long bytesToWrite(int width, int height) {
            return Png.bytesToWrite(width);
        }
    },
    /** sRGB as text, as the picture is displayed. Written only. */
    XPM("XPM, as in 1998", true, 8) {
        @Override
        void write(Path file, Film film, ViewTransform view, int bits, WorkerPool workers) throws IOException {
            AtomicFile.write(file, out -> Xpm.write(out, film.width(), film.height(), view.toPixels(film)));
        }

        @Override
        Film read(Path file) throws IOException {
            throw new IOException("is an XPM picture, which can be written but not read");
        }

        /** The display pixels four times, as they are sorted for the palette: streams of whole numbers collect them in buffers that double. */
        @Override
        public long bytesToWrite(int width, int height) {
            return 4L * Integer.BYTES * width * height;
        }
    },
    /** The linear film, every bit. */
    PFM("PFM, linear floats", false, 32) {
        @Override
        void write(Path file, Film film, ViewTransform view, int bits, WorkerPool workers) throws IOException {
            AtomicFile.write(file, out -> Pfm.write(out, film));
        }

        @Override
        Film read(Path file) throws IOException {
            return Pfm.read(file);
        }

        @Override
        public boolean hasFullFloats(Path file) {
            return true;
        }
    },
    /** The linear film, as halves or every bit; with layers if wanted. */
    EXR("OpenEXR", false, 16, 32) {
        @Override
        void write(Path file, Film film, ViewTransform view, int bits, WorkerPool workers) throws IOException {
            AtomicFile.of(file).writeRandomAccess(to -> Exr.write(to, film, bits == Short.SIZE ? ExrType.HALF : ExrType.FLOAT));
        }

        @Override
        Film read(Path file) throws IOException {
            return Exr.read(file);
        }

        /** A chunk, its bytes apart, packed, and as they are written. */
        @Override
        public long bytesToWrite(int width, int height) {
            return 4L * 3 * Float.BYTES * width * ExrHeader.LINES_PER_CHUNK;
        }

        @Override
        public boolean hasFullFloats(Path file) throws IOException {
            return Exr.hasFullFloats(file);
        }
    },
    /** The linear film, 8 bits and a shared exponent. Pictures of this format are read as environments. */
    HDR("Radiance HDR", false, 8) {
        @Override
        void write(Path file, Film film, ViewTransform view, int bits, WorkerPool workers) throws IOException {
            AtomicFile.write(file, out -> RadianceHdr.write(out, film));
        }

        @Override
        Film read(Path file) throws IOException {
            throw new IOException("is a Radiance picture, which is not read here");
        }
    };

    private final String title;
    private final boolean isDisplayReferred;
    private final List<Integer> bitDepths;

    ImageFormat(String title, boolean isDisplayReferred, Integer... bitDepths) {
        this.title = title;
        this.isDisplayReferred = isDisplayReferred;
        this.bitDepths = List.of(bitDepths);
    }

    /** @param bits one of {@link #bitDepths} */
    abstract void write(Path file, Film film, ViewTransform view, int bits, WorkerPool workers) throws IOException;

    abstract Film read(Path file) throws IOException;

    /** The bytes that writing takes in addition to the film: those of a row where rows are written one by one. */
    public long bytesToWrite(int width, int height) {
        return 3L * Float.BYTES * width;
    }

    /** Whether a file of this format holds every bit of a float; its header says so where the format has several kinds of numbers. */
    public boolean hasFullFloats(Path file) throws IOException {
        return false;
    }

    /**
     * The format that a file's name asks for.
     *
     * @throws IOException if it is none of these; the message is a sentence for the user
     */
    public static ImageFormat of(Path file) throws IOException {
        return find(file).orElseThrow(() -> new IOException(Quote.path(file) + ": a picture's name must end in " + extensionList()));
    }

    /** The format that a file's name asks for; empty where it is that of no picture. */
    public static Optional<ImageFormat> find(Path file) {
        Path name = file.getFileName();
        String lower = name == null ? "" : name.toString().toLowerCase(Locale.ROOT);
        return Arrays.stream(values()).filter(format -> lower.endsWith(format.extension())).findFirst();
    }

    private static String extensionList() {
        String extensions = Arrays.stream(values()).map(ImageFormat::extension).collect(Collectors.joining(", "));
        int last = extensions.lastIndexOf(", ");
        return extensions.substring(0, last) + " or " + extensions.substring(last + 2);
    }

    /** For people, the same in every language. */
    public String title() {
        return title;
    }

    /** What the names of its files end in, with its point. */
    public String extension() {
        return "." + name().toLowerCase(Locale.ROOT);
    }

    /** Whether a file holds what is displayed, clamped, rather than the film itself. */
    public boolean isDisplayReferred() {
        return isDisplayReferred;
    }

    /** Whether a file can hold layers. */
    public boolean canHaveLayers() {
        return this == EXR;
    }

    /** The bits that a number of a file can have, first those that are usual. */
    public List<Integer> bitDepths() {
        return bitDepths;
    }

    /**
     * Checks bits before a long computation.
     *
     * @throws IOException if a file of this format cannot have them; the message is a sentence for the user
     */
    public void requireBitDepth(Path file, int requested) throws IOException {
        if (!bitDepths.contains(requested)) {
            throw new IOException(Quote.path(file) + ": such a picture has "
                    + bitDepths.stream().map(String::valueOf).collect(Collectors.joining(" or ")) + " bits, not " + requested);
        }
    }
}
