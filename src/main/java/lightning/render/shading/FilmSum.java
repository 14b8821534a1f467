package lightning.render.shading;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;

/**
 * Adds films to a picture: the sum of weight × film as a balanced tree over all films, as {@link LightingEquation#sum}. Films that are black or
 * have no weight would add +0 to sums that are never negative, so that leaving them out changes no bit. Scratch memory for one thread.
 */
public final class FilmSum {
    private float[][] scratch = {};

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
        for (int c = 0; c < 3; c++) {
            if (!sum(weights, films, 0, weights.length, c, length, to[c], 0)) {
                Arrays.fill(to[c], 0, length, 0);
            }
        }
    }

    /** Writes the sum over films {@code from … end − 1}; returns false if it is 0 and nothing was written. @param depth of the branch in the tree */
    private boolean sum(LightWeight[] weights, Films films, int from, int end, int c, int length, float[] to, int depth) {
        if (end - from == 1) {
            float[][] film = films.get(from);
            if (film == null || weights[from].channel(c) == 0) {
                return false;
            }
            write(weights[from].channel(c), film[c], to, length);
            return true;
        }
        if (end == from) {
            return false;
        }
        int middle = (from + end) >>> 1;
        boolean hasLeft = sum(weights, films, from, middle, c, length, to, depth + 1);
        if (end - middle == 1) {
            float[][] film = films.get(middle);
            float weight = weights[middle].channel(c);
            if (film == null || weight == 0) {
                return hasLeft;
            }
            if (hasLeft) {
                add(weight, film[c], to, length);
            } else {
                write(weight, film[c], to, length);
            }
            return true;
        }
        if (!hasLeft) {
            return sum(weights, films, middle, end, c, length, to, depth + 1);
        }
        float[] right = scratch(depth, length);
        if (sum(weights, films, middle, end, c, length, right, depth + 1)) {
            add(1, right, to, length);
        }
        return true;
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

    private static void write(float weight, float[] film, float[] to, int length) {
        for (int i = 0; i < length; i++) {
            to[i] = weight * film[i];
        }
    }

    private static void add(float weight, float[] film, float[] to, int length) {
        for (int i = 0; i < length; i++) {
            to[i] += weight * film[i];
        }
    }
}
