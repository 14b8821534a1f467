package lightning.format.usd;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import lightning.base.process.PythonConverter;
import lightning.base.process.PythonPackage;
import lightning.base.text.Messages;
import lightning.base.work.Progress;
import lightning.format.mesh.MeshException;

/**
 * The converter of stages in Python.
 *
 * @param program the process
 * @param memory  bytes after which it is ended
 * @param triangles number of triangles after which it is ended
 */
record UsdConverter(PythonConverter program, long memory, long triangles) {
    static final PythonPackage USD = new PythonPackage("usd-core", Messages.key("USD files"));
    private static final Duration TIME_LIMIT = Duration.ofMinutes(10);
    /** usd-core needs a tenth of it for an empty stage. */
    private static final long MIN_MEMORY = 1L << 30;
    /** Memory that an import needs: a stage of three million triangles fails with 700 MB. */
    private static final long BYTES_PER_TRIANGLE = 300;

    /**
     * Returns the converter of this installation.
     *
     * @throws IOException if there is no Python, or the installation is incomplete
     */
    static UsdConverter installed() throws IOException {
        return new UsdConverter(PythonConverter.installed("lightning_usd", TIME_LIMIT, USD),
                Math.max(MIN_MEMORY, Runtime.getRuntime().maxMemory()), Runtime.getRuntime().maxMemory() / BYTES_PER_TRIANGLE);
    }

    /**
     * Converts a stage.
     *
     * @param use reads the written files, which do not exist afterwards
     * @throws MeshException if usd-core cannot read it, or the time limit is exceeded
     * @throws IOException if the interpreter cannot run, or lacks usd-core
     */
    <T> T convert(Path source, StageChoice choice, Progress progress, PythonConverter.Use<T, MeshException> use)
            throws IOException, MeshException {
        List<String> options = new ArrayList<>(List.of(Long.toString(memory), Long.toString(triangles)));
        options.addAll(choice.arguments());
        return program.convert(source.toAbsolutePath().toString(), options, "stage.json", progress,
                problem -> new MeshException(source, "", problem), use);
    }
}
