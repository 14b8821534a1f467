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
    private static final int DEPTH = 12;

    private final SumRows[] sums = new SumRows[DEPTH];

    LightSum(Sums kernel) {
        java.util.Arrays.setAll(sums, _ -> new SumRows(kernel, Terms.ROWS));
    }

    /** The sum over all lights, or null where none adds anything. */
    SumRows of(int rows, Luminaire[] lights, LightLayer[] layers) {
        return of(rows, lights, layers, 0, lights.length, 0);
    }

    private static boolean isActive(Luminaire light, LightLayer layer) {
        return !light.isDark() && layer.lit() > 0;
    }

    /** The sum of lights {@code from … to} in the scratch columns of a depth of the tree, or null. */
    private SumRows of(int rows, Luminaire[] lights, LightLayer[] layers, int from, int to, int depth) {
        if (to - from < 2) {
            if (from == to || !isActive(lights[from], layers[from])) {
                return null;
            }
            sums[depth].set(rows, lights[from], layers[from]);
            return sums[depth];
        }
        int middle = (from + to) >>> 1;
        SumRows left = of(rows, lights, layers, from, middle, depth);
        if (left == null) {
            return of(rows, lights, layers, middle, to, depth);
        }
        if (to - middle == 1) {
            if (isActive(lights[middle], layers[middle])) {
                left.add(rows, lights[middle], layers[middle]);
            }
            return left;
        }
        SumRows right = of(rows, lights, layers, middle, to, depth + 1);
        if (right != null) {
            left.add(rows, right);
        }
        return left;
    }

    /** The same sum where the branches beside one light's way to the root are known. */
    SumRows of(int rows, Luminaire[] lights, LightLayer[] layers, BranchSums branches) {
        SumRows sum = sums[0];
        int light = branches.key().light();
        boolean any = isActive(lights[light], layers[light]);
        if (any) {
            sum.set(rows, lights[light], layers[light]);
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
    BranchSums branches(int rows, Luminaire[] lights, LightLayer[] layers, BranchSums.Key key) {
        SumRows[] fromLeaf = new SumRows[DEPTH];
        int at = DEPTH;
        int from = 0;
        int to = lights.length;
        while (to - from > 1) {
            int middle = (from + to) >>> 1;
            boolean left = key.light() < middle;
            SumRows beside = of(rows, lights, layers, left ? middle : from, left ? to : middle, 0);
            fromLeaf[--at] = beside == null ? null : beside.compact(rows);
            from = left ? from : middle;
            to = left ? middle : to;
        }
        return new BranchSums(key, java.util.Arrays.copyOfRange(fromLeaf, at, DEPTH));
    }
}
