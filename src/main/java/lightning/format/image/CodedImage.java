package lightning.format.image;

import java.awt.color.ColorSpace;
import java.awt.image.BufferedImage;
import java.awt.image.ColorModel;
import java.awt.image.IndexColorModel;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.Arrays;
import java.util.Iterator;
import java.util.List;
import java.util.Locale;
import java.util.stream.IntStream;
import javax.imageio.ImageIO;
import javax.imageio.ImageReadParam;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;
import javax.imageio.stream.MemoryCacheImageInputStream;
import lightning.base.math.SrgbCurve;
import lightning.scene.asset.Texture;
import lightning.scene.asset.TextureUsage;

/**
 * Image of integer codes: PNG, JPEG and what else Java's decoders read.
 *
 * <p>Color samples s are interpreted as sRGB in 0…1, regardless of the file's color profile, and decoded by {@link
 * SrgbCurve} in double, rounded once to float; numeric samples are not decoded. Four inks are converted without a profile. Transparency is
 * ignored unless requested; a gray sample applies to all channels.
 */
final class CodedImage extends ImageSource {
    private static final int CODE_BITS = 8;
    private static final int CHANNELS = 3;

    private final byte[] file;
    private final ImageReader reader;
    private final int width;
    private final int height;

    /**
     * Opens a file of some formats.
     *
     * @throws IOException if it has none of the formats, or is damaged
     */
    CodedImage(byte[] file, List<ImageFormat> formats) throws IOException {
        this.file = file;
        reader = reader(file, formats);
        width = decoded(() -> reader.getWidth(0));
        height = decoded(() -> reader.getHeight(0));
    }

    private static ImageReader reader(byte[] file, List<ImageFormat> formats) throws IOException {
        if (WebpSize.isWebp(file) && !WebpSize.isPlausible(file)) {
            throw new IOException("cannot be decoded: it has fewer pixels than its header says, or more than fit into the memory");
        }
        ImageInputStream in = new MemoryCacheImageInputStream(new ByteArrayInputStream(file));
        Iterator<ImageReader> readers = ImageIO.getImageReaders(in);
        while (readers.hasNext()) {
            ImageReader reader = readers.next();
            String name = reader.getFormatName().toUpperCase(Locale.ROOT);
            if (formats.stream().anyMatch(format -> name.equals(format.name()) || name.equals("TIF") && format == ImageFormat.TIFF)) {
                reader.setInput(in, false, true);
                return reader;
            }
            reader.dispose();
        }
        List<ImageFormat> coded = formats.stream().filter(ImageFormat::isDisplayReferred).toList();
        throw new IOException("must be a " + ImageFormat.alternatives(coded, ImageFormat::title) + " file, found an unsupported format");
    }

    /** Computation by a decoder. */
    private interface Decoding<T> {
        T result() throws IOException;
    }

    /** Returns the result of a decoder. Some throw arbitrary runtime exceptions for damaged files. */
    private static <T> T decoded(Decoding<T> decoding) throws IOException {
        try {
            return decoding.result();
        } catch (IOException | RuntimeException e) {
            throw new IOException("cannot be decoded: " + e.getMessage(), e);
        }
    }

    @Override
    public int width() {
        return width;
    }

    @Override
    public int height() {
        return height;
    }

    @Override
    public boolean isDisplayReferred() {
        return true;
    }

    @Override
    public boolean hasAlpha() throws IOException {
        // Not the raw type: a gray or RGB image may have a color that counts as transparent.
        return decoded(() -> reader.getImageTypes(0).next().getColorModel().hasAlpha());
    }

    @Override
    void check() throws IOException {
        int scans = JpegScans.count(file);
        long limit = JpegScans.limit(pixelCount());
        if (scans > limit) {
            throw new IOException("must have at most " + limit + " scans at " + width + "×" + height + " pixels, has " + scans);
        }
    }

    private BufferedImage decode(int step) throws IOException {
        ImageReadParam reduction = reader.getDefaultReadParam();
        reduction.setSourceSubsampling(step, step, 0, 0);
        return decoded(() -> reader.read(0, reduction));
    }

    @Override
    Pixels pixels(TextureUsage usage) throws IOException {
        var samples = new Samples(decode(1));
        float[][] linear = samples.linear(usage != TextureUsage.DATA);
        float[] rgb = new float[CHANNELS];
        return sink -> samples.forEachRow((y, row) -> {
            for (int i = 0; i < row.length; i++) {
                rgb[i % CHANNELS] = linear[i % CHANNELS][row[i]];
                if (i % CHANNELS == CHANNELS - 1) {
                    sink.accept(i / CHANNELS, y, rgb);
                }
            }
        });
    }

    /** Decodes the image, and stores codes of up to 8 bits as such: a quarter of the memory. */
    @Override
    public Texture texture(TextureUsage usage, int step, float min) throws IOException {
        BufferedImage image = decode(step);
        return usage == TextureUsage.OPACITY ? opacity(image) : texture(image, usage != TextureUsage.DATA);
    }

    private static Texture texture(BufferedImage image, boolean isColor) {
        var samples = new Samples(image);
        int length = CHANNELS * image.getWidth();
        float[][] linear = samples.linear(isColor);
        if (Arrays.stream(samples.bits).allMatch(bits -> bits == samples.bits[0] && bits <= CODE_BITS)) {
            byte[] codes = new byte[length * image.getHeight()];
            samples.forEachRow((y, row) -> {
                for (int i = 0; i < length; i++) {
                    codes[y * length + i] = (byte) row[i];
                }
            });
            return new Texture(image.getWidth(), image.getHeight(), codes, Arrays.copyOf(linear[0], 1 << CODE_BITS));
        }
        float[] rgb = new float[length * image.getHeight()];
        samples.forEachRow((y, row) -> {
            for (int i = 0; i < length; i++) {
                rgb[y * length + i] = linear[i % CHANNELS][row[i]];
            }
        });
        return new Texture(image.getWidth(), image.getHeight(), rgb);
    }

    /** Returns the opacity of each pixel, from 8-bit samples. */
    private static Texture opacity(BufferedImage image) {
        int width = image.getWidth();
        byte[] codes = new byte[CHANNELS * width * image.getHeight()];
        ColorModel model = image.getColorModel();
        Texture numbers = texture(image, false);
        for (int i = 0; i < codes.length; i++) {
            int x = i / CHANNELS % width;
            int y = i / CHANNELS / width;
            codes[i] = (byte) (model.hasAlpha() ? model.getAlpha(image.getRaster().getDataElements(x, y, null))
                    : Math.round(255 * numbers.luminance(x, y, x, y, 0, 0)));
        }
        return new Texture(width, image.getHeight(), codes, linearTable(CODE_BITS, false));
    }

    /** Returns every n-th pixel of every n-th row as a PNG file, with alpha. */
    byte[] png(int step) throws IOException {
        BufferedImage image = decode(step);
        // The encoder fails with a runtime exception too, if the image has no bits.
        return decoded(() -> {
            var out = new ByteArrayOutputStream();
            if (!ImageIO.write(image, "png", out)) {
                var plain = new BufferedImage(image.getWidth(), image.getHeight(),
                        image.getColorModel().hasAlpha() ? BufferedImage.TYPE_INT_ARGB : BufferedImage.TYPE_INT_RGB);
                plain.getGraphics().drawImage(image, 0, 0, null);
                ImageIO.write(plain, "png", out);
            }
            return out.toByteArray();
        });
    }

    /** Red, green and blue of a decoded image as codes. */
    private static final class Samples {
        private final BufferedImage image;
        /** Bits of a code of each channel. */
        private final int[] bits = {CODE_BITS, CODE_BITS, CODE_BITS};
        private final RowReader reader;

        /** Reads or receives the codes of a row. */
        private interface RowReader {
            /** @param codes {@code int[3 * width]}; reused */
            void accept(int y, int[] codes);
        }

        Samples(BufferedImage image) {
            this.image = image;
            ColorModel model = image.getColorModel();
            reader = model.getColorSpace().getType() == ColorSpace.TYPE_CMYK ? this::readInks
                    : model instanceof IndexColorModel ? this::readPalette : this::readChannels;
            if (!(model instanceof IndexColorModel) && model.getColorSpace().getType() != ColorSpace.TYPE_CMYK) {
                Arrays.setAll(bits, c -> image.getSampleModel().getSampleSize(band(c)));
            }
        }

        void forEachRow(RowReader sink) {
            int[] row = new int[CHANNELS * image.getWidth()];
            for (int y = 0; y < image.getHeight(); y++) {
                reader.accept(y, row);
                sink.accept(y, row);
            }
        }

        /** Returns the linear value of each code of each channel. */
        float[][] linear(boolean isColor) {
            float[] first = linearTable(bits[0], isColor);
            return IntStream.of(bits).mapToObj(b -> b == bits[0] ? first : linearTable(b, isColor)).toArray(float[][]::new);
        }

        /** Returns the band of a channel; a gray image has one for all channels. */
        private int band(int channel) {
            return image.getRaster().getNumBands() < CHANNELS ? 0 : channel;
        }

        private void readInks(int y, int[] codes) {
            int[] inks = image.getRaster().getPixels(0, y, image.getWidth(), 1, (int[]) null);
            for (int i = 0; i < codes.length; i++) {
                int pixel = 4 * (i / CHANNELS);
                codes[i] = Math.round((255 - inks[pixel + i % CHANNELS]) * (255 - inks[pixel + 3]) / 255f);
            }
        }

        private void readPalette(int y, int[] codes) {
            for (int i = 0; i < codes.length; i++) {
                codes[i] = image.getRGB(i / CHANNELS, y) >> 16 - 8 * (i % CHANNELS) & 0xFF;
            }
        }

        /** Reads samples. {@link BufferedImage#getRGB} would treat gray ones as linear light and apply color profiles. */
        private void readChannels(int y, int[] codes) {
            int bands = image.getRaster().getNumBands();
            int[] pixels = image.getRaster().getPixels(0, y, image.getWidth(), 1, (int[]) null);
            for (int i = 0; i < codes.length; i++) {
                codes[i] = pixels[i / CHANNELS * bands + band(i % CHANNELS)];
            }
        }
    }

    /** Returns the linear value of each sample with the given number of bits, {@code float[2^bits]}. */
    private static float[] linearTable(int bits, boolean isColor) {
        int max = (1 << bits) - 1;
        float[] linear = new float[max + 1];
        for (int i = 0; i <= max; i++) {
            double s = (double) i / max;
            linear[i] = (float) (isColor ? SrgbCurve.toLinear(s) : s);
        }
        return linear;
    }

    @Override
    public void close() {
        reader.dispose();
    }
}
