package lightning.bench.result;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import lightning.base.file.AtomicFile;
import lightning.base.text.Quote;
import tools.jackson.core.JacksonException;
import tools.jackson.core.util.DefaultIndenter;
import tools.jackson.core.util.DefaultPrettyPrinter;
import tools.jackson.databind.DeserializationFeature;
import tools.jackson.databind.MapperFeature;
import tools.jackson.databind.SerializationFeature;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.dataformat.csv.CsvMapper;

/**
 * Benchmark results as files: lossless JSON that can be read back, and CSV with a row per measurement.
 *
 * <p>Missing numbers are the string {@code NaN}, infinite ones {@code Infinity}.
 */
public final class ResultsFile {
    /** One line per property, for readable diffs, without indentation, which would double the file size. */
    private static final DefaultIndenter LINE_INDENTER = new DefaultIndenter("", "\n");
    /** Exceeds the few MB of a full run. */
    private static final long MAX_BYTES = 200_000_000;
    private static final JsonMapper JSON = JsonMapper.builder()
            .disable(MapperFeature.SORT_PROPERTIES_ALPHABETICALLY)
            .enable(SerializationFeature.INDENT_OUTPUT)
            .defaultPrettyPrinter(new DefaultPrettyPrinter().withObjectIndenter(LINE_INDENTER))
            .enable(DeserializationFeature.FAIL_ON_UNKNOWN_PROPERTIES)
            .enable(DeserializationFeature.FAIL_ON_MISSING_CREATOR_PROPERTIES)
            .build();
    private static final CsvMapper CSV = CsvMapper.builder().disable(MapperFeature.SORT_PROPERTIES_ALPHABETICALLY).build();

    private ResultsFile() {}

    /**
     * Writes results as JSON.
     *
     * @throws IOException if the file cannot be written
     */
    public static void writeJson(Path file, BenchResults results) throws IOException {
        byte[] text = JSON.writeValueAsBytes(results);
        AtomicFile.write(file, out -> out.write(text));
    }

    /**
     * Reads results that {@link #writeJson} wrote.
     *
     * @throws IOException if the file cannot be read or is invalid; the message has position and reason
     */
    public static BenchResults readJson(Path file) throws IOException {
        if (Files.exists(file) && !Files.isRegularFile(file)) {
            throw new IOException(file + ": expected a results file of 'lightning bench', found no regular file");
        }
        if (Files.exists(file) && Files.size(file) > MAX_BYTES) {
            throw new IOException(
                    file + ": expected a results file of 'lightning bench' of at most " + MAX_BYTES + " bytes, found " + Files.size(file));
        }
        try {
            return JSON.readValue(Files.readAllBytes(file), BenchResults.class);
        } catch (JacksonException e) {
            var at = e.getLocation();
            throw new IOException(Quote.path(file) + (at == null ? "" : ":" + at.getLineNr() + ":" + at.getColumnNr())
                    + ": expected a results file of 'lightning bench': " + e.getOriginalMessage(), e);
        }
    }

    /**
     * Writes a row per measurement as CSV, with a line of column names.
     *
     * @throws IOException if the file cannot be written
     */
    public static void writeCsv(Path file, BenchResults results) throws IOException {
        List<CsvRow> rows = CsvRow.of(results);
        byte[] text = CSV.writer(CSV.schemaFor(CsvRow.class).withHeader()).writeValueAsBytes(rows);
        AtomicFile.write(file, out -> out.write(text));
    }
}
