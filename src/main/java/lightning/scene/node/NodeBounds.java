package lightning.scene.node;

import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import lightning.base.math.Transform;
import lightning.base.math.Vec3;

/** Bounding box of shapes and groups, including hidden ones; conservative, because it is found quickly. */
public final class NodeBounds {
    /** Number of corners of a box. */
    public static final int CORNERS = 8;

    private final Map<Mesh, double[]> meshes = new IdentityHashMap<>();
    /** Minimum x, y, z and maximum x, y, z; inverted if empty. */
    private final double[] bounds = emptyBox();

    private NodeBounds() {}

    /** Computes the bounds in the space in which the nodes are placed. */
    public static NodeBounds of(List<SceneNode> nodes) {
        var bounds = new NodeBounds();
        bounds.includeNodes(nodes, Transform.IDENTITY);
        bounds.meshes.clear();
        return bounds;
    }

    private static double[] emptyBox() {
        double inf = Double.POSITIVE_INFINITY;
        return new double[] {inf, inf, inf, -inf, -inf, -inf};
    }

    /** Returns whether it is empty. */
    public boolean isEmpty() {
        return bounds[0] > bounds[3];
    }

    /** Returns a corner, with the maximum coordinate along each axis whose bit is set; x is the lowest bit. */
    public Vec3 corner(int bits) {
        return corner(bounds, bits);
    }

    private static Vec3 corner(double[] box, int bits) {
        return new Vec3(box[3 * (bits & 1)], box[1 + 3 * (bits >> 1 & 1)], box[2 + 3 * (bits >> 2 & 1)]);
    }

    private void includeNodes(List<SceneNode> nodes, Transform outer) {
        for (SceneNode node : nodes) {
            Transform toWorld = outer.times(node.placement().transform());
            switch (node) {
                case NodeGroup g -> includeNodes(g.children(), toWorld);
                case Shape s -> {
                    double[] localBounds = localBounds(s.solid());
                    for (int corner = 0; corner < CORNERS; corner++) {
                        Vec3 at = toWorld.transformPoint(corner(localBounds, corner));
                        include(bounds, at.x(), at.y(), at.z());
                    }
                }
            }
        }
    }

    private static void include(double[] box, double x, double y, double z) {
        double[] point = {x, y, z};
        for (int i = 0; i < 3; i++) {
            box[i] = Math.min(box[i], point[i]);
            box[3 + i] = Math.max(box[3 + i], point[i]);
        }
    }

    private double[] localBounds(Solid solid) {
        return switch (solid) {
            case Solid.Canonical c -> c.bounds();
            case Solid.TriangleMesh t -> meshes.computeIfAbsent(t.mesh(), NodeBounds::of);
        };
    }

    private static double[] of(Mesh mesh) {
        double[] box = emptyBox();
        float[] at = mesh.positions();
        for (int i = 0; i < at.length; i += 3) {
            include(box, at[i], at[i + 1], at[i + 2]);
        }
        return box[0] <= box[3] ? box : new double[6];
    }
}
