package lightning.scene.material;

import io.soabase.recordbuilder.core.RecordBuilder;
import java.util.Optional;
import lightning.scene.Camera;
import lightning.scene.asset.TextureMap;

/**
 * Opacity cutout of a surface. Camera, mirror, refraction and shadow rays pass through the points that it removes.
 *
 * @param map    opacity in the map's first channel, 0 … 1
 * @param cutoff opacity below which a point is removed
 * @param clip   part of a plane that is removed: always {@link Clip#NONE} in materials of the document
 */
@RecordBuilder
public record AlphaCutout(Optional<TextureMap> map, double cutoff, Clip clip) implements AlphaCutoutBuilder.With {

    /** Part of a plane that is removed to make the face of a light. */
    public enum Clip {
        /** Nothing. */
        NONE,
        /** Rays pass through the lower side, in the plane's own axes. */
        BACK,
        /** Rays pass through the lower side, and through the upper one outside the inscribed circle. */
        BACK_AND_CORNERS
    }

    /** No cutout: the whole surface is present. */
    public static final AlphaCutout NONE = new AlphaCutout(MaterialAttribute.CUTOUT.initial(), MaterialAttribute.CUTOFF.initial());

    public AlphaCutout {
        MaterialAttribute.CUTOFF.check(cutoff);
    }

    /** Creates a cutout by a map. */
    public AlphaCutout(Optional<TextureMap> map, double cutoff) {
        this(map, cutoff, Clip.NONE);
    }

    /** Returns whether any point may be removed. */
    public boolean isActive() {
        return hasHoles() || clip != Clip.NONE;
    }

    /** Returns whether its map may remove points. */
    public boolean hasHoles() {
        return map.isPresent() && cutoff > 0;
    }

    /** Returns whether both remove the same points of every surface. */
    public boolean hasSameHoles(AlphaCutout o) {
        return this == o || clip == o.clip && hasHoles() == o.hasHoles()
                && (!hasHoles() || cutoff == o.cutoff && map.get().hasSameTexels(o.map.get()));
    }
}
