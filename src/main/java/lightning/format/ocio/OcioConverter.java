package lightning.format.ocio;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import lightning.base.file.RegularFile;
import lightning.base.process.PythonConverter;
import lightning.base.process.PythonPackage;
import lightning.base.text.Messages;
import lightning.base.text.Quote;
import lightning.base.work.Progress;
import tools.jackson.core.JacksonException;
import tools.jackson.databind.json.JsonMapper;

/**
 * The converter of OpenColorIO configurations in Python.
 *
 * @param program the process
 */
record OcioConverter(PythonConverter program) {
    /** Start of the names of configurations that OpenColorIO contains. */
    static final String BUILT_IN = "ocio://";

    static final PythonPackage OCIO = new PythonPackage("opencolorio", Messages.key("OpenColorIO views"));
    private static final Duration TIME_LIMIT = Duration.ofMinutes(2);
    /** Address space of the process in bytes; a table needs 100 MB. */
    private static final long MEMORY = 4L << 30;
    private static final int MAX_JSON_BYTES = 1 << 24;
    private static final JsonMapper JSON = JsonMapper.builder().build();

    /**
     * Returns the converter of this installation.
     *
     * @throws IOException if there is no Python, or the installation is incomplete
     */
    static OcioConverter installed() throws IOException {
        return new OcioConverter(PythonConverter.installed("lightning_ocio", TIME_LIMIT, OCIO));
    }

    /**
     * Runs the converter on a configuration.
     *
     * @param config  a file, or a name such as {@code ocio://default}
     * @param indexes of the display and of its view to bake; empty to list them only
     * @param use     reads the written files, which do not exist afterwards
     * @throws IOException if OpenColorIO cannot read the configuration or use the view, or there is no Python with it; the message is a
     *     sentence
     */
    <T> T convert(String config, List<Integer> indexes, Progress progress, PythonConverter.Use<T, IOException> use) throws IOException {
        List<String> options = new ArrayList<>(List.of(Long.toString(MEMORY)));
        indexes.forEach(index -> options.add(Integer.toString(index)));
        return program.convert(source(config), options, indexes.isEmpty() ? "views.json" : "table.json", progress,
                problem -> new IOException(Quote.path(config) + ": " + problem), use);
    }

    /** Reads a JSON file of the converter. */
    static <T> T readJson(Path file, Class<T> type) throws IOException {
        try {
            return JSON.readValue(RegularFile.readBytes(file, "a file of the converter", MAX_JSON_BYTES), type);
        } catch (JacksonException e) {
            throw new IOException("the converter of OpenColorIO views wrote invalid JSON: " + e.getOriginalMessage(), e);
        }
    }

    private static String source(String config) throws IOException {
        if (config.startsWith(BUILT_IN)) {
            return config;
        }
        try {
            Path file = Path.of(config);
            RegularFile.check(file, "an OpenColorIO configuration");
            if (!Files.exists(file)) {
                throw new NoSuchFileException(config);
            }
            return file.toAbsolutePath().toString();
        } catch (InvalidPathException e) {
            throw new IOException(Quote.of(config) + ": is no file name", e);
        }
    }
}
