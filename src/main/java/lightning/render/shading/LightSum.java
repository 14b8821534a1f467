package lightning.render.shading;

import java.util.ArrayList;
import java.util.List;

/**
 * Sums the lights' contributions over the rows of a tile, as the tree of {@link LightingEquation#sum}.
 * Holds scratch columns: one for each thread.
 *
 * <p>A light that lights no row of the tile, or has no weight, adds +0 to sums that are never negative,
 * so that leaving it out changes no bit. A result is valid until the next call.
 *
 * <p>Where each half of the tree is a chain of lights, as it is with up to six, all of them are added at once. Else the sum over
 * the left half is computed before, and is one that is known.
 */
final class LightSum {
    private final Sums kernel;
    private final Addends diffuse = new Addends();
    private final Addends specular = new Addends();
    private final Addends grazing = new Addends();
    /** The lights of two chains, one behind the other. */
    private final int[] chain = new int[Addends.MOST_LIGHTS];
    /** Sums of branches; those before {@link #used} are in use. */
    private final List<SumRows> scratch = new ArrayList<>();
    private int used;
    private int rows;
    private Luminaire[] lights;
    private LightLayer[] layers;

    LightSum(Sums kernel) {
        this.kernel = kernel;
    }

    /** The sum over all lights. */
    SumRows of(int count, Luminaire[] all, LightLayer[] theirs) {
        begin(count, all, theirs);
        gather(0, all.length);
        return sum();
    }

    /** The same sum where the branches beside one light's way to the root are known. */
    SumRows of(int count, Luminaire[] all, LightLayer[] theirs, BranchSums branches) {
        begin(count, all, theirs);
        int light = branches.key().light();
        if (light != BranchSums.Key.NO_LIGHT) {
            gather(light, light + 1);
        }
        for (SumRows branch : branches.fromLeaf()) {
            add(branch);
        }
        return sum();
    }

    /** Computes the sums of all branches beside a light's way to the root. */
    BranchSums branches(int count, Luminaire[] all, LightLayer[] theirs, BranchSums.Key key) {
        begin(count, all, theirs);
        if (key.light() == BranchSums.Key.NO_LIGHT) {
            return new BranchSums(key, new SumRows[] {compact(sum(0, all.length))});
        }
        List<SumRows> fromRoot = new ArrayList<>();
        int from = 0;
        int to = all.length;
        while (to - from > 1) {
            int middle = (from + to) >>> 1;
            boolean left = key.light() < middle;
            fromRoot.add(compact(sum(left ? middle : from, left ? to : middle)));
            used = 0;
            from = left ? from : middle;
            to = left ? middle : to;
        }
        return new BranchSums(key, fromRoot.reversed().toArray(SumRows[]::new));
    }

    private SumRows compact(SumRows sum) {
        return sum == null ? null : sum.compact(rows);
    }

    private void begin(int count, Luminaire[] all, LightLayer[] theirs) {
        rows = count;
        lights = all;
        layers = theirs;
        used = 0;
        diffuse.clear();
        specular.clear();
        grazing.clear();
    }

    private boolean isActive(int light) {
        return !lights[light].isDark() && layers[light].lit() > 0;
    }

    /** Tells of lights {@code from … to − 1}. */
    private void gather(int from, int to) {
        int middle = (from + to) >>> 1;
        int left = chain(from, middle, 0);
        int right = left < 0 ? -1 : chain(middle, to, left);
        if (right >= 0) {
            lights(0, left);
            diffuse.second();
            specular.second();
            grazing.second();
            lights(left, left + right);
        } else if (to - from == 1) {
            WeightedLayer layer = (WeightedLayer) layers[from];
            diffuse.sum(layer.diffuse);
            if (layer.specular != null) {
                specular.sum(layer.specular);
            }
            if (layer.grazing != null) {
                grazing.sum(layer.grazing);
            }
        } else {
            SumRows known = sum(from, middle);
            gather(middle, to);
            add(known);
        }
    }

    /**
     * Lists those of lights {@code from … to − 1} that add anything, from place {@code at} on, so that the tree's sum is each
     * added to those before; how many, or −1 where there is no such order, no place, or one whose contribution is kept.
     */
    private int chain(int from, int to, int at) {
        if (to - from < 2) {
            if (from == to || !isActive(from)) {
                return 0;
            }
            if (at == Addends.MOST_LIGHTS || !(layers[from] instanceof LightRows)) {
                return -1;
            }
            chain[at] = from;
            return 1;
        }
        int middle = (from + to) >>> 1;
        int left = chain(from, middle, at);
        int right = left < 0 ? -1 : chain(middle, to, at + left);
        if (right < 0 || left > 1 && right > 1) {
            return -1;
        }
        if (left == 1 && right > 1) {
            int single = chain[at];
            System.arraycopy(chain, at + 1, chain, at, right);
            chain[at + right] = single;
        }
        return left + right;
    }

    private void lights(int from, int to) {
        for (int i = from; i < to; i++) {
            Luminaire light = lights[chain[i]];
            LightRows layer = (LightRows) layers[chain[i]];
            diffuse.light(light, layer.cosine, layer.falloff, layer.tint);
            if (layer.specular != null) {
                specular.light(light, layer.specular, layer.falloff, layer.tint);
            }
            if (layer.grazing != null) {
                grazing.light(light, layer.grazing, layer.falloff, layer.tint);
            }
        }
    }

    private void add(SumRows known) {
        if (known == null) {
            return;
        }
        diffuse.sum(known.diffuse);
        if (known.hasSpecular) {
            specular.sum(known.specular);
        }
        if (known.hasGrazing) {
            grazing.sum(known.grazing);
        }
    }

    /** The sum over lights {@code from … to − 1} in scratch columns that are in use then, or null where none adds anything. */
    private SumRows sum(int from, int to) {
        int free = used;
        gather(from, to);
        if (diffuse.isEmpty()) {
            return null;
        }
        // What it is made of stands in columns that are free afterwards.
        SumRows sum = sum();
        scratch.set(used, scratch.set(free, sum));
        used = free + 1;
        diffuse.clear();
        specular.clear();
        grazing.clear();
        return sum;
    }

    /** The sum of what was told of, in the scratch columns that are free next. */
    private SumRows sum() {
        if (used == scratch.size()) {
            scratch.add(SumRows.scratch());
        }
        SumRows sum = scratch.get(used);
        kernel.sum(rows, diffuse, sum.diffuse);
        sum.hasSpecular = !specular.isEmpty();
        if (sum.hasSpecular) {
            kernel.sum(rows, specular, sum.specular);
        }
        sum.hasGrazing = !grazing.isEmpty();
        if (sum.hasGrazing) {
            kernel.sum(rows, grazing, sum.grazing());
        }
        return sum;
    }
}
