package lightning.format.image;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Consumer;
import lightning.base.file.RegularFile;
import lightning.base.text.DecimalNumber;
import lightning.base.text.Quote;
import lightning.base.text.RefusalException;
import lightning.render.image.CubeLut;
import lightning.render.image.Log2Shaper;

/**
 * Reader for {@code .cube} LUTs (Cube LUT Specification 1.0, Adobe, 2013): {@code TITLE}, {@code LUT_1D_SIZE} or {@code
 * LUT_3D_SIZE}, {@code DOMAIN_MIN}, {@code DOMAIN_MAX}, then three numbers per line, red fastest. {@code LUT_1D_INPUT_RANGE}
 * and {@code LUT_3D_INPUT_RANGE} of other programs set the same domain for all channels of one table; their files may have curves before a lattice.
 * Lines before the numbers that begin with any other word are information for other programs, such as {@code LUT_IN_VIDEO_RANGE} of cameras.
 *
 * <p>The comment {@code # LIGHTNING_SHAPER log2:-9,12} says that the table is made for a logarithm of linear light.
 */
public final class CubeLutReader {
    /** Maximum file size in bytes: 64 MiB. */
    public static final int MAX_BYTES = 1 << 26;

    private static final List<String> KEYWORDS =
            List.of("TITLE", "LUT_1D_SIZE", "LUT_3D_SIZE", "DOMAIN_MIN", "DOMAIN_MAX", "LUT_1D_INPUT_RANGE", "LUT_3D_INPUT_RANGE");
    /** File extension of LUTs. */
    public static final String EXTENSION = ".cube";
    private static final String SHAPER = "# LIGHTNING_SHAPER ";
    private static final double MAX_VALUE = 1e9;
    private static final int MAX_QUOTED_LENGTH = 40;

    private final Path file;
    private final Consumer<String> notes;
    private int line;
    private Optional<Log2Shaper> log = Optional.empty();
    private final Table curves = new Table();
    private final Table lattice = new Table();

    /** One of the tables that a file can have. */
    private static final class Table {
        private int size;
        private float[] colors = new float[0];
        private int filledCount;
        private float[] min = {0, 0, 0};
        private float[] max = {1, 1, 1};
        private boolean hasRange;

        boolean isFull() {
            return filledCount == colors.length;
        }
    }

    private CubeLutReader(Path file, Consumer<String> notes) {
        this.file = file;
        this.notes = notes;
    }

    /** Reads a LUT as below, without notes. */
    public static CubeLut read(Path file) throws IOException {
        return read(file, _ -> {});
    }

    /**
     * Reads a LUT.
     *
     * @param notes receives a sentence for each line that is not used
     * @throws IOException if the file cannot be read, has more than {@link #MAX_BYTES} bytes, or is not a valid LUT; the
     *     message is a sentence with file, line, expected and found content
     */
    public static CubeLut read(Path file, Consumer<String> notes) throws IOException {
        return new CubeLutReader(file, notes)
                .readTable(new String(RegularFile.readBytes(file, "a .cube LUT", MAX_BYTES), StandardCharsets.UTF_8));
    }

    private CubeLut readTable(String text) throws IOException {
        int start = text.startsWith("\uFEFF") ? 1 : 0;
        while (start < text.length()) {
            int end = text.indexOf('\n', start);
            end = end < 0 ? text.length() : end;
            line++;
            readLine(text.substring(start, end).strip());
            start = end + 1;
        }
        if (curves.size == 0 && lattice.size == 0) {
            throw problem("LUT_1D_SIZE or LUT_3D_SIZE", "the end of the file");
        }
        for (Table table : List.of(curves, lattice)) {
            if (!table.isFull()) {
                throw problem(table.colors.length / 3 + " lines of three numbers", table.filledCount / 3 + " before the end of the file");
            }
        }
        if (curves.size == 0) {
            return lut(lattice, Optional.empty());
        }
        CubeLut first = lut(curves, Optional.empty());
        if (lattice.size == 0) {
            return first;
        }
        if (!lattice.hasRange) {
            // The file's domain is that of its input.
            lattice.min = new float[] {0, 0, 0};
            lattice.max = new float[] {1, 1, 1};
        }
        return lut(lattice, Optional.of(first));
    }

    private CubeLut lut(Table table, Optional<CubeLut> shaper) throws IOException {
        for (int c = 0; c < 3; c++) {
            if (!(table.min[c] < table.max[c])) {
                throw problem("DOMAIN_MIN below DOMAIN_MAX in each channel", table.min[c] + " and " + table.max[c]);
            }
        }
        return new CubeLut(file, table == lattice, table.size, table.colors, table.min, table.max, shaper, log);
    }

    private void readLine(String text) throws IOException {
        if (text.startsWith(SHAPER)) {
            readShaper(text.substring(SHAPER.length()).strip());
        }
        if (text.isEmpty() || text.startsWith("#")) {
            return;
        }
        String[] words = text.split("[ \t]+", 5);
        switch (words[0]) {
            case "TITLE" -> {}
            case "LUT_1D_SIZE" -> readSize(words, curves, CubeLut.MAX_ENTRIES);
            case "LUT_3D_SIZE" -> readSize(words, lattice, CubeLut.MAX_POINTS);
            case "DOMAIN_MIN" -> {
                curves.min = readDomain(words);
                lattice.min = curves.min.clone();
            }
            case "DOMAIN_MAX" -> {
                curves.max = readDomain(words);
                lattice.max = curves.max.clone();
            }
            case "LUT_1D_INPUT_RANGE" -> readRange(words, curves);
            case "LUT_3D_INPUT_RANGE" -> readRange(words, lattice);
            default -> readColor(words, text);
        }
    }

    private void readShaper(String text) throws IOException {
        try {
            log = Optional.of(Log2Shaper.parse(text));
        } catch (RefusalException e) {
            throw problem("a logarithm such as log2:-9,12 after " + SHAPER.strip(), quoted(text));
        }
    }

    private void readRange(String[] words, Table table) throws IOException {
        float[] range = readNumbers(words, 1, 2);
        Arrays.fill(table.min, range[0]);
        Arrays.fill(table.max, range[1]);
        table.hasRange = true;
    }

    private void readSize(String[] words, Table table, int maxSize) throws IOException {
        if (table.size > 0) {
            throw problem("one size of a table in a file", words[0] + " again");
        }
        float[] count = readNumbers(words, 1, 1);
        if (!(count[0] >= 2 && count[0] <= maxSize) || count[0] != Math.rint(count[0])) {
            throw problem("a whole number from 2 to " + maxSize + " after " + words[0], Quote.of(words[1]));
        }
        table.size = (int) count[0];
        table.colors = new float[3 * (table == lattice ? table.size * table.size * table.size : table.size)];
    }

    private float[] readDomain(String[] words) throws IOException {
        int filled = curves.filledCount + lattice.filledCount;
        if (filled > 0) {
            throw problem(words[0] + " before the table", "it after " + filled / 3 + " lines of numbers");
        }
        return readNumbers(words, 1, 3);
    }

    /** Reads a line of the table; curves stand before the lattice. */
    private void readColor(String[] words, String text) throws IOException {
        boolean isNumber = DecimalNumber.parse(words[0]).isPresent();
        if (!isNumber && curves.filledCount + lattice.filledCount == 0 && Character.isLetter(words[0].codePointAt(0))) {
            notes.accept(file.getFileName() + ", line " + line + ": " + quoted(text) + " is not used");
            return;
        }
        if (!isNumber) {
            throw problem("three numbers or one of " + String.join(", ", KEYWORDS), quoted(text));
        }
        if (curves.size == 0 && lattice.size == 0) {
            throw problem("LUT_1D_SIZE or LUT_3D_SIZE before the numbers", quoted(text));
        }
        float[] color = readNumbers(words, 0, 3);
        Table table = curves.isFull() ? lattice : curves;
        if (table.isFull()) {
            throw problem((curves.colors.length + lattice.colors.length) / 3 + " lines of three numbers", "one more");
        }
        System.arraycopy(color, 0, table.colors, table.filledCount, 3);
        table.filledCount += 3;
    }

    private float[] readNumbers(String[] words, int start, int count) throws IOException {
        float[] numbers = new float[count];
        boolean isValid = words.length == start + count;
        for (int i = 0; isValid && i < count; i++) {
            OptionalDouble v = DecimalNumber.parse(words[start + i]);
            isValid = v.isPresent() && Math.abs(v.getAsDouble()) <= MAX_VALUE;
            numbers[i] = (float) v.orElse(0);
        }
        if (!isValid) {
            String expected = (count == 1 ? "a number" : count == 2 ? "two numbers" : "three numbers") + " from -10⁹ to 10⁹";
            throw problem(start == 0 ? expected : expected + " after " + words[0], quoted(String.join(" ", words)));
        }
        return numbers;
    }

    private static String quoted(String text) {
        return Quote.of(text.length() <= MAX_QUOTED_LENGTH ? text : text.substring(0, MAX_QUOTED_LENGTH));
    }

    private IOException problem(String expected, String found) {
        return new IOException(Quote.path(file) + ", line " + line + ": expected " + expected + ", found " + found);
    }
}
