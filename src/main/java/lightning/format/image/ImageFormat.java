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
import lightning.format.exr.ExrMetadata;
import lightning.format.exr.ExrPrimaries;
import lightning.format.exr.ExrType;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;

/** File format of written images, chosen by the file's extension. */
public enum ImageFormat {
    /** Display-referred sRGB. */
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
    /** Display-referred sRGB as C source text. Write-only. */
    XPM("XPM, as in 1998", true, 8) {
        @Override
        void write(Path file, Film film, ViewTransform view, int bits, WorkerPool workers) throws IOException {
            AtomicFile.write(file, out -> Xpm.write(out, film.width(), film.height(), view.toPixels(film)));
        }

        @Override
        Film read(Path file) throws IOException {
            throw new IOException("is an XPM image, which can be written but not read");
        }

        /**
         * Returns four times the display pixels, for the sorted palette: streams of integers collect them in doubling
         * buffers.
         */
        @Override
        public long bytesToWrite(int width, int height) {
            return 4L * Integer.BYTES * width * height;
        }
    },
    /** Linear film, all bits. */
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
    /** Linear film as halves or floats, optionally with layers. */
    EXR("OpenEXR", false, 16, 32) {
        @Override
        void write(Path file, Film film, ViewTransform view, int bits, WorkerPool workers) throws IOException {
            AtomicFile.of(file).writeRandomAccess(to -> Exr.write(to, film, bits == Short.SIZE ? ExrType.HALF : ExrType.FLOAT,
                    ExrMetadata.common(), ExrPrimaries.REC_709));
        }

        @Override
        Film read(Path file) throws IOException {
            return Exr.read(file);
        }

        /** Returns the bytes of a chunk, its shuffled bytes, and its compressed and written form. */
        @Override
        public long bytesToWrite(int width, int height) {
            return 4L * 3 * Float.BYTES * width * ExrHeader.LINES_PER_CHUNK;
        }

        @Override
        public boolean hasFullFloats(Path file) throws IOException {
            return Exr.hasFullFloats(file);
        }
    },
    /** Linear film with 8-bit mantissas and a shared exponent. Environments are read by another class. */
    HDR("Radiance HDR", false, 8) {
        @Override
        void write(Path file, Film film, ViewTransform view, int bits, WorkerPool workers) throws IOException {
            AtomicFile.write(file, out -> RadianceHdr.write(out, film));
        }

        @Override
        Film read(Path file) throws IOException {
            throw new IOException("is a Radiance HDR image, which cannot be read here");
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

    /**
     * Writes a film.
     *
     * @param bits one of {@link #bitDepths}
     */
    abstract void write(Path file, Film film, ViewTransform view, int bits, WorkerPool workers) throws IOException;

    abstract Film read(Path file) throws IOException;

    /** Returns the memory in bytes that writing takes in addition to the film: one row for formats written row by row. */
    public long bytesToWrite(int width, int height) {
        return 3L * Float.BYTES * width;
    }

    /**
     * Returns whether a file of this format stores all bits of a float; reads the header if the format has several number
     * types.
     */
    public boolean hasFullFloats(Path file) throws IOException {
        return false;
    }

    /**
     * Returns the format for a file's extension.
     *
     * @throws IOException if the extension is unknown; the message is a sentence for the user
     */
    public static ImageFormat of(Path file) throws IOException {
        return find(file).orElseThrow(() -> new IOException(Quote.path(file) + ": an image's name must end in " + extensionList()));
    }

    /** Returns the format for a file's extension; empty if it is unknown. */
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

    /** Returns the display name, language-independent. */
    public String title() {
        return title;
    }

    /** Returns the file extension, with its dot. */
    public String extension() {
        return "." + name().toLowerCase(Locale.ROOT);
    }

    /** Returns whether a file stores clamped display values instead of the linear film. */
    public boolean isDisplayReferred() {
        return isDisplayReferred;
    }

    /** Returns whether the format supports layers. */
    public boolean canHaveLayers() {
        return this == EXR;
    }

    /** Returns the supported bits per channel, default first. */
    public List<Integer> bitDepths() {
        return bitDepths;
    }

    /**
     * Checks a bit depth, before a long computation.
     *
     * @throws IOException if the format does not support it; the message is a sentence for the user
     */
    public void requireBitDepth(Path file, int requested) throws IOException {
        if (!bitDepths.contains(requested)) {
            throw new IOException(Quote.path(file) + ": this format has "
                    + bitDepths.stream().map(String::valueOf).collect(Collectors.joining(" or ")) + " bits, not " + requested);
        }
    }
}
