package lightning.render.engine;

/** Which engine makes which tile. Asked by all threads, once for each tile. */
@FunctionalInterface
public interface EngineChoice {
    /** The engine for tile {@code tile} of a picture. */
    Engine forTile(int tile);
}
