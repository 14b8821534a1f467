package lightning.sample;

import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import lightning.render.engine.Engine;
import lightning.render.engine.EngineChoice;
import lightning.render.engine.choice.Engines;

/**
 * Draws an engine each time a tile is asked for, so that a picture's tiles, and what becomes of one tile by edits, come from
 * several; for one seed in four all from the scalar engine, for another all from the lanes. Which does not depend on threads.
 */
public final class MixedEngineChoice implements EngineChoice {
    private final long seed;
    private final Map<Integer, Integer> choiceCounts = new ConcurrentHashMap<>();

    public MixedEngineChoice(long seed) {
        this.seed = seed;
    }

    @Override
    public Engine forTile(int tile) {
        int kind = (int) (seed & 3);
        boolean lanes =
                kind == 1 || kind > 1 && scramble(seed + 31L * scramble(tile + 31L * choiceCounts.merge(tile, 1, Integer::sum))) < 0;
        return lanes ? Engines.LANES : Engines.SCALAR;
    }

    /** Steele, Lea and Flood's mix of a counter (2014). */
    private static long scramble(long counter) {
        long z = counter * 0x9E3779B97F4A7C15L;
        z = (z ^ z >>> 30) * 0xBF58476D1CE4E5B9L;
        z = (z ^ z >>> 27) * 0x94D049BB133111EBL;
        return z ^ z >>> 31;
    }
}
