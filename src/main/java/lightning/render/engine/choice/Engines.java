package lightning.render.engine.choice;

import lightning.render.engine.Engine;
import lightning.render.engine.EngineChoice;
import lightning.render.engine.lanes.LaneEngine;
import lightning.render.engine.scalar.ScalarEngine;

/** The engines there are, and which one this process uses where nobody says another. */
public final class Engines {
    public static final Engine SCALAR = new ScalarEngine();
    public static final Engine LANES = new LaneEngine();

    /**
     * What is fastest here once it is compiled, however long that takes: for who measures, and warms up before. No yardstick may
     * be slow.
     */
    public static final EngineChoice FASTEST = _ -> hasLanes() ? LANES : SCALAR;

    private static volatile EngineChoice current = _ -> SCALAR;

    /** What the process uses at the time when a tile is asked for: scalar first. */
    public static final EngineChoice CURRENT = tile -> current.forTile(tile);

    private Engines() {}

    /** Whether this machine and this Java have lanes that are worth it: the vector module, and vectors wide enough. */
    public static boolean hasLanes() {
        return LaneSupport.AVAILABLE;
    }

    /** Whether the process uses what is fastest here: it is warm then, or has nothing to warm up. */
    public static boolean isFastestInUse() {
        return current == FASTEST;
    }

    /** Makes tiles from now on be asked of others. What is compiled belongs to a process, and so does this. */
    public static void use(EngineChoice choice) {
        current = choice;
    }

    /** Found out when it is asked for first: in a short process never. */
    private static final class LaneSupport {
        static final boolean AVAILABLE = ModuleLayer.boot().findModule("jdk.incubator.vector").isPresent() && LaneEngine.hasWideVectors();
    }
}
