package lightning.bench;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import lightning.accuracy.Timing;

/** How long processes take that are started one after the other, from the start of each to its end. */
final class ProcessTimes {
    /** What Linux tells of this process; among it, processor time of all processes that it started and that have ended. */
    private static final Path STATUS = Path.of("/proc/self/stat");
    /** The numbers of children's time in user mode and in the kernel, counted behind the name of the program, in ticks. */
    private static final int USER = 13;
    private static final int KERNEL = 14;
    private static final double TICK_MS = 10;

    private final List<Double> wallMs = new ArrayList<>();
    private final List<Double> processorMs = new ArrayList<>();

    /** Starts a process and waits for its end. */
    @FunctionalInterface
    interface Work {
        void run() throws IOException, InterruptedException;
    }

    void measure(Work work) throws IOException, InterruptedException {
        OptionalDouble before = childrenMs();
        long start = System.nanoTime();
        work.run();
        wallMs.add((System.nanoTime() - start) / 1e6);
        OptionalDouble after = childrenMs();
        if (before.isPresent() && after.isPresent()) {
            processorMs.add(after.getAsDouble() - before.getAsDouble());
        }
    }

    Samples wall() {
        return Samples.of(new Timing(wallMs));
    }

    /** Null where the system does not tell. */
    Samples processor() {
        return processorMs.size() < wallMs.size() ? null : Samples.of(new Timing(processorMs));
    }

    private static OptionalDouble childrenMs() {
        try {
            String text = Files.readString(STATUS);
            String[] numbers = text.substring(text.lastIndexOf(')') + 2).split(" ");
            return OptionalDouble.of((Double.parseDouble(numbers[USER]) + Double.parseDouble(numbers[KERNEL])) * TICK_MS);
        } catch (IOException | RuntimeException e) {
            return OptionalDouble.empty();
        }
    }
}
