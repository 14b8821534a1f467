package lightning.cli;

import java.io.IOException;
import java.nio.file.Path;
import lightning.bench.BenchResults;
import lightning.bench.ResultsFile;
import lightning.bench.ResultsReporter;

/** The folder that a benchmark writes to. */
final class BenchOutput {
    /** Writing in between may take this share of the time. */
    private static final int WRITE_INTERVAL_FACTOR = 20;

    private final Path folder;
    private final ResultsReporter reporter;
    private long writeDurationNs;
    private long lastWrite = System.nanoTime();

    BenchOutput(Path folder, ResultsReporter reporter) {
        this.folder = folder;
        this.reporter = reporter;
    }

    /** Writes the tables between two parts, unless that was done just now: a killed process leaves what it measured. */
    void writePeriodically(BenchResults results) throws IOException {
        long start = System.nanoTime();
        if (start - lastWrite >= WRITE_INTERVAL_FACTOR * writeDurationNs) {
            writeTables(results);
            lastWrite = System.nanoTime();
            writeDurationNs = lastWrite - start;
        }
    }

    /** Writes all files. */
    void write(BenchResults results) throws IOException {
        writeTables(results);
        reporter.write(results, folder);
    }

    /**
     * Writes all files even where this thread is interrupted, which would not let it write; it stays interrupted.
     *
     * @param afterTables runs when everything but the page is written: an ended process may not be given the time for that
     */
    void writeUninterruptibly(BenchResults results, Runnable afterTables) throws IOException {
        boolean interrupted = Thread.interrupted();
        try {
            writeTables(results);
            afterTables.run();
            reporter.write(results, folder);
        } finally {
            if (interrupted) {
                Thread.currentThread().interrupt();
            }
        }
    }

    private void writeTables(BenchResults results) throws IOException {
        ResultsFile.writeJson(folder.resolve("results.json"), results);
        ResultsFile.writeCsv(folder.resolve("results.csv"), results);
    }
}
