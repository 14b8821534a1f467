package lightning.render.trace.mesh;

import java.util.Arrays;
import lightning.scene.node.Mesh;

/**
 * Boxes of a mesh's pairs of triangles, in an order that the builder permutes. A box stores its minimum x y z and its negated maximum,
 * so that the smaller value is the larger box in all six.
 */
final class TriangleBoxes {
    /** Six floats per pair. */
    final float[] boxes;
    /** Indices of the pairs. */
    final int[] ids;

    TriangleBoxes(int count) {
        boxes = new float[6 * count];
        ids = new int[count];
    }

    /** Sets a range of a mesh's pairs, each at its own index. */
    void setPairs(Mesh mesh, TrianglePairs pairs, int from, int to) {
        float[] p = mesh.positions();
        for (int i = from; i < to; i++) {
            ids[i] = i;
            int u = 3 * pairs.vertex(i, 0);
            int v = 3 * pairs.vertex(i, 1);
            int w = 3 * pairs.vertex(i, 2);
            int last = pairs.vertex(i, 3);
            int x = last < 0 ? u : 3 * last;
            for (int a = 0; a < 3; a++) {
                boxes[6 * i + a] = Math.min(Math.min(p[u + a], p[v + a]), Math.min(p[w + a], p[x + a]));
                boxes[6 * i + 3 + a] = -Math.max(Math.max(p[u + a], p[v + a]), Math.max(p[w + a], p[x + a]));
            }
        }
    }

    /** Returns twice the center of triangle {@code i}'s box. */
    float doubledCenter(int i, int a) {
        return boxes[6 * i + a] - boxes[6 * i + 3 + a];
    }

    /** Swaps two triangles. */
    void swap(int i, int j) {
        int id = ids[i];
        ids[i] = ids[j];
        ids[j] = id;
        for (int k = 0; k < 6; k++) {
            float b = boxes[6 * i + k];
            boxes[6 * i + k] = boxes[6 * j + k];
            boxes[6 * j + k] = b;
        }
    }

    /** Writes the bounds of the triangles {@code from … to − 1} to {@code box}. */
    void enclose(int from, int to, float[] box) {
        float x = Float.POSITIVE_INFINITY;
        float y = x;
        float z = x;
        float u = x;
        float v = x;
        float w = x;
        for (int i = 6 * from; i < 6 * to; i += 6) {
            x = boxes[i] < x ? boxes[i] : x;
            y = boxes[i + 1] < y ? boxes[i + 1] : y;
            z = boxes[i + 2] < z ? boxes[i + 2] : z;
            u = boxes[i + 3] < u ? boxes[i + 3] : u;
            v = boxes[i + 4] < v ? boxes[i + 4] : v;
            w = boxes[i + 5] < w ? boxes[i + 5] : w;
        }
        box[0] = x;
        box[1] = y;
        box[2] = z;
        box[3] = u;
        box[4] = v;
        box[5] = w;
    }

    /** Returns an empty box. */
    static float[] emptyBox() {
        float[] box = new float[6];
        Arrays.fill(box, Float.POSITIVE_INFINITY);
        return box;
    }

    /** Extends the box at {@code box[at]} by the one at {@code other[i]}. */
    static void grow(float[] box, int at, float[] other, int i) {
        for (int k = 0; k < 6; k++) {
            box[at + k] = other[i + k] < box[at + k] ? other[i + k] : box[at + k];
        }
    }

    /** Returns half the surface area of a box; 0 if it is empty. */
    static double area(float[] box) {
        double x = -(double) box[3] - box[0];
        double y = -(double) box[4] - box[1];
        double z = -(double) box[5] - box[2];
        return x >= 0 ? x * y + y * z + z * x : 0;
    }
}
