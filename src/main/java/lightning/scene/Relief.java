package lightning.scene;

import io.soabase.recordbuilder.core.RecordBuilder;
import java.util.Optional;

/**
 * How a surface is shaded as if it were not smooth: only its normals change, no point of it moves.
 *
 * @param bump     a picture of heights, by their luminance, 0 … 1
 * @param height   how much higher white is than black, scene units; below 0 black is higher
 * @param normals  a picture of normals, as glTF 2.0 has them
 * @param strength a factor on how far these lean
 */
@RecordBuilder
public record Relief(Optional<TextureMap> bump, double height, Optional<TextureMap> normals, double strength)
        implements ReliefBuilder.With {
    /** A smooth surface. */
    public static final Relief NONE = new Relief(MaterialAttribute.BUMP.initial(), MaterialAttribute.HEIGHT.initial(),
            MaterialAttribute.NORMALS.initial(), MaterialAttribute.STRENGTH.initial());

    public Relief {
        MaterialAttribute.HEIGHT.check(height);
        MaterialAttribute.STRENGTH.check(strength);
    }

    /** Whether there are heights that differ. */
    public boolean bumps() {
        return bump.isPresent() && height != 0;
    }

    /** Whether there are normals that lean. */
    public boolean leans() {
        return normals.isPresent() && strength != 0;
    }

    /** Whether it leaves every normal as it is. */
    public boolean isFlat() {
        return !bumps() && !leans();
    }

    /** Whether it gives every surface the normals that another gives it. */
    public boolean hasNormalsOf(Relief o) {
        return this == o || bumps() == o.bumps() && leans() == o.leans()
                && (!bumps() || height == o.height && bump.get().hasTexelsOf(o.bump.get()))
                && (!leans() || strength == o.strength && normals.get().hasTexelsOf(o.normals.get()));
    }
}
