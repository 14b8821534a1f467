package lightning.format.image;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Function;
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

/**
 * File format of images. Written files have the format of their extension. Those without bit depths are read only; so is what Java's decoders
 * recognize, whatever its extension.
 */
public enum ImageFormat {
    /** Display-referred sRGB. */
    PNG("PNG", true, List.of("png"), 8, 16) {
        @Override
        void write(Path file, Film film, ViewTransform view, int bits, WorkerPool workers) throws IOException {
            AtomicFile.write(file, out -> Png.write(out, film, view, bits, workers));
        }

        @Override
        public long bytesToWrite(int width, int height) {
            return Png.bytesToWrite(width);
        }
    },
    /** Display-referred sRGB, with loss. */
    JPEG("JPEG", true, List.of("jpg", "jpeg")),
    /** Display-referred sRGB as C source text. Write-only. */
    XPM("XPM, as in 1998", true, List.of("xpm"), 8) {
        @Override
        void write(Path file, Film film, ViewTransform view, int bits, WorkerPool workers) throws IOException {
            AtomicFile.write(file, out -> Xpm.write(out, film.width(), film.height(), view.toPixels(film)));
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
    PFM("PFM, linear floats", false, List.of("pfm"), 32) {
        @Override
        void write(Path file, Film film, ViewTransform view, int bits, WorkerPool workers) throws IOException {
            AtomicFile.write(file, out -> Pfm.write(out, film));
        }

        @Override
        ImageSource open(Path file, ImageLimits limits) throws IOException {
            return new PfmImage(file);
        }
    },
    /** Linear film as halves or floats, optionally with layers. */
    EXR("OpenEXR", false, List.of("exr"), 16, 32) {
        @Override
        void write(Path file, Film film, ViewTransform view, int bits, WorkerPool workers) throws IOException {
            AtomicFile.of(file).writeRandomAccess(to -> Exr.write(to, film, bits == Short.SIZE ? ExrType.HALF : ExrType.FLOAT,
                    ExrMetadata.common(), ExrPrimaries.REC_709));
        }

        /** Returns the bytes of a chunk, its shuffled bytes, and its compressed and written form. */
        @Override
        public long bytesToWrite(int width, int height) {
            return 4L * 3 * Float.BYTES * width * ExrHeader.LINES_PER_CHUNK;
        }

        @Override
        ImageSource open(Path file, ImageLimits limits) throws IOException {
            return new ExrImage(file);
        }
    },
    /** Linear film with 8-bit mantissas and a shared exponent. */
    HDR("Radiance HDR", false, List.of("hdr"), 8) {
        @Override
        void write(Path file, Film film, ViewTransform view, int bits, WorkerPool workers) throws IOException {
            AtomicFile.write(file, out -> RadianceHdr.write(out, film));
        }

        @Override
        ImageSource open(Path file, ImageLimits limits) throws IOException {
            return new RadianceImage(limits.readBytes(file));
        }
    },
    WEBP("WebP", true, List.of("webp")),
    TGA("Targa", true, List.of("tga")),
    BMP("BMP", true, List.of("bmp")),
    GIF("GIF", true, List.of("gif")),
    TIFF("TIFF", true, List.of("tiff", "tif"));

    private final String title;
    private final boolean isDisplayReferred;
    private final List<String> extensions;
    private final List<Integer> bitDepths;

    ImageFormat(String title, boolean isDisplayReferred, List<String> extensions, Integer... bitDepths) {
        this.title = title;
        this.isDisplayReferred = isDisplayReferred;
        this.extensions = extensions;
        this.bitDepths = List.of(bitDepths);
    }

    /**
     * Writes a film.
     *
     * @param bits one of {@link #bitDepths}
     */
    void write(Path file, Film film, ViewTransform view, int bits, WorkerPool workers) throws IOException {
        throw new IllegalStateException(this + " is read only");
    }

    /**
     * Opens a file to read it; of the formats of {@code limits} that Java's decoders know, its content decides.
     *
     * @throws IOException if it has another format, or is damaged; the message does not contain its name
     */
    ImageSource open(Path file, ImageLimits limits) throws IOException {
        return new CodedImage(limits.readBytes(file), limits.formats());
    }

    /** Returns the memory in bytes that writing takes in addition to the film: one row for formats written row by row. */
    public long bytesToWrite(int width, int height) {
        return 3L * Float.BYTES * width;
    }

    /** Returns the formats that can be written. */
    public static List<ImageFormat> written() {
        return Arrays.stream(values()).filter(format -> !format.bitDepths.isEmpty()).toList();
    }

    /**
     * Returns the format to write for a file's extension.
     *
     * @throws IOException if the extension is unknown; the message is a sentence for the user
     */
    public static ImageFormat of(Path file) throws IOException {
        return of(file, written());
    }

    /**
     * Returns the format of some for a file's extension.
     *
     * @throws IOException if none has it; the message is a sentence for the user
     */
    static ImageFormat of(Path file, List<ImageFormat> formats) throws IOException {
        return find(file, formats).orElseThrow(() -> new IOException(
                Quote.path(file) + ": an image's name must end in " + alternatives(formats, ImageFormat::extension)));
    }

    /** Returns the format to write for a file's extension; empty if it is unknown. */
    public static Optional<ImageFormat> find(Path file) {
        return find(file, written());
    }

    private static Optional<ImageFormat> find(Path file, List<ImageFormat> formats) {
        return formats.stream().filter(format -> format.isNamed(file.toString())).findFirst();
    }

    /** Returns whether a file of this name has the extension of the format. */
    boolean isNamed(String name) {
        String lower = name.toLowerCase(Locale.ROOT);
        return extensions.stream().anyMatch(extension -> lower.endsWith("." + extension));
    }

    /** Returns a list such as {@code .png, .exr or .hdr}. */
    static String alternatives(List<ImageFormat> formats, Function<ImageFormat, String> text) {
        String all = formats.stream().map(text).collect(Collectors.joining(", "));
        int last = all.lastIndexOf(", ");
        return last < 0 ? all : all.substring(0, last) + " or " + all.substring(last + 2);
    }

    /** Returns the display name, language-independent. */
    public String title() {
        return title;
    }

    /** Returns the file extension of a written file, with its dot. */
    public String extension() {
        return "." + extensions.getFirst();
    }

    /** Returns the file extensions, without dots. */
    List<String> extensions() {
        return extensions;
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
