package lightning.bench;

import java.util.Optional;

/** Measures other work on the machine from when it is made. */
final class LoadMeter {
    private final double before = Load.average();
    private final Optional<ProcessorTime> start = ProcessorTime.now();

    /** The load until now. */
    Load load() {
        Optional<ProcessorTime> now = start.flatMap(_ -> ProcessorTime.now());
        return new Load(before, Load.average(), now.isEmpty() ? Double.NaN : now.get().othersSince(start.get()));
    }
}
