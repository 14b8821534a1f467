package lightning.cli;

import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import lightning.cli.output.Console;
import lightning.scene.SceneElement;
import lightning.scene.shot.Shot;
import lightning.scene.shot.Track;

/** Notes of lights whose new values a shot overrides: their keyframes stay as they are. */
final class KeyedLightNotes {
    /** Attributes that a match or a review sets. */
    private static final Set<String> SET = Set.of("intensity", "color", "on", "solo");

    private KeyedLightNotes() {}

    /** Prints a note for each of some lights that has keyframes of what was set. */
    static void print(Optional<Shot> shot, Collection<String> lights, Console console) {
        for (String light : lights) {
            List<String> keyed = shot.stream().flatMap(s -> s.tracks().stream())
                    .filter(track -> track.target().equals(new SceneElement.OfLight(light)) && SET.contains(track.attribute()))
                    .map(Track::attribute).toList();
            if (!keyed.isEmpty()) {
                console.warn("%s has keyframes of its %s, which the shot shows in place of the new value", light,
                        String.join(" and ", keyed));
            }
        }
    }
}
