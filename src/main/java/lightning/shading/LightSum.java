package lightning.shading;

/**
 * Sums the lights' contributions over the rows of a tile, as the tree of {@link LightingEquation#sum}.
 * Holds scratch columns: one for each thread.
 *
 * <p>A light that lights no row of the tile, or has no weight, adds +0 to sums that are never negative,
 * so that leaving it out changes no bit. A result is valid until the next call.
 */
final class LightSum {
    /** Enough for the depth of a tree over the most lights that a scene may have. */
    private static final int LEVELS = 12;

    private final SumRows[] sums = new SumRows[LEVELS];

    LightSum() {
        java.util.Arrays.setAll(sums, _ -> new SumRows(LightLanes.ROWS));
    }

    /** The sum over all lights, or null where none adds anything. */
    SumRows of(int rows, Lamp[] lamps, LightLayer[] layers) {
        return of(rows, lamps, layers, 0, lamps.length, 0);
    }

    private static boolean isActive(Lamp lamp, LightLayer layer) {
        return !lamp.isDark() && layer.lit() > 0;
    }

    /** The sum of lights {@code from … to} in the scratch columns of a level of the tree, or null. */
    private SumRows of(int rows, Lamp[] lamps, LightLayer[] layers, int from, int to, int level) {
        if (to - from < 2) {
            if (from == to || !isActive(lamps[from], layers[from])) {
                return null;
            }
            sums[level].set(rows, lamps[from], layers[from]);
            return sums[level];
        }
        int middle = (from + to) >>> 1;
        SumRows left = of(rows, lamps, layers, from, middle, level);
        if (left == null) {
            return of(rows, lamps, layers, middle, to, level);
        }
        if (to - middle == 1) {
            if (isActive(lamps[middle], layers[middle])) {
                left.add(rows, lamps[middle], layers[middle]);
            }
            return left;
        }
        SumRows right = of(rows, lamps, layers, middle, to, level + 1);
        if (right != null) {
            left.add(rows, right);
        }
        return left;
    }

    /** The same sum where the branches beside one light's way to the root are known. */
    SumRows of(int rows, Lamp[] lamps, LightLayer[] layers, BranchSums branches) {
        SumRows sum = sums[0];
        int light = branches.key().light();
        boolean any = isActive(lamps[light], layers[light]);
        if (any) {
            sum.set(rows, lamps[light], layers[light]);
        }
        for (SumRows branch : branches.fromLeaf()) {
            if (branch != null) {
                if (any) {
                    sum.add(rows, branch);
                } else {
                    sum.copy(rows, branch);
                }
                any = true;
            }
        }
        return any ? sum : null;
    }

    /** Computes the sums of all branches beside a light's way to the root. */
    BranchSums branches(int rows, Lamp[] lamps, LightLayer[] layers, BranchSums.Key key) {
        SumRows[] fromLeaf = new SumRows[LEVELS];
        int at = LEVELS;
        int from = 0;
        int to = lamps.length;
        while (to - from > 1) {
            int middle = (from + to) >>> 1;
            boolean left = key.light() < middle;
            SumRows beside = of(rows, lamps, layers, left ? middle : from, left ? to : middle, 0);
            fromLeaf[--at] = beside == null ? null : beside.compact(rows);
            from = left ? from : middle;
            to = left ? middle : to;
        }
        return new BranchSums(key, java.util.Arrays.copyOfRange(fromLeaf, at, LEVELS));
    }
}
