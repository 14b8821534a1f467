package lightning.layer;

import java.util.List;
import java.util.Map;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.format.exr.ExrAttribute;
import lightning.format.exr.ExrChannel;
import lightning.render.engine.Engine;
import lightning.render.trace.SamplePositions;

/** Channels of a file that belong together. Thread-safe. */
interface ChannelSource {
    /** Returns the channels, in any order. */
    List<ExrChannel> channels();

    /** Returns the header's attributes that describe them. */
    default Map<String, ExrAttribute> attributes() {
        return Map.of();
    }

    /**
     * Computes what all writers need, before the first is created.
     *
     * @throws java.util.concurrent.CancellationException if {@code progress} requested cancellation
     */
    default void prepare(WorkerPool workers, Progress progress) {}

    /** Creates a writer for one thread. */
    TileWriter writer(Engine engine);

    /** Writer of single tiles; may hold scratch memory. */
    @FunctionalInterface
    interface TileWriter {
        /**
         * Writes a tile's values.
         *
         * @param centers positions of the tile's pixels
         * @param sink receives them; its channels are those of {@link ChannelSource#channels}
         */
        void write(int tile, SamplePositions centers, TileSink sink);
    }
}
