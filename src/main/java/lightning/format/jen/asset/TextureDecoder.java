package lightning.format.jen.asset;

import static java.util.Objects.requireNonNull;

import java.awt.color.ColorSpace;
import java.awt.image.BufferedImage;
import java.awt.image.IndexColorModel;
import java.awt.image.Raster;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Iterator;
import java.util.Locale;
import java.util.Set;
import javax.imageio.ImageIO;
import javax.imageio.ImageReadParam;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;
import javax.imageio.stream.MemoryCacheImageInputStream;
import lightning.base.file.RegularFile;
import lightning.base.math.SrgbCurve;
import lightning.base.text.Quote;
import lightning.scene.asset.Texture;
import lightning.scene.asset.TextureUsage;

/**
 * Decoder for PNG and JPEG files to linear light.
 *
 * <p>Color samples s are interpreted as sRGB in 0…1, regardless of the file's color profile, and decoded by {@link
 * SrgbCurve} in double, rounded once to float; numeric samples are not decoded. Four inks are converted without a profile. Transparency is ignored unless requested; a
 * gray sample applies to all channels.
 */
public final class TextureDecoder {
    private static final Set<String> FORMATS = Set.of("png", "jpeg");
    private static final int CODE_BITS = 8;

    private TextureDecoder() {}

    /**
     * Reads the content of a file.
     *
     * @param name name of the file in messages
     * @throws UnusableFileException if it has more than {@link JenLimits#TEXTURE_BYTES}
     * @throws IOException if it cannot be read
     */
    static byte[] readFile(String name, Path path) throws IOException, UnusableFileException {
        long bytes = Files.size(path);
        if (bytes > JenLimits.TEXTURE_BYTES) {
            throw unusable(name, "must have at most " + JenLimits.TEXTURE_BYTES + " bytes, has " + bytes);
        }
        return RegularFile.readBytes(path, "a PNG or JPEG file", JenLimits.TEXTURE_BYTES);
    }

    /**
     * Decodes the samples of an image as numbers from 0 to 1.
     *
     * @param name name of the file in messages
     * @throws UnusableFileException if it is not a PNG or JPEG, too large or damaged
     */
    public static Texture decodeNumbers(String name, byte[] file) throws UnusableFileException {
        return decode(name, file, TextureUsage.DATA);
    }

    /**
     * Decodes an image in linear light, with the limits of textures.
     *
     * @param name name of the file in messages
     * @throws UnusableFileException if it is not a PNG or JPEG, too large or damaged
     */
    public static Texture decodeColors(String name, byte[] file) throws UnusableFileException {
        return decode(name, file, TextureUsage.COLOR);
    }

    /**
     * Decodes an image. One of too many pixels loses rows and columns until it has at most {@link JenLimits#TEXTURE_PIXELS}.
     *
     * @param name name of the file in messages
     * @throws UnusableFileException if it is not a PNG or JPEG, too large or damaged
     */
    public static Texture decodeReduced(String name, byte[] file, TextureUsage samples) throws UnusableFileException {
        return decodeReduced(name, file, samples, JenLimits.TEXTURE_PIXELS);
    }

    /**
     * Decodes an image. One of too many pixels loses rows and columns.
     *
     * @param name name of the file in messages
     * @param maxPixels maximum number of pixels
     * @throws UnusableFileException if it is not a PNG or JPEG, too large or damaged, or {@code maxPixels} is 0
     */
    static Texture decodeReduced(String name, byte[] file, TextureUsage samples, long maxPixels) throws UnusableFileException {
        if (maxPixels < 1) {
            throw unusable(name,
                    "exceeds the limit: all textures together must have at most " + JenLimits.TOTAL_TEXTURE_PIXELS + " pixels");
        }
        return read(name, file, reader -> texture(readReduced(name, reader, maxPixels), samples));
    }

    /**
     * Reads an opened image. One of too many pixels loses rows and columns until it has at most {@link JenLimits#TEXTURE_PIXELS}.
     *
     * @param name name of the file in messages
     * @throws UnusableFileException if a side is longer than that of a texture may be
     */
    public static BufferedImage readReduced(String name, ImageReader reader) throws IOException, UnusableFileException {
        return readReduced(name, reader, JenLimits.TEXTURE_PIXELS);
    }

    private static BufferedImage readReduced(String name, ImageReader reader, long maxPixels) throws IOException, UnusableFileException {
        checkSides(name, reader.getWidth(0), reader.getHeight(0));
        ImageReadParam reduction = reader.getDefaultReadParam();
        int step = step(reader.getWidth(0), reader.getHeight(0), maxPixels);
        reduction.setSourceSubsampling(step, step, 0, 0);
        return reader.read(0, reduction);
    }

    /** Returns the smallest step in which rows and columns of an image have at most {@code maxPixels} pixels. */
    public static int step(int width, int height, long maxPixels) {
        int step = 1;
        while ((long) Math.ceilDiv(width, step) * Math.ceilDiv(height, step) > maxPixels) {
            step++;
        }
        return step;
    }

    /**
     * Returns the number of pixels of an image.
     *
     * @param name name of the file in messages
     * @throws UnusableFileException if it is not a PNG or JPEG, or damaged
     */
    public static long pixels(String name, byte[] file) throws UnusableFileException {
        return read(name, file, reader -> (long) reader.getWidth(0) * reader.getHeight(0));
    }

    /** Decodes an image of the size that a texture may have. */
    static Texture decode(String name, byte[] file, TextureUsage samples) throws UnusableFileException {
        return read(name, file, reader -> {
            checkSize(name, reader.getWidth(0), reader.getHeight(0));
            return texture(reader.read(0), samples);
        });
    }

    /** Reads a value from an image file. */
    @FunctionalInterface
    public interface Reading<T> {
        /** Returns the value of an opened file. */
        T from(ImageReader reader) throws IOException, UnusableFileException;
    }

    /**
     * Opens an image that a decoder reads in bounded time per pixel, and reads a value from it.
     *
     * @param name name of the file in messages
     * @throws UnusableFileException if it is not a PNG or JPEG, damaged, or has too many scans
     */
    public static <T> T read(String name, byte[] file, Reading<T> reading) throws UnusableFileException {
        return read(name, file, FORMATS, reading);
    }

    /**
     * Opens an image of some formats, and reads a value from it.
     *
     * @param name name of the file in messages
     * @param formats names of the formats as Java's image decoders have them, in lower case
     * @throws UnusableFileException if it has none of the formats, is damaged, or has too many scans
     */
    public static <T> T read(String name, byte[] file, Set<String> formats, Reading<T> reading) throws UnusableFileException {
        try (ImageInputStream in = new MemoryCacheImageInputStream(new ByteArrayInputStream(file))) {
            ImageReader reader = reader(name, in, formats);
            try {
                reader.setInput(in, true, true);
                checkScans(name, file, reader);
                return reading.from(reader);
            } catch (IOException | RuntimeException e) {
                // The decoders throw arbitrary runtime exceptions for some damaged files.
                throw unusable(name, "cannot be decoded: " + e.getMessage());
            } finally {
                reader.dispose();
            }
        } catch (IOException e) {
            throw unusable(name, "cannot be decoded: " + e.getMessage());
        }
    }

    private static ImageReader reader(String name, ImageInputStream in, Set<String> formats)
            throws IOException, UnusableFileException {
        Iterator<ImageReader> readers = ImageIO.getImageReaders(in);
        while (readers.hasNext()) {
            ImageReader reader = readers.next();
            if (formats.contains(reader.getFormatName().toLowerCase(Locale.ROOT))) {
                return reader;
            }
            reader.dispose();
        }
        throw unusable(name, "must be a PNG or JPEG file, found an unsupported format");
    }

    private static void checkScans(String name, byte[] file, ImageReader reader) throws IOException, UnusableFileException {
        int scans = JpegScans.count(file);
        if (scans > 1) {
            long limit = JpegScans.limit((long) reader.getWidth(0) * reader.getHeight(0));
            if (scans > limit) {
                throw unusable(name, "must have at most " + limit + " scans at " + reader.getWidth(0) + "×" + reader.getHeight(0)
                        + " pixels, has " + scans);
            }
        }
    }

    private static void checkSides(String name, int width, int height) throws UnusableFileException {
        if (width < 1 || height < 1 || width > JenLimits.TEXTURE_SIDE || height > JenLimits.TEXTURE_SIDE) {
            throw unusable(name, "must have from 1 to " + JenLimits.TEXTURE_SIDE + " pixels along each side, has "
                    + width + "×" + height);
        }
    }

    private static void checkSize(String name, int width, int height) throws UnusableFileException {
        checkSides(name, width, height);
        long pixels = (long) width * height;
        if (pixels > JenLimits.TEXTURE_PIXELS) {
            throw unusable(name, "must have at most " + JenLimits.TEXTURE_PIXELS + " pixels, has " + width + "×" + height);
        }
    }

    private static UnusableFileException unusable(String name, String reason) {
        return new UnusableFileException("texture " + Quote.of(name) + " " + reason);
    }

    private static Texture texture(BufferedImage image, TextureUsage samples) {
        return switch (samples) {
            case COLOR, EMISSION -> texture(image, true);
            case DATA -> texture(image, false);
            case OPACITY -> opacity(image);
        };
    }

    /** Returns the opacity of each pixel, from 8-bit samples. */
    private static Texture opacity(BufferedImage image) {
        int width = image.getWidth();
        int height = image.getHeight();
        byte[] codes = new byte[3 * width * height];
        Texture numbers = image.getColorModel().hasAlpha() ? null : texture(image, false);
        int[] alpha = image.getColorModel().hasAlpha() ? alpha(image) : null;
        for (int i = 0; i < codes.length; i++) {
            int x = i / 3 % width;
            int y = i / 3 / width;
            codes[i] = (byte) (alpha != null ? alpha[i / 3] : Math.round(255 * requireNonNull(numbers).luminance(x, y, x, y, 0, 0)));
        }
        return new Texture(width, height, codes, linearTable(CODE_BITS, false));
    }

    /** Returns the alpha of each pixel, 0 … 255. */
    private static int[] alpha(BufferedImage image) {
        int[] alpha = new int[image.getWidth() * image.getHeight()];
        for (int i = 0; i < alpha.length; i++) {
            alpha[i] = image.getColorModel().getAlpha(image.getRaster().getDataElements(i % image.getWidth(), i / image.getWidth(), null));
        }
        return alpha;
    }

    /** Returns true if an image has alpha; false if it cannot be decoded. */
    public static boolean hasAlpha(byte[] file) {
        try (ImageInputStream in = new MemoryCacheImageInputStream(new ByteArrayInputStream(file))) {
            ImageReader reader = reader("", in, FORMATS);
            try {
                reader.setInput(in, true, true);
                // Not the raw type: a gray or RGB image may have a color that counts as transparent.
                return reader.getImageTypes(0).next().getColorModel().hasAlpha();
            } finally {
                reader.dispose();
            }
        } catch (IOException | RuntimeException | UnusableFileException e) {
            return false;
        }
    }

    private static Texture texture(BufferedImage image, boolean isColor) {
        int width = image.getWidth();
        int height = image.getHeight();
        if (image.getColorModel().getColorSpace().getType() == ColorSpace.TYPE_CMYK) {
            return new Texture(width, height, inkCodes(image.getRaster()), linearTable(CODE_BITS, isColor));
        }
        if (image.getColorModel() instanceof IndexColorModel) {
            return new Texture(width, height, paletteCodes(image), linearTable(CODE_BITS, isColor));
        }
        // Do not use getRGB: it treats gray samples as linear light and applies color profiles.
        Raster raster = image.getRaster();
        int bits = Arrays.stream(raster.getSampleModel().getSampleSize()).max().orElseThrow();
        boolean oneSize = Arrays.stream(raster.getSampleModel().getSampleSize()).allMatch(size -> size == bits);
        if (oneSize && bits <= CODE_BITS) {
            byte[] codes = new byte[3 * width * height];
            forEachSample(raster, (i, _, sample) -> codes[i] = (byte) sample);
            return new Texture(width, height, codes, Arrays.copyOf(linearTable(bits, isColor), 1 << CODE_BITS));
        }
        float[][] linear = new float[raster.getNumBands()][];
        Arrays.setAll(linear, band -> linearTable(raster.getSampleModel().getSampleSize(band), isColor));
        float[] rgb = new float[3 * width * height];
        forEachSample(raster, (i, band, sample) -> rgb[i] = linear[band][sample]);
        return new Texture(width, height, rgb);
    }

    /** Returns red, green and blue of an image of four inks, 0 … 255 for each. */
    private static byte[] inkCodes(Raster raster) {
        int width = raster.getWidth();
        byte[] codes = new byte[3 * width * raster.getHeight()];
        int[] row = new int[4 * width];
        for (int y = 0; y < raster.getHeight(); y++) {
            raster.getPixels(0, y, width, 1, row);
            for (int x = 0; x < width; x++) {
                for (int c = 0; c < 3; c++) {
                    codes[3 * (y * width + x) + c] = (byte) Math.round((255 - row[4 * x + c]) * (255 - row[4 * x + 3]) / 255f);
                }
            }
        }
        return codes;
    }

    private static byte[] paletteCodes(BufferedImage image) {
        int width = image.getWidth();
        byte[] codes = new byte[3 * width * image.getHeight()];
        for (int i = 0; i < codes.length / 3; i++) {
            int pixel = image.getRGB(i % width, i / width);
            codes[3 * i] = (byte) (pixel >> 16);
            codes[3 * i + 1] = (byte) (pixel >> 8);
            codes[3 * i + 2] = (byte) pixel;
        }
        return codes;
    }

    /** Receives each channel of each pixel. */
    @FunctionalInterface
    private interface SampleConsumer {
        /**
         * Receives a sample.
         *
         * @param i index among {@code 3 * width * height} values
         */
        void accept(int i, int band, int sample);
    }

    /** Visits all samples, channel by channel; a gray image has one band for all three channels. */
    private static void forEachSample(Raster raster, SampleConsumer consumer) {
        int width = raster.getWidth();
        int bands = raster.getNumBands() < 3 ? 1 : 3;
        int[] row = new int[width];
        for (int channel = 0; channel < 3; channel++) {
            int band = Math.min(channel, bands - 1);
            for (int y = 0; y < raster.getHeight(); y++) {
                raster.getSamples(0, y, width, 1, band, row);
                for (int x = 0; x < width; x++) {
                    consumer.accept(3 * (y * width + x) + channel, band, row[x]);
                }
            }
        }
    }

    /** Returns the linear value of each sample with the given number of bits, {@code float[2^bits]}. */
    private static float[] linearTable(int bits, boolean color) {
        int max = (1 << bits) - 1;
        float[] linear = new float[max + 1];
        for (int i = 0; i <= max; i++) {
            double s = (double) i / max;
            linear[i] = (float) (color ? SrgbCurve.toLinear(s) : s);
        }
        return linear;
    }
}
