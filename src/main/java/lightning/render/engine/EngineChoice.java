package lightning.render.engine;

/** Selection of an engine per tile. Called by all threads, once for each tile. */
@FunctionalInterface
public interface EngineChoice {
    /** Returns the engine for tile {@code tile} of an image. */
    Engine forTile(int tile);
}
