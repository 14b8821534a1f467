package lightning.render.trace;

import java.util.stream.IntStream;
import lightning.render.trace.tree.Bvh;
import org.jspecify.annotations.Nullable;

/**
 * Primitives that block or tint shadow rays.
 *
 * @param shadowCasters those that cast shadows; null if all do
 * @param tintCasters   those that transmit and tint light; null if none does
 * @param tintBvh       BVH over these; null if there are none
 */
record ShadowBlockers(boolean @Nullable [] shadowCasters, boolean @Nullable [] tintCasters, @Nullable Bvh tintBvh) {
    static final ShadowBlockers ALL = new ShadowBlockers(null, null, null);

    boolean castShadows() {
        return shadowCasters == null || IntStream.range(0, shadowCasters.length).anyMatch(s -> shadowCasters[s]);
    }
}
