package lightning.editor.document;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.LongSupplier;
import java.util.stream.Stream;
import lightning.scene.Light;
import lightning.scene.LightMatch;
import lightning.scene.Scene;
import lightning.scene.shot.AnimatedScene;
import lightning.scene.shot.Shot;
import lightning.scene.shot.Target;
import lightning.scene.shot.Track;

/**
 * A scene with its lights numbered, each number kept through renames, and each light's own history. Immutable, so that
 * undo of the document brings back the lights' histories with the scene.
 *
 * @param ids for each light of the scene its number
 */
record DocumentState(AnimatedScene content, List<Long> ids, Map<Long, LightTrack> tracks) {
    DocumentState {
        ids = List.copyOf(ids);
        tracks = Map.copyOf(tracks);
    }

    static DocumentState first(AnimatedScene content, LongSupplier fresh) {
        return new DocumentState(content, content.still().lights().stream().map(_ -> fresh.getAsLong()).toList(), Map.of());
    }

    /** As it is where nothing has keys. */
    Scene scene() {
        return content.still();
    }

    /** The state after an edit; each light that it changed, or whose keys it changed, can be undone alone. */
    DocumentState after(AnimatedScene edited, LongSupplier fresh) {
        List<Light> lights = edited.still().lights();
        boolean sameKeys = content.shot().equals(edited.shot());
        LightMatch match = new LightMatch(scene().lights(), lights);
        List<Long> newIds = new ArrayList<>();
        Map<Long, LightTrack> newTracks = new HashMap<>();
        for (int i = 0; i < lights.size(); i++) {
            int origin = match.origin(i);
            long id = origin < 0 ? fresh.getAsLong() : ids.get(origin);
            newIds.add(id);
            if (origin >= 0) {
                Light old = scene().lights().get(origin);
                LightTrack track = track(id);
                boolean same = old.equals(lights.get(i)) && (sameKeys || keys(content, old).equals(keys(edited, old)));
                newTracks.put(id, same ? track : track.edited(old, keys(content, old)));
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
        Light now = scene().lights().get(place);
        List<Track> keys = keys(content, now);
        LightTrack track = track(id);
        LightTrack.Link link = back ? track.past() : track.future();
        List<Light> lights = new ArrayList<>(scene().lights());
        lights.set(place, link.light());
        Map<Long, LightTrack> newTracks = new HashMap<>(tracks);
        newTracks.put(id, back ? track.undone(now, keys) : track.redone(now, keys));
        Optional<Shot> shot = content.shot().map(s -> s.withTracks(Stream.concat(
                s.tracks().stream().filter(t -> !t.target().equals(Target.light(now.name()))), link.keys().stream()).toList()));
        return new DocumentState(new AnimatedScene(scene().withLights(lights), shot), ids, newTracks);
    }

    /** Those of a light. */
    static List<Track> keys(AnimatedScene content, Light light) {
        return content.shot().stream().flatMap(s -> s.tracks().stream()).filter(t -> t.target().equals(Target.light(light.name())))
                .toList();
    }

    LightTrack track(long id) {
        return tracks.getOrDefault(id, LightTrack.EMPTY);
    }
}
