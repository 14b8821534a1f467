package lightning.cli.option;

import lightning.base.work.WorkerPool;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
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
        if (value < 1 || value > MAX_THREADS) {
            throw new ParameterException(command.commandLine(), "--threads must be from 1 to " + MAX_THREADS + ", was " + value);
        }
        threads = value;
    }

    public int count() {
        return threads;
    }
}
