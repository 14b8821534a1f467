package lightning.format.picture;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.OptionalDouble;
import lightning.base.file.OrdinaryFile;
import lightning.base.text.Decimal;
import lightning.base.text.Quote;
import lightning.render.image.CubeTable;

/**
 * Reads {@code .cube} files (Cube LUT Specification 1.0, Adobe, 2013): {@code TITLE}, {@code LUT_1D_SIZE} or {@code LUT_3D_SIZE},
 * {@code DOMAIN_MIN}, {@code DOMAIN_MAX}, then three numbers a line, red fastest. {@code LUT_1D_INPUT_RANGE} and {@code LUT_3D_INPUT_RANGE} of
 * other programs are a domain with the same ends for all channels.
 */
public final class CubeReader {
    /** Bytes of a file: 64 MiB. */
    public static final int MOST_BYTES = 1 << 26;

    private static final List<String> KEYWORDS =
            List.of("TITLE", "LUT_1D_SIZE", "LUT_3D_SIZE", "DOMAIN_MIN", "DOMAIN_MAX", "LUT_1D_INPUT_RANGE", "LUT_3D_INPUT_RANGE");
    /** What the names of such files end in. */
    public static final String ENDING = ".cube";
    private static final double MOST = 1e9;
    private static final int MOST_FOUND = 40;

    private final Path file;
    private int line;
    private boolean lattice;
    private int size;
    private float[] colors = new float[0];
    private int filled;
    private float[] min = {0, 0, 0};
    private float[] max = {1, 1, 1};

    private CubeReader(Path file) {
        this.file = file;
    }

    /**
     * The table of a file.
     *
     * @throws IOException if it cannot be read, has more than {@link #MOST_BYTES} bytes, or is no such table; the message is a sentence that
     *                     names the file and the line, what was expected and what was found
     */
    public static CubeTable read(Path file) throws IOException {
        return new CubeReader(file).table(new String(OrdinaryFile.bytes(file, "a .cube table", MOST_BYTES), StandardCharsets.UTF_8));
    }

    private CubeTable table(String text) throws IOException {
        int from = 0;
        while (from < text.length()) {
            int end = text.indexOf('\n', from);
            end = end < 0 ? text.length() : end;
            line++;
            line(text.substring(from, end).strip());
            from = end + 1;
        }
        if (size == 0) {
            throw problem("LUT_1D_SIZE or LUT_3D_SIZE", "the end of the file");
        }
        if (filled < colors.length) {
            throw problem(colors.length / 3 + " lines of three numbers", filled / 3 + " before the end of the file");
        }
        for (int c = 0; c < 3; c++) {
            if (!(min[c] < max[c])) {
                throw problem("DOMAIN_MIN below DOMAIN_MAX in each channel", min[c] + " and " + max[c]);
            }
        }
        return new CubeTable(file, lattice, size, colors, min, max);
    }

    private void line(String text) throws IOException {
        if (text.isEmpty() || text.startsWith("#")) {
            return;
        }
        String[] words = text.split("[ \t]+", 5);
        switch (words[0]) {
            case "TITLE" -> {}
            case "LUT_1D_SIZE" -> begin(words, false, CubeTable.MOST_ENTRIES);
            case "LUT_3D_SIZE" -> begin(words, true, CubeTable.MOST_POINTS);
            case "DOMAIN_MIN" -> min = domain(words);
            case "DOMAIN_MAX" -> max = domain(words);
            case "LUT_1D_INPUT_RANGE", "LUT_3D_INPUT_RANGE" -> {
                float[] ends = numbers(words, 1, 2);
                Arrays.fill(min, ends[0]);
                Arrays.fill(max, ends[1]);
            }
            default -> color(words, text);
        }
    }

    private void begin(String[] words, boolean cubic, int most) throws IOException {
        if (size > 0) {
            throw problem("one size in a file", words[0] + " again");
        }
        float[] count = numbers(words, 1, 1);
        if (!(count[0] >= 2 && count[0] <= most) || count[0] != Math.rint(count[0])) {
            throw problem("a whole number from 2 to " + most + " behind " + words[0], Quote.of(words[1]));
        }
        lattice = cubic;
        size = (int) count[0];
        colors = new float[3 * (cubic ? size * size * size : size)];
    }

    private float[] domain(String[] words) throws IOException {
        if (filled > 0) {
            throw problem(words[0] + " before the table", "it behind " + filled / 3 + " lines of numbers");
        }
        return numbers(words, 1, 3);
    }

    private void color(String[] words, String text) throws IOException {
        boolean number = Decimal.read(words[0]).isPresent();
        if (!number) {
            throw problem("three numbers or one of " + String.join(", ", KEYWORDS), found(text));
        }
        if (size == 0) {
            throw problem("LUT_1D_SIZE or LUT_3D_SIZE before the numbers", found(text));
        }
        float[] color = numbers(words, 0, 3);
        if (filled == colors.length) {
            throw problem(colors.length / 3 + " lines of three numbers", "one more");
        }
        System.arraycopy(color, 0, colors, filled, 3);
        filled += 3;
    }

    private float[] numbers(String[] words, int from, int count) throws IOException {
        float[] numbers = new float[count];
        boolean right = words.length == from + count;
        for (int i = 0; right && i < count; i++) {
            OptionalDouble v = Decimal.read(words[from + i]);
            right = v.isPresent() && Math.abs(v.getAsDouble()) <= MOST;
            numbers[i] = (float) v.orElse(0);
        }
        if (!right) {
            String expected = (count == 1 ? "a number" : count == 2 ? "two numbers" : "three numbers") + " from -10⁹ to 10⁹";
            throw problem(from == 0 ? expected : expected + " behind " + words[0], found(String.join(" ", words)));
        }
        return numbers;
    }

    private static String found(String text) {
        return Quote.of(text.length() <= MOST_FOUND ? text : text.substring(0, MOST_FOUND));
    }

    private IOException problem(String expected, String found) {
        return new IOException(Quote.path(file) + ", line " + line + ": expected " + expected + ", found " + found);
    }
}
