package lightning.format.hdr;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import lightning.base.file.RegularFile;
import lightning.base.text.Quote;
import lightning.format.mesh.MeshException;
import lightning.scene.asset.EnvironmentMap;
import lightning.scene.value.SceneLimits;

/**
 * Reader for Radiance {@code .hdr} images: RGB with a shared 8-bit exponent (Ward, Real Pixels, Graphics Gems II, 1991),
 * flat or run-length encoded. Lines run from top to bottom, pixels from left to right; the header's exposure is divided out.
 */
public final class HdrReader {
    /** Maximum file size in bytes: 64 MiB. */
    public static final int MAX_BYTES = 64 << 20;
    /** Maximum number of pixels: 8 Mi, 96 MiB when decoded. */
    public static final int MAX_PIXELS = 8 << 20;

    private static final int MAX_HEADER_BYTES = 1 << 16;
    private static final Pattern SIZE = Pattern.compile("-Y ([0-9]{1,18}) \\+X ([0-9]{1,18})");
    private static final Pattern EXPOSURE = Pattern.compile("EXPOSURE= *([0-9.]{1,20}(?:[eE][+-]?[0-9]{1,3})?) *");

    private final Path file;
    private final byte[] bytes;
    private int next;
    private int line;
    private double exposure = 1;

    private HdrReader(Path file, byte[] bytes) {
        this.file = file;
        this.bytes = bytes;
    }

    /**
     * Reads a file; radiances are clamped to {@link SceneLimits#MAX_EMISSION}.
     *
     * @throws MeshException if it is not a Radiance image, too large, or truncated; the message contains the position
     * @throws IOException if it cannot be read
     */
    public static EnvironmentMap read(Path file) throws IOException, MeshException {
        long size = Files.size(file);
        if (size > MAX_BYTES) {
            throw new MeshException(file, "", "an environment must have at most " + MAX_BYTES + " bytes, has " + size);
        }
        return new HdrReader(file, RegularFile.readBytes(file, "a Radiance HDR file", MAX_BYTES)).environment();
    }

    private EnvironmentMap environment() throws MeshException {
        Matcher size = readHeader();
        int height = parseSide(size.group(1));
        int width = parseSide(size.group(2));
        long pixels = (long) width * height;
        if (pixels < 1 || pixels > MAX_PIXELS) {
            throw problem("an image must have from 1 to " + MAX_PIXELS + " pixels, has " + size.group(2) + "×" + size.group(1));
        }
        long minBytes = height * Math.min(4L * width, 4 + 8L * ((width + 126) / 127));
        if (bytes.length - next < minBytes) {
            throw problem(width + "×" + height + " pixels take at least " + minBytes + " bytes, found " + (bytes.length - next));
        }
        float[] rgb = new float[3 * width * height];
        byte[] pixel = new byte[4 * width];
        for (int y = 0; y < height; y++) {
            readScanline(width, y, pixel);
            for (int x = 0; x < width; x++) {
                int e = pixel[3 * width + x] & 0xFF;
                double scale = e == 0 ? 0 : Math.scalb(1.0, e - 136) / exposure;
                for (int c = 0; c < 3; c++) {
                    rgb[3 * (y * width + x) + c] = (float) Math.min((pixel[c * width + x] & 0xFF) * scale, SceneLimits.MAX_EMISSION);
                }
            }
        }
        if (next != bytes.length) {
            throw new MeshException(file, "",
                    "expected nothing after the last of " + height + " lines, found " + (bytes.length - next) + " bytes");
        }
        return new EnvironmentMap(width, height, rgb);
    }

    /** Parses a side length in pixels, clamped to just above the maximum number of pixels. */
    private static int parseSide(String digits) {
        return (int) Math.min(Long.parseLong(digits), MAX_PIXELS + 1);
    }

    /** Reads the header up to and including the resolution line. */
    private Matcher readHeader() throws MeshException {
        String first = readLine();
        if (!first.equals("#?RADIANCE") && !first.equals("#?RGBE")) {
            throw problem("a Radiance HDR image must begin with #?RADIANCE or #?RGBE, was " + Quote.of(first));
        }
        boolean hasFormat = false;
        for (String s = readLine(); !s.isEmpty(); s = readLine()) {
            Matcher m = EXPOSURE.matcher(s);
            if (s.startsWith("FORMAT=")) {
                hasFormat = s.equals("FORMAT=32-bit_rle_rgbe");
                if (!hasFormat) {
                    throw problem("the format must be 32-bit_rle_rgbe, was " + Quote.of(s.substring(7)));
                }
            } else if (m.matches()) {
                exposure *= parseExposure(m.group(1));
            } else if (s.startsWith("EXPOSURE=")) {
                throw problem("an exposure must be a number above 0, was " + Quote.of(s.substring(9)));
            }
        }
        if (!hasFormat) {
            throw problem("expected a line FORMAT=32-bit_rle_rgbe in the header, found none");
        }
        String last = readLine();
        Matcher size = SIZE.matcher(last);
        if (!size.matches()) {
            throw problem("the size must be written as -Y HEIGHT +X WIDTH, was " + Quote.of(last));
        }
        return size;
    }

    private double parseExposure(String text) throws MeshException {
        double v = lightning.base.text.DecimalNumber.parse(text).orElse(0);
        if (!(v >= 1e-30 && v <= 1e30) || !(exposure * v >= 1e-30 && exposure * v <= 1e30)) {
            throw problem("an exposure must be a number from 1e-30 to 1e30, was " + Quote.of(text));
        }
        return v;
    }

    private String readLine() throws MeshException {
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
        return new String(bytes, start, next++ - start, StandardCharsets.ISO_8859_1);
    }

    /** Reads a scan line into four consecutive columns. */
    private void readScanline(int width, int y, byte[] out) throws MeshException {
        requireBytes(4, y);
        boolean isRunLength = width >= 8 && width < 1 << 15 && bytes[next] == 2 && bytes[next + 1] == 2 && bytes[next + 2] >= 0;
        if (!isRunLength) {
            requireBytes(4 * width, y);
            for (int x = 0; x < width; x++) {
                for (int c = 0; c < 4; c++) {
                    out[c * width + x] = bytes[next++];
                }
                if (out[x] == 1 && out[width + x] == 1 && out[2 * width + x] == 1) {
                    throw rowProblem(y, "old-style runs of equal pixels are not supported");
                }
            }
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

    private void requireBytes(int count, int y) throws MeshException {
        if (bytes.length - next < count) {
            throw rowProblem(y, "expected more pixels, found the end of the file");
        }
    }

    private MeshException rowProblem(int y, String message) {
        return new MeshException(file, "row " + (y + 1), message);
    }

    private MeshException problem(String message) {
        return new MeshException(file, "line " + line, message);
    }
}
