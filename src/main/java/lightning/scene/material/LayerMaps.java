package lightning.scene.material;

import io.soabase.recordbuilder.core.RecordBuilder;
import java.util.Optional;
import lightning.base.math.Rgb;
import lightning.scene.asset.TextureChannel;
import lightning.scene.asset.TextureMap;

/**
 * Images that multiply properties of the layers over an opaque principled material point by point: its coat and its sheen.
 *
 * @param coat                  factors of the weight of the coat
 * @param coatChannel           channel that has them
 * @param coatRoughness         factors of its roughness
 * @param coatRoughnessChannel  channel that has them
 * @param coatNormal            tangent-space normal map of the coat
 * @param coatStrength          factor of its tilt
 * @param sheen                 factors of the color of the sheen
 * @param sheenRoughness        factors of its roughness
 * @param sheenRoughnessChannel channel that has them
 */
@RecordBuilder
public record LayerMaps(Optional<TextureMap> coat, TextureChannel coatChannel, Optional<TextureMap> coatRoughness,
        TextureChannel coatRoughnessChannel, Optional<TextureMap> coatNormal, double coatStrength, Optional<TextureMap> sheen,
        Optional<TextureMap> sheenRoughness,
        TextureChannel sheenRoughnessChannel) implements LayerMapsBuilder.With {
    /** No maps. */
    public static final LayerMaps NONE = new LayerMaps(Optional.empty(), TextureChannel.RED, Optional.empty(), TextureChannel.GREEN,
            Optional.empty(), 1, Optional.empty(), Optional.empty(), TextureChannel.RED);

    /** Returns a coat with the means of its maps. */
    Coat mean(Coat of) {
        return of.withWeight(clamp(of.weight() * SurfaceMaps.mean(coat, coatChannel)))
                .withRoughness(clamp(of.roughness() * SurfaceMaps.mean(coatRoughness, coatRoughnessChannel)));
    }

    /** Returns a sheen with the means of its maps. */
    Sheen mean(Sheen of) {
        Rgb color = sheen.map(map -> of.color().times(map.image().areas().mean())).orElse(of.color());
        return new Sheen(color, clamp(of.roughness() * SurfaceMaps.mean(sheenRoughness, sheenRoughnessChannel)));
    }

    private static double clamp(double value) {
        return Math.clamp(value, 0, 1);
    }
}
