package lightning.render.shading;

import lightning.render.trace.MaterialTable;
import org.jspecify.annotations.Nullable;

/**
 * Light that the materials of a scene emit in one film: glow, bulbs, or reflected ambient light.
 *
 * @param bulbs materials that are bulbs of the film's light; null if none is
 */
public record FilmEmission(MaterialTable materials, FilmPart part, boolean @Nullable [] bulbs) {
    // An array in a record: written once by its creator, never after.

    /** Returns the emission in a film. */
    public static FilmEmission of(MaterialTable materials, FilmParts parts, int part) {
        FilmPart its = parts.get(part);
        return new FilmEmission(materials, its,
                its.kind() == FilmPart.Kind.LIGHT ? materials.bulbsOf(parts.lights()[its.index()].light().name()) : null);
    }

    /** Returns one channel of what a material emits, before its glow map and without the share that its surface reflects. */
    public float amount(int m, int channel) {
        return switch (part.kind()) {
            case LIGHT -> bulbs == null || !bulbs[m] ? 0 : materials.bulbGlow(m, channel) * part.inside().channel(channel);
            case AMBIENCE -> materials.ambient(m, channel) * part.inside().channel(channel);
            case REST -> materials.ownGlow(m, channel);
            case ENVIRONMENT_LIGHT, ENVIRONMENT_IMAGE -> 0;
        };
    }

    /** Returns whether the glow maps of materials multiply it. */
    public boolean isMapped() {
        return part.kind() != FilmPart.Kind.AMBIENCE;
    }
}
