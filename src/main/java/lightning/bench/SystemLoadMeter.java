package lightning.bench;

import java.util.Optional;

/** Measures other work on the machine from when it is made. */
final class SystemLoadMeter {
    private final double loadAtStart = SystemLoad.average();
    private final Optional<ProcessorTime> start = ProcessorTime.now();

    /** The load until now. */
    SystemLoad current() {
        Optional<ProcessorTime> now = start.flatMap(_ -> ProcessorTime.now());
        return new SystemLoad(loadAtStart, SystemLoad.average(), now.isEmpty() ? Double.NaN : now.get().otherShareSince(start.get()));
    }
}
