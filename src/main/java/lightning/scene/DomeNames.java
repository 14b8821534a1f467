package lightning.scene;

import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import lightning.base.text.Quote;
import lightning.base.text.RefusalException;
import lightning.scene.light.LightRig;
import lightning.scene.value.SceneLimits;

/** Checks of the names of domes. */
final class DomeNames {
    private DomeNames() {}

    /**
     * Returns an immutable copy of domes, the world's own first, without it if it has its initial values.
     *
     * @throws IllegalArgumentException if two have the same name, or there are more than {@link SceneLimits#MAX_DOMES}
     */
    static List<Dome> check(List<Dome> domes) {
        SceneLimits.checkRange("the number of domes", domes.stream().filter(dome -> !dome.isOwn()).count(), 0, SceneLimits.MAX_DOMES);
        Set<String> names = new HashSet<>();
        for (Dome dome : domes) {
            if (!names.add(dome.name())) {
                throw taken(dome);
            }
        }
        return domes.stream().filter(dome -> !dome.equals(Dome.INITIAL)).sorted(Comparator.comparing(dome -> !dome.isOwn())).toList();
    }

    /** @throws IllegalArgumentException if a light, a light group, a shape or a group has the name of a dome */
    static void checkDisjoint(List<Dome> domes, LightRig rig, Stage stage) {
        for (Dome dome : domes) {
            if (rig.isNameUsed(dome.name()) || stage.hasNode(dome.name())) {
                throw taken(dome);
            }
        }
    }

    private static IllegalArgumentException taken(Dome dome) {
        return new RefusalException("dome " + Quote.of(dome.name()) + ": the name is already taken");
    }
}
