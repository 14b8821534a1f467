package lightning.edit;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.LongSupplier;
import lightning.scene.Light;
import lightning.scene.LightMatch;
import lightning.scene.Scene;

/**
 * A scene with its lights numbered, each number kept through renames, and each light's own history. Immutable, so that
 * undo of the document brings back the lights' histories with the scene.
 *
 * @param ids for each light of the scene its number
 */
record DocumentState(Scene scene, List<Long> ids, Map<Long, LightTrack> tracks) {
    DocumentState {
        ids = List.copyOf(ids);
        tracks = Map.copyOf(tracks);
    }

    static DocumentState first(Scene scene, LongSupplier fresh) {
        return new DocumentState(scene, scene.lights().stream().map(_ -> fresh.getAsLong()).toList(), Map.of());
    }

    /** The state after an edit; each light that it changed can be undone alone. */
    DocumentState after(Scene edited, LongSupplier fresh) {
        LightMatch match = new LightMatch(scene.lights(), edited.lights());
        List<Long> newIds = new ArrayList<>();
        Map<Long, LightTrack> newTracks = new HashMap<>();
        for (int i = 0; i < edited.lights().size(); i++) {
            int origin = match.origin(i);
            long id = origin < 0 ? fresh.getAsLong() : ids.get(origin);
            newIds.add(id);
            if (origin >= 0) {
                Light old = scene.lights().get(origin);
                LightTrack track = track(id);
                newTracks.put(id, old.equals(edited.lights().get(i)) ? track : track.edited(old));
            }
        }
        return new DocumentState(edited, newIds, newTracks);
    }

    /**
     * The light set back, or forth again.
     *
     * @throws IllegalArgumentException if another light has taken its name of that time
     */
    DocumentState moved(long id, boolean back) {
        int place = ids.indexOf(id);
        Light now = scene.lights().get(place);
        LightTrack track = track(id);
        List<Light> lights = new ArrayList<>(scene.lights());
        lights.set(place, (back ? track.past() : track.future()).light());
        Map<Long, LightTrack> newTracks = new HashMap<>(tracks);
        newTracks.put(id, back ? track.undone(now) : track.redone(now));
        return new DocumentState(scene.withLights(lights), ids, newTracks);
    }

    LightTrack track(long id) {
        return tracks.getOrDefault(id, LightTrack.EMPTY);
    }
}
