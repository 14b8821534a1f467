package lightning.bench;

import java.io.IOException;
import java.nio.file.Path;

/** Makes something to look at of results. */
@FunctionalInterface
public interface ResultsReporter {
    /** Makes nothing. */
    ResultsReporter NONE = (_, _) -> {};

    /**
     * Writes into the folder that holds the results.
     *
     * @param folder where {@code results.json} is; the pictures that results name are relative to it
     * @throws IOException if a picture cannot be read or a file not be written
     */
    void write(BenchResults results, Path folder) throws IOException;
}
