package lightning.cli;

import java.io.IOException;
import java.nio.file.Path;
import lightning.bench.Reporter;
import lightning.bench.Results;
import lightning.bench.ResultsFile;

/** The folder that a benchmark writes to. */
final class BenchFolder {
    /** Writing in between may take this share of the time. */
    private static final int ONE_PART_IN = 20;

    private final Path folder;
    private final Reporter reporter;
    private long writingNs;
    private long writtenAt = System.nanoTime();

    BenchFolder(Path folder, Reporter reporter) {
        this.folder = folder;
        this.reporter = reporter;
    }

    /** Writes the tables between two parts, unless that was done just now: a killed process leaves what it measured. */
    void writeNowAndThen(Results results) throws IOException {
        long start = System.nanoTime();
        if (start - writtenAt >= ONE_PART_IN * writingNs) {
            writeTables(results);
            writtenAt = System.nanoTime();
            writingNs = writtenAt - start;
        }
    }

    /** Writes all files. */
    void write(Results results) throws IOException {
        writeTables(results);
        reporter.write(results, folder);
    }

    /**
     * Writes all files even where this thread is interrupted, which would not let it write; it stays interrupted.
     *
     * @param tables runs when everything but the page is written: an ended process may not be given the time for that
     */
    void keep(Results results, Runnable tables) throws IOException {
        boolean interrupted = Thread.interrupted();
        try {
            writeTables(results);
            tables.run();
            reporter.write(results, folder);
        } finally {
            if (interrupted) {
                Thread.currentThread().interrupt();
            }
        }
    }

    private void writeTables(Results results) throws IOException {
        ResultsFile.writeJson(folder.resolve("results.json"), results);
        ResultsFile.writeCsv(folder.resolve("results.csv"), results);
    }
}
