package lightning.scene;

import java.util.Optional;

/**
 * Which points of a surface are not there: rays pass them, be they the eye's, mirrored, refracted, or on their way to a light.
 *
 * @param map how much is there, by the first of its channels, 0 … 1
 * @param cutoff where less is there, nothing is
 */
public record AlphaCutout(Optional<TextureMap> map, double cutoff) {
    /** A surface of which all is there. */
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

    /** Whether any point may be missing. */
    public boolean isActive() {
        return map.isPresent() && cutoff > 0;
    }

    /** Whether the same points of every surface are missing by another. */
    public boolean hasSameHoles(AlphaCutout o) {
        return this == o || isActive() == o.isActive() && (!isActive() || cutoff == o.cutoff && map.get().hasSameTexels(o.map.get()));
    }
}
