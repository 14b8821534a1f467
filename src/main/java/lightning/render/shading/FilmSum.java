package lightning.render.shading;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * Adds films to a picture: the sum of weight × film as a balanced tree over all films, as {@link LightingEquation#sum}. Films that are black or
 * have no weight would add +0 to sums that are never negative, so that leaving them out changes no bit. Scratch memory for one thread.
 */
public final class FilmSum {
    private static final int FEW = 4;

    private final float[][] few = new float[FEW][];
    private final float[] fewWeights = new float[FEW];
    private float[][] scratch = {};
    private float[] dark = {};
    private long bytesRead;

    /** Colors of a film. */
    @FunctionalInterface
    public interface Films {
        /** Returns red, green and blue of a film; null if it is black. */
        float @Nullable [][] get(int film);
    }

    /**
     * Writes the sum at positions {@code 0 … length − 1}.
     *
     * @param weights weight of each film
     * @param to      receives red, green and blue
     */
    public void add(LightWeight[] weights, Films films, int length, float[][] to) {
        reserve(length);
        for (int c = 0; c < 3; c++) {
            if (!add(weights, films, 0, weights.length, c, length, dark, to[c], 0)) {
                Arrays.fill(to[c], 0, length, 0);
            }
        }
    }

    /** Returns the bytes of films and of sums beside a film that were read so far. */
    public long bytesRead() {
        return bytesRead;
    }

    private void reserve(int length) {
        if (dark.length < length) {
            dark = new float[length];
        }
    }

    /** Returns the sums beside a film; parameters as above. */
    private FilmBranches branches(int film, LightWeight[] weights, Films films, int length) {
        reserve(length);
        List<float[][]> sums = new ArrayList<>();
        int from = 0;
        int end = weights.length;
        while (end - from > FEW) {
            int middle = (from + end) >>> 1;
            boolean isLeft = film < middle;
            float[][] sum = new float[3][];
            for (int c = 0; c < 3; c++) {
                float[] to = new float[length];
                boolean shows = add(weights, films, isLeft ? middle : from, isLeft ? end : middle, c, length, dark, to, 0);
                sum[c] = shows ? to : null;
            }
            sums.add(sum);
            from = isLeft ? from : middle;
            end = isLeft ? middle : end;
        }
        return new FilmBranches(film, from, end, weights, sums.toArray(float[][][]::new));
    }

    /** Writes the same sum of stored films; returns these with the sums beside a film. */
    public StoredFilms add(LightWeight[] weights, StoredFilms films, int film, float[][] to) {
        int length = to[0].length;
        FilmBranches known = films.branches();
        FilmBranches branches = known != null && known.fits(film, weights) ? known : branches(film, weights, films::get, length);
        add(branches, weights, films::get, length, to);
        return branches == known ? films : new StoredFilms(films.colors(), films.known(), branches);
    }

    private void add(FilmBranches branches, LightWeight[] weights, Films films, int length, float[][] to) {
        reserve(length);
        for (int c = 0; c < 3; c++) {
            if (!addFew(weights, films, branches.from(), branches.end(), c, length, dark, to[c])) {
                Arrays.fill(to[c], 0, length, 0);
            }
            for (int k = branches.sums().length - 1; k >= 0; k--) {
                if (branches.sums()[k][c] != null) {
                    add(to[c], 1, branches.sums()[k][c], to[c], length);
                    bytesRead += (long) Float.BYTES * length;
                }
            }
        }
    }

    /**
     * Adds the sum over films {@code from … end − 1} to others; returns false if it is 0 and nothing was written.
     *
     * @param before what it is added to, maybe {@code to} itself
     * @param depth  of the branch in the tree
     */
    private boolean add(LightWeight[] weights, Films films, int from, int end, int c, int length, float[] before, float[] to, int depth) {
        if (end - from <= FEW) {
            return addFew(weights, films, from, end, c, length, before, to);
        }
        if (before != dark) {
            float[] sum = scratch(depth, length);
            boolean shows = add(weights, films, from, end, c, length, dark, sum, depth + 1);
            if (shows) {
                add(before, 1, sum, to, length);
            }
            return shows;
        }
        int middle = (from + end) >>> 1;
        boolean hasLeft = add(weights, films, from, middle, c, length, dark, to, depth);
        return add(weights, films, middle, end, c, length, hasLeft ? to : dark, to, depth) || hasLeft;
    }

    /** Adds a small branch in one pass, because memory is fastest when several films are read side by side. */
    private boolean addFew(LightWeight[] weights, Films films, int from, int end, int c, int length, float[] before, float[] to) {
        Arrays.fill(few, dark);
        Arrays.fill(fewWeights, 0);
        boolean shows = false;
        for (int film = from; film < end; film++) {
            float[][] colors = weights[film].channel(c) == 0 ? null : films.get(film);
            if (colors != null) {
                // Three films are one, and two others.
                int place = end - from == 3 && film > from ? film - from + 1 : film - from;
                few[place] = colors[c];
                fewWeights[place] = weights[film].channel(c);
                bytesRead += (long) Float.BYTES * length;
                shows = true;
            }
        }
        if (shows) {
            add(before, fewWeights, few, to, length);
        }
        return shows;
    }

    private float[] scratch(int depth, int length) {
        if (depth >= scratch.length) {
            scratch = Arrays.copyOf(scratch, depth + 1);
        }
        if (scratch[depth] == null || scratch[depth].length < length) {
            scratch[depth] = new float[length];
        }
        return scratch[depth];
    }

    private static void add(float[] before, float a, float[] filmA, float[] to, int length) {
        for (int i = 0; i < length; i++) {
            to[i] = before[i] + a * filmA[i];
        }
    }

    private static void add(float[] before, float[] weights, float[][] films, float[] to, int length) {
        float a = weights[0];
        float b = weights[1];
        float c = weights[2];
        float d = weights[3];
        float[] filmA = films[0];
        float[] filmB = films[1];
        float[] filmC = films[2];
        float[] filmD = films[3];
        for (int i = 0; i < length; i++) {
            to[i] = before[i] + ((a * filmA[i] + b * filmB[i]) + (c * filmC[i] + d * filmD[i]));
        }
    }
}
