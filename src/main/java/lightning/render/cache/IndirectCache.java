package lightning.render.cache;

import java.util.Arrays;
import lightning.render.gather.GatherStructure;
import lightning.render.shading.IndirectLight;
import lightning.scene.GatherSettings;

/**
 * Cached indirect light of a scene.
 *
 * @param settings it was computed with
 * @param surfels  rows of the surfels with one layer per light of the scene, in blocks
 * @param light    light that reaches gather points
 */
public record IndirectCache(GatherSettings settings, TileLevel[] surfels, IndirectLight light) {
    // An array in a record: written once by its creator, never after.

    /** Returns the paths of the light. */
    public GatherStructure structure() {
        return light.structure();
    }

    /** Returns the bytes of all columns. */
    public long bytes() {
        return structure().bytes() + Arrays.stream(surfels).mapToLong(block -> block.bytes() - block.rows().bytes()).sum()
                + light.films().bytes();
    }
}
