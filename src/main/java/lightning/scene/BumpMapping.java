package lightning.scene;

import io.soabase.recordbuilder.core.RecordBuilder;
import java.util.Optional;

/**
 * How a surface is shaded as if it were not smooth: only its normals change, no point of it moves.
 *
 * @param bump     a picture of heights, by their luminance, 0 … 1
 * @param height   how much higher white is than black, scene units; below 0 black is higher
 * @param normalMap  a picture of normals, as glTF 2.0 has them
 * @param strength a factor on how far these lean
 */
@RecordBuilder
public record BumpMapping(Optional<TextureMap> bump, double height, Optional<TextureMap> normalMap, double strength)
        implements BumpMappingBuilder.With {
    /** A smooth surface. */
    public static final BumpMapping NONE = new BumpMapping(MaterialAttribute.BUMP.initial(), MaterialAttribute.BUMP_HEIGHT.initial(),
            MaterialAttribute.NORMAL_MAP.initial(), MaterialAttribute.NORMAL_STRENGTH.initial());

    public BumpMapping {
        MaterialAttribute.BUMP_HEIGHT.check(height);
        MaterialAttribute.NORMAL_STRENGTH.check(strength);
    }

    /** Whether there are heights that differ. */
    public boolean hasBumpMap() {
        return bump.isPresent() && height != 0;
    }

    /** Whether there are normals that lean. */
    public boolean hasNormalMap() {
        return normalMap.isPresent() && strength != 0;
    }

    /** Whether it leaves every normal as it is. */
    public boolean isFlat() {
        return !hasBumpMap() && !hasNormalMap();
    }

    /** Whether it gives every surface the normals that another gives it. */
    public boolean hasSameNormals(BumpMapping o) {
        return this == o || hasBumpMap() == o.hasBumpMap() && hasNormalMap() == o.hasNormalMap()
                && (!hasBumpMap() || height == o.height && bump.get().hasSameTexels(o.bump.get()))
                && (!hasNormalMap() || strength == o.strength && normalMap.get().hasSameTexels(o.normalMap.get()));
    }
}
