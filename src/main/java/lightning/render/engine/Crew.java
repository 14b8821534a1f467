package lightning.render.engine;

import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.stream.Stream;

/**
 * Who works on tiles in one thread: one for each engine that tiles are to come from, made when it is needed first.
 *
 * @param <W> who works on tiles, with one engine and scratch memory
 */
public final class Crew<W> {
    private final EngineChoice engines;
    private final Function<Engine, W> make;
    private final Map<Engine, W> made = new LinkedHashMap<>();

    private Crew(EngineChoice engines, Function<Engine, W> make) {
        this.engines = engines;
        this.make = make;
    }

    /** One for each of some threads. */
    public static <W> List<Crew<W>> each(int threads, EngineChoice engines, Function<Engine, W> make) {
        return Stream.generate(() -> new Crew<>(engines, make)).limit(threads).toList();
    }

    /** Who works on tile {@code tile}. */
    public W forTile(int tile) {
        return made.computeIfAbsent(engines.forTile(tile), make);
    }

    /** All who worked so far. */
    public Collection<W> all() {
        return made.values();
    }
}
