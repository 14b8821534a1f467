package lightning.base.process;

import java.io.IOException;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.stream.Stream;
import lightning.base.text.PrintableText;
import lightning.base.work.Progress;

/** Program that converts a file in a process of its own, which ends with this one, whatever happens. */
public final class ConverterProcess {
    private static final int POLL_MILLISECONDS = 50;
    private static final int END_SECONDS = 10;
    private static final int MAX_MESSAGE = 300;

    private ConverterProcess() {}

    /**
     * Runs a program to its end; returns its exit code. Its input stays open: when this process ends in any way, the system closes it, and the
     * program should end.
     *
     * @param cpuLimit of processor time, where the system tells it
     * @throws TimeoutException if it takes longer than a limit
     * @throws CancellationException if {@code progress} requested cancellation
     * @throws IOException if it cannot be started
     */
    public static int run(ProcessBuilder program, Duration limit, Duration cpuLimit, Progress progress)
            throws IOException, TimeoutException {
        Process process = program.start();
        return await(process, process.onExit(), limit, cpuLimit, progress).exitValue();
    }

    /** Returns a message of a program, printable on one line and of at most 300 characters. */
    public static String shortened(String message) {
        return PrintableText.escape(message.length() > MAX_MESSAGE ? message.substring(0, MAX_MESSAGE) + "…" : message);
    }

    /** Waits for a result of a process, which is ended if there is none. */
    static <T> T await(Process process, Future<T> result, Duration limit, Duration cpuLimit, Progress progress)
            throws IOException, TimeoutException {
        long end = System.nanoTime() + limit.toNanos();
        try {
            while (true) {
                try {
                    return result.get(POLL_MILLISECONDS, TimeUnit.MILLISECONDS);
                } catch (TimeoutException e) {
                    progress.checkCanceled("canceled while another program converted the file");
                    boolean isOverCpu = process.info().totalCpuDuration().filter(used -> used.compareTo(cpuLimit) > 0).isPresent();
                    if (isOverCpu || System.nanoTime() - end > 0) {
                        throw e;
                    }
                }
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new CancellationException("interrupted while another program converted the file");
        } catch (ExecutionException e) {
            throw new IOException(e);
        } finally {
            if (!result.isDone()) {
                end(process);
            }
        }
    }

    /** Ends a process and those it started; waits until they no longer write into the folder, which is removed next. */
    private static void end(Process process) throws IOException {
        List<ProcessHandle> all = Stream.concat(process.descendants(), Stream.of(process.toHandle())).toList();
        all.forEach(ProcessHandle::destroyForcibly);
        process.getOutputStream().close();
        for (ProcessHandle handle : all) {
            try {
                handle.onExit().get(END_SECONDS, TimeUnit.SECONDS);
            } catch (ExecutionException | TimeoutException e) {
                // The system ends it later.
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
                return;
            }
        }
    }
}
