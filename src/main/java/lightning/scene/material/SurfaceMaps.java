package lightning.scene.material;

import io.soabase.recordbuilder.core.RecordBuilder;
import java.util.Optional;
import lightning.scene.asset.TextureChannel;
import lightning.scene.asset.TextureMap;

/**
 * Images that multiply the roughness and the metalness of an opaque principled material point by point. One image may hold both in different
 * channels, as in glTF 2.0.
 *
 * @param roughness        factors of the roughness
 * @param roughnessChannel channel that has them
 * @param metalness        factors of the metalness
 * @param metalnessChannel channel that has them
 */
@RecordBuilder
public record SurfaceMaps(Optional<TextureMap> roughness, TextureChannel roughnessChannel, Optional<TextureMap> metalness,
        TextureChannel metalnessChannel) implements SurfaceMapsBuilder.With {
    /** No maps. */
    public static final SurfaceMaps NONE =
            new SurfaceMaps(Optional.empty(), TextureChannel.GREEN, Optional.empty(), TextureChannel.BLUE);

    /** Returns whether both multiply the roughness in the same way. */
    public boolean hasSameRoughness(SurfaceMaps o) {
        return roughness.equals(o.roughness) && (roughness.isEmpty() || roughnessChannel == o.roughnessChannel);
    }

    /** Returns the mean factor of the roughness, 0…1; 1 without a map. */
    public float meanRoughness() {
        return mean(roughness, roughnessChannel);
    }

    /** Returns the mean factor of the metalness, 0…1; 1 without a map. */
    public float meanMetalness() {
        return mean(metalness, metalnessChannel);
    }

    private static float mean(Optional<TextureMap> map, TextureChannel channel) {
        return map.map(m -> m.image().areas().mean(0, 0, 1, 1, channel.ordinal())).orElse(1f);
    }
}
