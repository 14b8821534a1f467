package lightning.cli.option;

import lightning.base.work.WorkerPool;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** Option {@code --threads}. */
public final class ThreadsOption {
    private static final int MAX_THREADS = 1024;

    @Spec(Spec.Target.MIXEE)
    private CommandSpec command;

    private int threads = WorkerPool.processorCount();

    @Option(names = "--threads", paramLabel = "N",
            description = "Number of threads (default: all processors). The image is the same for any number.")
    private void setThreads(int value) {
        threads = OptionRange.check(command, "--threads", value, 1, MAX_THREADS);
    }

    public int count() {
        return threads;
    }
}
