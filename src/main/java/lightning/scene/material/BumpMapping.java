package lightning.scene.material;

import io.soabase.recordbuilder.core.RecordBuilder;
import java.util.Optional;
import lightning.scene.asset.TextureMap;

/**
 * Bump and normal mapping of a surface: changes its normals, but moves no point.
 *
 * @param bump      height map, by luminance, 0 … 1
 * @param height    height of white above black, scene units; negative values invert the map
 * @param normalMap tangent-space normal map as in glTF 2.0
 * @param strength  factor of the normal map's tilt
 */
@RecordBuilder
public record BumpMapping(Optional<TextureMap> bump, double height, Optional<TextureMap> normalMap, double strength)
        implements BumpMappingBuilder.With {
    /** Smooth surface. */
    public static final BumpMapping NONE = new BumpMapping(MaterialAttribute.BUMP.initial(), MaterialAttribute.BUMP_HEIGHT.initial(),
            MaterialAttribute.NORMAL_MAP.initial(), MaterialAttribute.NORMAL_STRENGTH.initial());

    public BumpMapping {
        MaterialAttribute.BUMP_HEIGHT.check(height);
        MaterialAttribute.NORMAL_STRENGTH.check(strength);
    }

    /** Returns whether a bump map changes any height. */
    public boolean hasBumpMap() {
        return bump.isPresent() && height != 0;
    }

    /** Returns whether a normal map tilts any normal. */
    public boolean hasNormalMap() {
        return normalMap.isPresent() && strength != 0;
    }

    /** Returns whether all normals stay unchanged. */
    public boolean isFlat() {
        return !hasBumpMap() && !hasNormalMap();
    }

    /** Returns whether some normals may change: a bump map of one pixel has the same height everywhere. */
    public boolean bendsNormals() {
        return hasNormalMap() || hasBumpMap() && bump.get().image().width() * (long) bump.get().image().height() > 1;
    }

    /** Returns whether both give every surface the same normals. */
    public boolean hasSameNormals(BumpMapping o) {
        return this == o || hasBumpMap() == o.hasBumpMap() && hasNormalMap() == o.hasNormalMap()
                && (!hasBumpMap() || height == o.height && bump.get().hasSameTexels(o.bump.get()))
                && (!hasNormalMap() || strength == o.strength && normalMap.get().hasSameTexels(o.normalMap.get()));
    }
}
