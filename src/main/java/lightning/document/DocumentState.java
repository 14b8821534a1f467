package lightning.document;

import static java.util.Objects.requireNonNull;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.LongSupplier;
import java.util.stream.Stream;
import lightning.scene.Scene;
import lightning.scene.SceneElement;
import lightning.scene.light.Light;
import lightning.scene.light.LightMatcher;
import lightning.scene.shot.AnimatedScene;
import lightning.scene.shot.Shot;
import lightning.scene.shot.Track;

/**
 * Scene with numbered lights, whose numbers survive renames, and a history per light. Immutable, so that undoing a document step also
 * restores the lights' histories.
 *
 * @param ids number of each light of the scene
 */
record DocumentState(AnimatedScene content, List<Long> ids, Map<Long, LightHistory> lightHistories) {
    DocumentState {
        ids = List.copyOf(ids);
        lightHistories = Map.copyOf(lightHistories);
    }

    static DocumentState initial(AnimatedScene content, LongSupplier nextId) {
        return new DocumentState(content, content.base().lights().stream().map(_ -> nextId.getAsLong()).toList(), Map.of());
    }

    /** Returns the scene without keyframes applied. */
    Scene scene() {
        return content.base();
    }

    /** Returns the state after an edit. Each light whose properties or keyframes changed gets a step in its own history. */
    DocumentState afterEdit(AnimatedScene edited, LongSupplier nextId) {
        List<Light> lights = edited.base().lights();
        boolean sameKeys = content.shot().equals(edited.shot());
        LightMatcher match = new LightMatcher(scene().lights(), lights);
        List<Long> newIds = new ArrayList<>();
        Map<Long, LightHistory> newHistories = new HashMap<>();
        for (int i = 0; i < lights.size(); i++) {
            int origin = match.originIndex(i);
            long id = origin < 0 ? nextId.getAsLong() : ids.get(origin);
            newIds.add(id);
            if (origin >= 0) {
                Light oldLight = scene().lights().get(origin);
                LightHistory history = lightHistory(id);
                boolean isUnchanged = oldLight.equals(lights.get(i))
                        && (sameKeys || lightTracks(content, oldLight).equals(lightTracks(edited, oldLight)));
                newHistories.put(id, isUnchanged ? history : history.afterEdit(oldLight, lightTracks(content, oldLight)));
            }
        }
        return new DocumentState(edited, newIds, newHistories);
    }

    /**
     * Undoes or redoes one step of a light.
     *
     * @throws IllegalArgumentException if another light has taken its former name
     */
    DocumentState stepLight(long id, boolean isUndo) {
        int index = ids.indexOf(id);
        Light light = scene().lights().get(index);
        List<Track> keys = lightTracks(content, light);
        LightHistory history = lightHistory(id);
        LightHistory.Entry link = requireNonNull(isUndo ? history.past() : history.future());
        List<Light> lights = new ArrayList<>(scene().lights());
        lights.set(index, link.light());
        Map<Long, LightHistory> newHistories = new HashMap<>(lightHistories);
        newHistories.put(id, isUndo ? history.afterUndo(light, keys) : history.afterRedo(light, keys));
        Optional<Shot> shot = content.shot().map(s -> s.withTracks(Stream.concat(
                s.tracks().stream().filter(t -> !t.target().equals(new SceneElement.OfLight(light.name()))), link.keys().stream())
                .toList()));
        return new DocumentState(new AnimatedScene(scene().withLights(lights), shot), ids, newHistories);
    }

    /** Returns the tracks of a light. */
    static List<Track> lightTracks(AnimatedScene content, Light light) {
        return content.shot().stream().flatMap(s -> s.tracks().stream())
                .filter(t -> t.target().equals(new SceneElement.OfLight(light.name())))
                .toList();
    }

    LightHistory lightHistory(long id) {
        return lightHistories.getOrDefault(id, LightHistory.EMPTY);
    }
}
