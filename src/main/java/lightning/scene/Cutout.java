package lightning.scene;

import java.util.Optional;

/**
 * Which points of a surface are not there: rays pass them, be they the eye's, mirrored, refracted, or on their way to a light.
 *
 * @param cutout how much is there, by the first of its channels, 0 … 1
 * @param cutoff where less is there, nothing is
 */
public record Cutout(Optional<TextureMap> cutout, double cutoff) {
    /** A surface of which all is there. */
    public static final Cutout NONE = new Cutout(MaterialAttribute.CUTOUT.initial(), MaterialAttribute.CUTOFF.initial());

    public Cutout {
        MaterialAttribute.CUTOFF.check(cutoff);
    }

    public Cutout withCutout(Optional<TextureMap> v) {
        return new Cutout(v, cutoff);
    }

    public Cutout withCutoff(double v) {
        return new Cutout(cutout, v);
    }

    /** Whether any point may be missing. */
    public boolean cuts() {
        return cutout.isPresent() && cutoff > 0;
    }

    /** Whether the same points of every surface are missing by another. */
    public boolean hasHolesOf(Cutout o) {
        return this == o || cuts() == o.cuts() && (!cuts() || cutoff == o.cutoff && cutout.get().hasTexelsOf(o.cutout.get()));
    }
}
