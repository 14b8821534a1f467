package lightning.scene.material;

import io.soabase.recordbuilder.core.RecordBuilder;
import java.util.Optional;
import lightning.base.math.Rgb;
import lightning.scene.asset.TextureChannel;
import lightning.scene.asset.TextureMap;

/**
 * Images that multiply properties of the surface of an opaque principled material point by point, below its coat. One image may hold several
 * numbers in different channels, as in glTF 2.0.
 *
 * @param roughness        factors of the roughness
 * @param roughnessChannel channel that has them
 * @param metalness        factors of the metalness
 * @param metalnessChannel channel that has them
 * @param f0               factors of the reflectance of a nonmetal
 * @param f0Channel        channel that has them
 * @param specularTint     factors of the color of a nonmetal's reflection
 */
@RecordBuilder
public record SurfaceMaps(Optional<TextureMap> roughness, TextureChannel roughnessChannel, Optional<TextureMap> metalness,
        TextureChannel metalnessChannel, Optional<TextureMap> f0, TextureChannel f0Channel,
        Optional<TextureMap> specularTint) implements SurfaceMapsBuilder.With {
    /** No maps. */
    public static final SurfaceMaps NONE = new SurfaceMaps(Optional.empty(), TextureChannel.GREEN, Optional.empty(), TextureChannel.BLUE,
            Optional.empty(), TextureChannel.RED, Optional.empty());

    /** Returns whether both multiply the roughness in the same way. */
    public boolean hasSameRoughness(SurfaceMaps o) {
        return roughness.equals(o.roughness) && (roughness.isEmpty() || roughnessChannel == o.roughnessChannel);
    }

    /** Returns whether some of them change the color of what the surface reflects. */
    public boolean changeColors() {
        return metalness.isPresent() || f0.isPresent() || specularTint.isPresent();
    }

    /** Returns the mean factor of the roughness, 0…1; 1 without a map. */
    public float meanRoughness() {
        return mean(roughness, roughnessChannel);
    }

    /** Returns the mean factor of the metalness, 0…1; 1 without a map. */
    public float meanMetalness() {
        return mean(metalness, metalnessChannel);
    }

    /** Returns the mean factor of the reflectance of a nonmetal, 0…1; 1 without a map. */
    public float meanF0() {
        return mean(f0, f0Channel);
    }

    /** Returns the mean factor of the color of a nonmetal's reflection; white without a map. */
    public Rgb meanSpecularTint() {
        return specularTint.map(map -> map.image().areas().mean()).orElse(Rgb.WHITE);
    }

    /** Returns the mean of a channel of a map, 0…1; 1 without a map. */
    static float mean(Optional<TextureMap> map, TextureChannel channel) {
        return map.map(m -> m.image().areas().mean(0, 0, 1, 1, channel.ordinal())).orElse(1f);
    }
}
