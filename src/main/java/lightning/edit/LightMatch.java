package lightning.edit;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import lightning.scene.Light;

/**
 * Which light of an edited list goes on from which light of the list before: the one of the same name; a light with a
 * new name from the one at the same place of a list of the same length, if that one's name is gone: it was renamed.
 */
record LightMatch(List<Light> before, List<Light> after) {

    /** For each light after the edit its place before, or −1. */
    List<Integer> origins() {
        List<Integer> origins = new ArrayList<>();
        for (int i = 0; i < after.size(); i++) {
            int known = place(before, after.get(i).name());
            boolean renamed = known < 0 && before.size() == after.size() && place(after, before.get(i).name()) < 0;
            origins.add(renamed ? i : known);
        }
        return origins;
    }

    /** The new name of a light; empty if it is gone. */
    Optional<String> nameAfter(String nameBefore) {
        int place = place(before, nameBefore);
        int now = place < 0 ? -1 : origins().indexOf(place);
        return now < 0 ? Optional.empty() : Optional.of(after.get(now).name());
    }

    private static int place(List<Light> lights, String name) {
        return IntStream.range(0, lights.size()).filter(i -> lights.get(i).name().equals(name)).findFirst().orElse(-1);
    }
}
