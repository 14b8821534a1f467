package lightning.render.trace.primitive;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;

/**
 * Hits of shadow rays on primitives, per ray the nearest hit first; among equal distances the lowest primitive, then its lowest
 * part. The hits of a ray are a linked list, in whatever order they are added. Reused.
 * <pre>{@code for (int i = hits.first(ray); i != ShadowRayHits.END; i = hits.next(i)) { double t = hits.t[i]; } }</pre>
 */
public final class ShadowRayHits {
    /** End of a list. */
    public static final int END = -1;

    /** Ray of each hit. */
    public int[] ray = new int[8];
    public int[] primitive = new int[8];
    public int[] part = new int[8];
    public double[] t = new double[8];
    /** Fresnel reflectance from outside, and whether the ray came from inside; written by the tracer on request. */
    public float[] reflectance = new float[8];
    public boolean[] inside = new boolean[8];
    private final int[] first;
    private int[] next = new int[8];
    private int count;
    private int currentRay;

    /** @param rayCount number of rays */
    public ShadowRayHits(int rayCount) {
        first = new int[rayCount];
        clear();
    }

    /** Removes all hits. */
    public void clear() {
        Arrays.fill(first, END);
        count = 0;
    }

    /** Sets the ray whose hits are added next. */
    public void selectRay(int ray) {
        currentRay = ray;
    }

    /** Returns the number of hits of all rays: their indices are 0 … count − 1. */
    public int count() {
        return count;
    }

    /** Returns the nearest hit of a ray. */
    public int first(int ray) {
        return first[ray];
    }

    /** Returns the next hit of a ray. */
    public int next(int i) {
        return next[i];
    }

    /** Adds a hit unless it is at or beyond the limit, or in a hole; {@code cutoutTest} is null if there are no cutouts. */
    public void add(int s, int partIndex, double distance, double limit, @Nullable CutoutTest cutoutTest) {
        if (!(distance < limit) || distance == Double.POSITIVE_INFINITY || cutoutTest != null && cutoutTest.isHole(partIndex, distance)) {
            return;
        }
        if (count == t.length) {
            ray = Arrays.copyOf(ray, 2 * count);
            primitive = Arrays.copyOf(primitive, 2 * count);
            part = Arrays.copyOf(part, 2 * count);
            t = Arrays.copyOf(t, 2 * count);
            reflectance = Arrays.copyOf(reflectance, 2 * count);
            inside = Arrays.copyOf(inside, 2 * count);
            next = Arrays.copyOf(next, 2 * count);
        }
        int previous = END;
        int following = first[currentRay];
        while (following != END && !isAfter(following, s, partIndex, distance)) {
            previous = following;
            following = next[following];
        }
        int at = count++;
        ray[at] = currentRay;
        primitive[at] = s;
        part[at] = partIndex;
        t[at] = distance;
        next[at] = following;
        if (previous == END) {
            first[currentRay] = at;
        } else {
            next[previous] = at;
        }
    }

    private boolean isAfter(int i, int s, int partIndex, double distance) {
        return t[i] != distance ? t[i] > distance : primitive[i] != s ? primitive[i] > s : part[i] > partIndex;
    }
}
