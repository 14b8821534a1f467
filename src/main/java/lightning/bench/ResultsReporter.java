package lightning.bench;

import java.io.IOException;
import java.nio.file.Path;
import lightning.bench.result.BenchResults;

/** Reporter that presents results. */
@FunctionalInterface
public interface ResultsReporter {
    /** Reporter that does nothing. */
    ResultsReporter NONE = (_, _) -> {};

    /**
     * Writes a report to the folder of the results.
     *
     * @param folder folder of {@code results.json}; image names in results are relative to it
     * @throws IOException if an image cannot be read or a file cannot be written
     */
    void write(BenchResults results, Path folder) throws IOException;
}
