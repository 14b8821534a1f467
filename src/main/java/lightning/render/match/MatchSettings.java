package lightning.render.match;

import java.util.Optional;
import java.util.Set;
import lightning.scene.Contribution;

/**
 * What a match may change, and how it compares.
 *
 * @param lights   what it may change; empty for all that shines
 * @param changes  what it changes besides intensities; environments keep their color
 * @param exposure whether the brightness of the reference counts
 * @param white    whether the tint of the reference counts; where it does not, neither does the brightness
 * @param steadiness pull of each light toward its present intensity, relative to the light that lights most of what counts; ≥ 0
 */
public record MatchSettings(Optional<Set<Contribution>> lights, Set<MatchChange> changes, Reference exposure, Reference white,
        double steadiness) {
    /** Steadiness for paint: a light that hardly lights it changes little. */
    public static final double PAINTED = 0.005;
    /** Whether a property of the reference counts. */
    public enum Reference {
        /** The picture shall have the same. */
        FIXED,
        /** The reference is scaled to fit the picture. */
        FREE
    }

    /** Intensities of all lights, brightness and tint count. */
    public static final MatchSettings DEFAULT = new MatchSettings(Optional.empty(), Set.of(), Reference.FIXED, Reference.FIXED, 0);

    /** Returns the number of unknown factors of the reference: none, one for all channels, or one for each. */
    int referenceFactors() {
        return white == Reference.FREE ? 3 : exposure == Reference.FREE ? 1 : 0;
    }

    /** Returns whether a light or environment may change. */
    boolean mayChange(Contribution light) {
        return lights.isEmpty() || lights.get().contains(light);
    }

    /** Returns whether it changes anything that takes renders to find. */
    boolean isSearch() {
        return changes.stream().anyMatch(MatchChange::isSearched);
    }
}
