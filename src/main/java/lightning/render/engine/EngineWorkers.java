package lightning.render.engine;

import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.stream.Stream;

/**
 * Workers of one thread: one per engine, created on first use.
 *
 * @param <W> worker with one engine and scratch memory
 */
public final class EngineWorkers<W> {
    private final EngineChoice engineChoice;
    private final Function<Engine, W> factory;
    private final Map<Engine, W> workers = new LinkedHashMap<>();

    private EngineWorkers(EngineChoice engineChoice, Function<Engine, W> factory) {
        this.engineChoice = engineChoice;
        this.factory = factory;
    }

    /** Creates one object for each of {@code threads} threads. */
    public static <W> List<EngineWorkers<W>> perThread(int threads, EngineChoice engineChoice, Function<Engine, W> factory) {
        return Stream.generate(() -> new EngineWorkers<>(engineChoice, factory)).limit(threads).toList();
    }

    /** Returns the worker for tile {@code tile}. */
    public W forTile(int tile) {
        return workers.computeIfAbsent(engineChoice.forTile(tile), factory);
    }

    /** Returns all workers used so far. */
    public Collection<W> workers() {
        return workers.values();
    }
}
