package lightning.scene;

import java.util.Optional;

/**
 * Opacity cutout of a surface. Camera, mirror, refraction and shadow rays pass through the points that it removes.
 *
 * @param map    opacity in the map's first channel, 0 … 1
 * @param cutoff opacity below which a point is removed
 */
public record AlphaCutout(Optional<TextureMap> map, double cutoff) {
    /** No cutout: the whole surface is present. */
    public static final AlphaCutout NONE = new AlphaCutout(MaterialAttribute.CUTOUT.initial(), MaterialAttribute.CUTOFF.initial());

    public AlphaCutout {
        MaterialAttribute.CUTOFF.check(cutoff);
    }

    public AlphaCutout withMap(Optional<TextureMap> v) {
        return new AlphaCutout(v, cutoff);
    }

    public AlphaCutout withCutoff(double v) {
        return new AlphaCutout(map, v);
    }

    /** Returns whether any point may be removed. */
    public boolean isActive() {
        return map.isPresent() && cutoff > 0;
    }

    /** Returns whether both remove the same points of every surface. */
    public boolean hasSameHoles(AlphaCutout o) {
        return this == o || isActive() == o.isActive() && (!isActive() || cutoff == o.cutoff && map.get().hasSameTexels(o.map.get()));
    }
}
