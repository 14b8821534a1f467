package lightning.cli;

import java.io.IOException;
import java.nio.file.Path;
import lightning.bench.ResultsReporter;
import lightning.bench.result.BenchResults;
import lightning.bench.result.ResultsFile;

/** Output folder of a benchmark. */
final class BenchOutput {
    /** File name of the results. */
    static final String RESULTS = "results.json";

    /** Limits periodic writes to 1/20 of the run time. */
    private static final int WRITE_INTERVAL_FACTOR = 20;

    private final Path folder;
    private final ResultsReporter reporter;
    private long writeDurationNs;
    private long lastWrite = System.nanoTime();

    BenchOutput(Path folder, ResultsReporter reporter) {
        this.folder = folder;
        this.reporter = reporter;
    }

    /** Writes the tables, at most 1/20 of the time, so that a killed process leaves its measurements. */
    void writePeriodically(BenchResults results) throws IOException {
        long start = System.nanoTime();
        if (start - lastWrite >= WRITE_INTERVAL_FACTOR * writeDurationNs) {
            writeTables(results);
            lastWrite = System.nanoTime();
            writeDurationNs = lastWrite - start;
        }
    }

    /** Writes all files, the report included. */
    void write(BenchResults results) throws IOException {
        writeTables(results);
        reporter.write(results, folder);
    }

    /**
     * Writes all files even if this thread is interrupted; restores the interrupt flag afterwards.
     *
     * @param afterTables called when everything but the report is written, because a terminating process may not have time
     *     for the report
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
        ResultsFile.writeJson(folder.resolve(RESULTS), results);
        ResultsFile.writeCsv(folder.resolve("results.csv"), results);
    }
}
