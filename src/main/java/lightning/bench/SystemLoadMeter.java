package lightning.bench;

import java.util.Optional;
import lightning.bench.result.SystemLoad;

/** Meter of other work on the machine since its creation. */
final class SystemLoadMeter {
    private final double loadAtStart = SystemLoad.average();
    private final Optional<ProcessorTime> start = ProcessorTime.now();

    /** Returns the load so far. */
    SystemLoad current() {
        Optional<ProcessorTime> now = start.flatMap(_ -> ProcessorTime.now());
        return new SystemLoad(loadAtStart, SystemLoad.average(), now.isEmpty() ? Double.NaN : now.get().otherShareSince(start.get()));
    }
}
