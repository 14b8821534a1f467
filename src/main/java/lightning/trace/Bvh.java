package lightning.trace;

import lightning.math.Vec3;

/**
 * A binary tree of boxes over the shapes, one shape in each leaf, as plain arrays.
 *
 * <p>A child is the index of an inner node or, where negative, the complement of a shape. Node {@code n}
 * has the children {@code child[2 n]} and {@code child[2 n + 1]}, their boxes in
 * {@code boxes[12 n …]}, six floats each, and the axis along which the first lies before the second in
 * {@code axis[n]}. The root is node 0; there is no node where there are fewer than two shapes.
 */
final class Bvh {
    final ShapeTable shapes;
    /** The box of each shape, {@code float[6 * count]}. */
    final float[] shapeBoxes;
    final int[] child;
    final float[] boxes;
    final byte[] axis;
    /** Pushed at most this many at a time when one child of every node is put aside. */
    final int depth;

    Bvh(ShapeTable shapes) {
        this.shapes = shapes;
        shapeBoxes = ShapeBoxes.of(shapes);
        BvhBuilder built = new BvhBuilder(shapeBoxes);
        child = built.child;
        boxes = built.boxes;
        axis = built.axis;
        depth = built.depth;
    }

    /** The tree of the same shapes seen from elsewhere: its form with their boxes. */
    Bvh(ShapeTable shapes, Bvh form) {
        this.shapes = shapes;
        shapeBoxes = ShapeBoxes.of(shapes);
        child = form.child;
        axis = form.axis;
        depth = form.depth;
        boxes = new float[form.boxes.length];
        // Children come after their node, so that from the last on all are there.
        for (int c = child.length - 1; c >= 0; c--) {
            if (child[c] < 0) {
                System.arraycopy(shapeBoxes, 6 * ~child[c], boxes, 6 * c, 6);
            } else {
                BvhBuilder.empty(boxes, 6 * c);
                BvhBuilder.grow(boxes, 6 * c, boxes, 12 * child[c]);
                BvhBuilder.grow(boxes, 6 * c, boxes, 12 * child[c] + 6);
            }
        }
    }

    private int root() {
        return shapes.count == 1 ? ~0 : 0;
    }

    /** The shape that a ray meets first, the one with the lowest index among equals, or −1. */
    int nearest(Ray ray) {
        BoxRay box = new BoxRay(ray);
        int[] stack = new int[depth + 1];
        int top = 0;
        int found = -1;
        double best = Solids.MISS;
        int next = root();
        boolean more = shapes.count > 0;
        while (more) {
            if (next < 0) {
                double t = distance(~next, ray);
                if (t < best || t == best && ~next < found) {
                    best = t;
                    found = ~next;
                }
            } else {
                boolean first = box.hits(boxes, 12 * next, best);
                boolean second = box.hits(boxes, 12 * next + 6, best);
                int near = box.forwards(axis[next]) ? 0 : 1;
                if (first && second) {
                    stack[top++] = child[2 * next + 1 - near];
                    next = child[2 * next + near];
                    continue;
                }
                if (first || second) {
                    next = child[2 * next + (first ? 0 : 1)];
                    continue;
                }
            }
            more = top > 0;
            next = more ? stack[--top] : 0;
        }
        return found;
    }

    /** Whether a ray meets any shape at a distance below {@code limit}. */
    boolean blocked(Ray ray, double limit) {
        BoxRay box = new BoxRay(ray);
        int[] stack = new int[depth + 2];
        int top = 0;
        if (shapes.count > 0) {
            stack[top++] = root();
        }
        while (top > 0) {
            int next = stack[--top];
            if (next < 0) {
                if (distance(~next, ray) < limit) {
                    return true;
                }
                continue;
            }
            for (int c = 0; c < 2; c++) {
                if (box.hits(boxes, 12 * next + 6 * c, limit)) {
                    stack[top++] = child[2 * next + c];
                }
            }
        }
        return false;
    }

    private double distance(int shape, Ray ray) {
        Vec3 o = ray.origin();
        Vec3 d = ray.direction();
        return shapes.distance(shape, o.x(), o.y(), o.z(), d.x(), d.y(), d.z());
    }
}
