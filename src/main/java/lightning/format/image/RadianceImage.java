package lightning.format.image;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import lightning.base.math.CieXyz;
import lightning.base.text.DecimalNumber;
import lightning.base.text.Quote;
import lightning.scene.asset.TextureUsage;
import lightning.scene.value.SceneLimits;

/**
 * Reader for Radiance {@code .hdr} images: RGB with a shared 8-bit exponent (Ward, Real Pixels, Graphics Gems II, 1991),
 * flat or run-length encoded, also in the old way. The picture may be mirrored or turned; the header's exposure and color correction are divided
 * out. CIE XYZ becomes linear sRGB; colors outside it are clamped.
 */
final class RadianceImage extends ImageSource {
    private static final int MAX_HEADER_BYTES = 1 << 16;
    private static final Pattern SIZE = Pattern.compile("([-+])([XY]) +([0-9]{1,18}) +([-+])([XY]) +([0-9]{1,18}) *");
    private static final Pattern EXPOSURE = Pattern.compile("EXPOSURE= *([0-9.]{1,20}(?:[eE][+-]?[0-9]{1,3})?) *");

    private final byte[] bytes;
    private final Matcher size;
    private int next;
    private int line;
    private double exposure = 1;
    /** Factors of red, green and blue that are in the pixels. */
    private final double[] correction = {1, 1, 1};
    private boolean isXyz;

    /**
     * Reads the header of a file.
     *
     * @throws IOException if it is not a Radiance image; the message contains the position
     */
    RadianceImage(byte[] bytes) throws IOException {
        this.bytes = bytes;
        size = readHeader();
    }

    /** Returns the number of scan lines, which run along the second side. */
    private int lines() {
        return parseSide(size.group(3));
    }

    private int lineLength() {
        return parseSide(size.group(6));
    }

    private boolean isTurned() {
        return size.group(2).equals("X");
    }

    @Override
    public int width() {
        return isTurned() ? lines() : lineLength();
    }

    @Override
    public int height() {
        return isTurned() ? lineLength() : lines();
    }

    @Override
    void check() throws IOException {
        int start = next;
        byte[] pixel = new byte[4 * lineLength()];
        for (int scan = 0; scan < lines(); scan++) {
            readScanline(lineLength(), scan, pixel);
        }
        next = start;
    }

    /** Returns the value of a step of each exponent. */
    private double[] scales() {
        double[] scales = new double[256];
        for (int e = 1; e < scales.length; e++) {
            scales[e] = Math.scalb(1.0, e - 136) / exposure;
        }
        return scales;
    }

    @Override
    Pixels pixels(TextureUsage usage) {
        return this::decode;
    }

    private void decode(PixelConsumer sink) throws IOException {
        int length = lineLength();
        byte[] pixel = new byte[4 * length];
        float[] rgb = new float[3];
        boolean isTurned = isTurned();
        boolean isUpward = size.group(isTurned ? 4 : 1).equals("+");
        boolean isLeftward = size.group(isTurned ? 1 : 4).equals("-");
        double[] scales = scales();
        int start = next;
        for (int scan = 0; scan < lines(); scan++) {
            readScanline(length, scan, pixel);
            for (int i = 0; i < length; i++) {
                int column = isTurned ? scan : i;
                int row = isTurned ? i : scan;
                double scale = scales[pixel[3 * length + i] & 0xFF];
                double x = (pixel[i] & 0xFF) * scale;
                double y = (pixel[length + i] & 0xFF) * scale;
                double z = (pixel[2 * length + i] & 0xFF) * scale;
                rgb[0] = limited((isXyz ? CieXyz.red(x, y, z) : x) / correction[0]);
                rgb[1] = limited((isXyz ? CieXyz.green(x, y, z) : y) / correction[1]);
                rgb[2] = limited((isXyz ? CieXyz.blue(x, y, z) : z) / correction[2]);
                sink.accept(isLeftward ? width() - 1 - column : column, isUpward ? height() - 1 - row : row, rgb);
            }
        }
        next = start;
    }

    private static float limited(double v) {
        return (float) Math.clamp(v, 0, SceneLimits.MAX_EMISSION);
    }

    /** Parses a side length in pixels, clamped to a number that no image can have. */
    private static int parseSide(String digits) {
        return (int) Math.min(Long.parseLong(digits), Integer.MAX_VALUE);
    }

    /** Reads the header up to and including the resolution line. */
    private Matcher readHeader() throws IOException {
        String first = readLine();
        if (!first.startsWith("#?")) {
            throw problem("a Radiance HDR image must begin with #?RADIANCE or #?RGBE, was " + Quote.of(first));
        }
        for (String s = readLine(); !s.isEmpty(); s = readLine()) {
            Matcher m = EXPOSURE.matcher(s);
            if (s.startsWith("FORMAT=")) {
                isXyz = s.strip().equals("FORMAT=32-bit_rle_xyze");
                if (!isXyz && !s.strip().equals("FORMAT=32-bit_rle_rgbe")) {
                    throw problem("the format must be 32-bit_rle_rgbe or 32-bit_rle_xyze, was " + Quote.of(s.substring(7)));
                }
            } else if (s.startsWith("COLORCORR=")) {
                correct(s.substring(10).strip().split(" +"));
            } else if (m.matches()) {
                exposure *= parseExposure(m.group(1));
            } else if (s.startsWith("EXPOSURE=")) {
                throw problem("an exposure must be a number above 0, was " + Quote.of(s.substring(9)));
            }
        }
        String last = readLine();
        Matcher size = SIZE.matcher(last);
        if (!size.matches() || size.group(2).equals(size.group(5))) {
            throw problem("the size must be written as -Y HEIGHT +X WIDTH, was " + Quote.of(last));
        }
        return size;
    }

    private double parseExposure(String text) throws IOException {
        double v = DecimalNumber.parse(text).orElse(0);
        if (!isFactor(v) || !isFactor(exposure * v)) {
            throw problem("an exposure must be a number from 1e-30 to 1e30, was " + Quote.of(text));
        }
        return v;
    }

    /** Multiplies the correction by three factors, as several lines of a header do. */
    private void correct(String[] words) throws IOException {
        for (int c = 0; c < 3; c++) {
            correction[c] *= words.length == 3 ? DecimalNumber.parse(words[c]).orElse(0) : 0;
            if (!isFactor(correction[c])) {
                throw problem("a color correction must be three numbers from 1e-30 to 1e30, was " + Quote.of(String.join(" ", words)));
            }
        }
    }

    private static boolean isFactor(double v) {
        return v >= 1e-30 && v <= 1e30;
    }

    private String readLine() throws IOException {
        int start = next;
        line++;
        while (next < bytes.length && bytes[next] != '\n') {
            if (++next > MAX_HEADER_BYTES) {
                throw problem("a header must have at most " + MAX_HEADER_BYTES + " bytes, found more");
            }
        }
        if (next == bytes.length) {
            throw problem("expected the end of the header, found the end of the file");
        }
        String text = new String(bytes, start, next++ - start, StandardCharsets.ISO_8859_1);
        return text.endsWith("\r") ? text.substring(0, text.length() - 1) : text;
    }

    /** Reads a scan line into four consecutive columns. */
    private void readScanline(int width, int y, byte[] out) throws IOException {
        requireBytes(4, y);
        boolean isRunLength = width >= 8 && width < 1 << 15 && bytes[next] == 2 && bytes[next + 1] == 2 && bytes[next + 2] >= 0;
        if (!isRunLength) {
            readOldScanline(width, y, out);
            return;
        }
        int encodedWidth = (bytes[next + 2] & 0xFF) << 8 | bytes[next + 3] & 0xFF;
        if (encodedWidth != width) {
            throw rowProblem(y, "must have " + width + " pixels, has " + encodedWidth);
        }
        next += 4;
        for (int c = 0; c < 4; c++) {
            for (int x = 0; x < width;) {
                requireBytes(2, y);
                int count = bytes[next++] & 0xFF;
                boolean isRun = count > 128;
                count = isRun ? count - 128 : count;
                if (count == 0 || x + count > width) {
                    throw rowProblem(y, "a run must have from 1 to " + (width - x) + " pixels, has " + count);
                }
                requireBytes(isRun ? 1 : count, y);
                for (int end = x + count; x < end; x++) {
                    out[c * width + x] = isRun ? bytes[next] : bytes[next++];
                }
                next += isRun ? 1 : 0;
            }
        }
    }

    /** Reads single pixels; one of the color 1 1 1 repeats the pixel before, by its exponent times 256 for each such pixel before it. */
    private void readOldScanline(int width, int y, byte[] out) throws IOException {
        int shift = 0;
        for (int x = 0; x < width;) {
            requireBytes(4, y);
            boolean isRun = bytes[next] == 1 && bytes[next + 1] == 1 && bytes[next + 2] == 1;
            long count = isRun ? (long) (bytes[next + 3] & 0xFF) << shift : 1;
            if (isRun && (x == 0 || x + count > width)) {
                throw rowProblem(y, "a run must follow a pixel and have at most " + (width - x) + " pixels, has " + count);
            }
            for (int end = x + (int) count; x < end; x++) {
                for (int c = 0; c < 4; c++) {
                    out[c * width + x] = isRun ? out[c * width + x - 1] : bytes[next + c];
                }
            }
            shift = isRun ? Math.min(shift + 8, 24) : 0;
            next += 4;
        }
    }

    private void requireBytes(int count, int y) throws IOException {
        if (bytes.length - next < count) {
            throw rowProblem(y, "expected more pixels, found the end of the file");
        }
    }

    private IOException rowProblem(int y, String message) {
        return new IOException("is damaged at row " + (y + 1) + ": " + message);
    }

    private IOException problem(String message) {
        return new IOException("is invalid at line " + line + ": " + message);
    }
}
