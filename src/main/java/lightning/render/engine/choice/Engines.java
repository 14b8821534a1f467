package lightning.render.engine.choice;

import lightning.render.engine.Engine;
import lightning.render.engine.EngineChoice;
import lightning.render.engine.lanes.LaneEngine;
import lightning.render.engine.scalar.ScalarEngine;

/** Available engines, and the current choice of this process. */
public final class Engines {
    public static final Engine SCALAR = new ScalarEngine();
    public static final Engine LANES = new LaneEngine();

    /** Fastest engine here once compiled, regardless of warm-up time: for measurements, which warm up first. */
    public static final EngineChoice FASTEST = _ -> hasLanes() ? LANES : SCALAR;

    private static volatile EngineChoice current = _ -> SCALAR;

    /** Current choice of the process, read for each tile: initially scalar. */
    public static final EngineChoice CURRENT = tile -> current.forTile(tile);

    private Engines() {}

    /** Returns whether this CPU and JVM have useful lanes: the vector module, and vectors wide enough. */
    public static boolean hasLanes() {
        return LaneSupport.AVAILABLE;
    }

    /** Returns whether the process uses the fastest engine: it is warm, or has nothing to warm up. */
    public static boolean isFastestInUse() {
        return current == FASTEST;
    }

    /** Sets the engine choice for all further tiles. Compiled code belongs to the process, and so does this setting. */
    public static void use(EngineChoice choice) {
        current = choice;
    }

    /** Detected on first use; short processes never need it. */
    private static final class LaneSupport {
        static final boolean AVAILABLE = ModuleLayer.boot().findModule("jdk.incubator.vector").isPresent() && LaneEngine.hasWideVectors();
    }
}
