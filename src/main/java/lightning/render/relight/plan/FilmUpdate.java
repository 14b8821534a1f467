package lightning.render.relight.plan;

import java.util.Arrays;
import java.util.BitSet;
import java.util.Objects;
import java.util.stream.IntStream;
import lightning.render.shading.FilmPart;
import lightning.render.shading.FilmParts;
import lightning.scene.Dome;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import org.jspecify.annotations.Nullable;

/**
 * Change of the films of a picture.
 *
 * @param origin      for each film its number in the last picture; −1 for none
 * @param changed     films that change everywhere, whatever happens to layers and rows
 * @param reweighted  films that have another weight or place in the sum; all if it has more or fewer films
 * @param changesEdges whether the same sum with rounded weights changes
 */
public record FilmUpdate(int[] origin, BitSet changed, BitSet reweighted, boolean changesEdges) {
    // An array in a record: written once by its creator, never after.

    /** Returns the update of a first picture. */
    public static FilmUpdate first(FilmParts parts) {
        int[] origin = new int[parts.count()];
        Arrays.fill(origin, -1);
        BitSet changed = new BitSet();
        changed.set(0, origin.length);
        return new FilmUpdate(origin, changed, changed, true);
    }

    /** Returns the update of films that stay. */
    public static FilmUpdate none(FilmParts parts) {
        return new FilmUpdate(IntStream.range(0, parts.count()).toArray(), new BitSet(), new BitSet(), false);
    }

    /**
     * Compares the films of two pictures of the same rows.
     *
     * @param layers plan of the layers
     */
    public static FilmUpdate between(FilmParts before, FilmParts after, LevelPlan layers) {
        int[] origin = new int[after.count()];
        BitSet changed = new BitSet();
        boolean changesAll = !before.scene().world().fog().equals(after.scene().world().fog())
                || before.scene().world().meters() != after.scene().world().meters();
        BitSet reweighted = new BitSet();
        boolean changesEdges = before.count() != after.count();
        reweighted.set(0, origin.length, changesEdges);
        for (int part = 0; part < origin.length; part++) {
            FilmPart its = after.get(part);
            origin[part] = origin(before, its, layers);
            FilmPart was = origin[part] < 0 ? null : before.get(origin[part]);
            changed.set(part, changesAll || was == null || changes(before, was, after, its, layers));
            boolean isNew = origin[part] != part;
            reweighted.set(part, reweighted.get(part) || was == null || isNew || !was.weight().equals(its.weight()));
            changesEdges |= was == null || isNew || !was.weight().toPowersOfTwo().equals(its.weight().toPowersOfTwo());
        }
        return new FilmUpdate(origin, changed, reweighted, changesEdges);
    }

    /** Returns whether the sum changes although films do not. */
    public boolean reweights() {
        return !reweighted.isEmpty();
    }

    /** Returns whether no film changes everywhere, and each has its number. */
    public boolean isSame() {
        boolean isSame = changed.isEmpty();
        for (int film = 0; film < origin.length; film++) {
            isSame &= origin[film] == film;
        }
        return isSame;
    }

    private static int origin(FilmParts before, FilmPart part, LevelPlan layers) {
        LayerPlan plan = part.kind() == FilmPart.Kind.LIGHT ? layers.layers().get(part.index()) : null;
        int index = plan == null ? part.index() : plan.base() == null ? -1 : plan.base().index();
        for (int i = 0; i < before.count(); i++) {
            if (before.get(i).kind() == part.kind() && before.get(i).index() == index) {
                return i;
            }
        }
        return -1;
    }

    private static boolean changes(FilmParts before, FilmPart was, FilmParts after, FilmPart is, LevelPlan layers) {
        Scene a = before.scene();
        Scene b = after.scene();
        return !was.inside().equals(is.inside()) || switch (is.kind()) {
            case LIGHT -> layers.layers().get(is.index()).changesGains() || changesGains(a.rig().effectiveLights().get(was.index()),
                    b.rig().effectiveLights().get(is.index()));
            case ENVIRONMENT_LIGHT -> !a.rig().environment(was.index()).units().equals(b.rig().environment(is.index()).units())
                    || changesImage(before.environment(was.index()), after.environment(is.index()));
            case ENVIRONMENT_IMAGE -> changesImage(before.environment(was.index()), after.environment(is.index()));
            case AMBIENCE -> false;
            case REST -> !a.world().background().equals(b.world().background())
                    || before.showsEnvironment() != after.showsEnvironment();
        };
    }

    private static boolean changesGains(Light a, Light b) {
        return a.relativeGain(a.influence().diffuse()) != b.relativeGain(b.influence().diffuse())
                || a.relativeGain(a.influence().specular()) != b.relativeGain(b.influence().specular())
                || a.relativeGain(a.influence().fog()) != b.relativeGain(b.influence().fog());
    }

    private static boolean changesImage(@Nullable Dome a, Dome b) {
        return a == null || !Objects.equals(a.map(), b.map()) || !a.rotation().equals(b.rotation());
    }
}
