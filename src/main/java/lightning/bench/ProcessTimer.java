package lightning.bench;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import lightning.bench.result.TimeSamples;
import lightning.render.measure.Timing;
import org.jspecify.annotations.Nullable;

/** Timer of whole processes that run one after the other. */
final class ProcessTimer {
    private final List<Double> wallMs = new ArrayList<>();
    private final List<Double> processorMs = new ArrayList<>();

    /** Starts a process and waits for its end. */
    @FunctionalInterface
    interface ProcessRun {
        void run() throws IOException, InterruptedException;
    }

    void measure(ProcessRun work) throws IOException, InterruptedException {
        OptionalDouble before = childrenMs();
        long start = System.nanoTime();
        work.run();
        wallMs.add((System.nanoTime() - start) / 1e6);
        OptionalDouble after = childrenMs();
        if (before.isPresent() && after.isPresent()) {
            processorMs.add(after.getAsDouble() - before.getAsDouble());
        }
    }

    TimeSamples wallTime() {
        return TimeSamples.of(new Timing(wallMs));
    }

    /** Returns the processor times; null if the system does not report them. */
    @Nullable
    TimeSamples processorTime() {
        return processorMs.size() < wallMs.size() ? null : TimeSamples.of(new Timing(processorMs));
    }

    private static OptionalDouble childrenMs() {
        return ProcessorTime.now().map(time -> OptionalDouble.of(time.children() * ProcessorTime.TICK_MS)).orElse(OptionalDouble.empty());
    }
}
