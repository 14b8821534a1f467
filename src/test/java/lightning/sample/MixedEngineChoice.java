package lightning.sample;

import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import lightning.render.engine.Engine;
import lightning.render.engine.EngineChoice;
import lightning.render.engine.choice.Engines;

/**
 * Random choice of an engine for each request of a tile, so that several engines contribute to an image and to a tile's history. One seed
 * in four uses only the scalar engine, another only the vector engine. Independent of threads.
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

    /** Mixes a counter (Steele, Lea and Flood, 2014). */
    private static long scramble(long counter) {
        long z = counter * 0x9E3779B97F4A7C15L;
        z = (z ^ z >>> 30) * 0xBF58476D1CE4E5B9L;
        z = (z ^ z >>> 27) * 0x94D049BB133111EBL;
        return z ^ z >>> 31;
    }
}
