package lightning.scene;

import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import lightning.base.math.Transform;
import lightning.base.math.Vec3;

/** A box that holds some shapes and groups with all that is in them, those included that are not visible; no tighter than is quick to find. */
public final class NodeBox {
    /** How many corners a box has. */
    public static final int CORNERS = 8;

    private final Map<Mesh, double[]> meshes = new IdentityHashMap<>();
    /** Least x, y, z and greatest x, y, z; the least above the greatest where there is nothing. */
    private final double[] box = nothing();

    private NodeBox() {}

    /** In the space that the nodes are placed in. */
    public static NodeBox of(List<Node> nodes) {
        var all = new NodeBox();
        all.measure(nodes, Transform.IDENTITY);
        all.meshes.clear();
        return all;
    }

    private static double[] nothing() {
        double inf = Double.POSITIVE_INFINITY;
        return new double[] {inf, inf, inf, -inf, -inf, -inf};
    }

    /** Whether it holds nothing. */
    public boolean isEmpty() {
        return box[0] > box[3];
    }

    /** The corner that has the greatest coordinate along each axis whose bit is set, x the lowest. */
    public Vec3 corner(int bits) {
        return corner(box, bits);
    }

    private static Vec3 corner(double[] of, int bits) {
        return new Vec3(of[3 * (bits & 1)], of[1 + 3 * (bits >> 1 & 1)], of[2 + 3 * (bits >> 2 & 1)]);
    }

    private void measure(List<Node> nodes, Transform outer) {
        for (Node node : nodes) {
            Transform placed = outer.times(node.placement().transform());
            switch (node) {
                case Group g -> measure(g.children(), placed);
                case Shape s -> {
                    double[] own = own(s.solid());
                    for (int corner = 0; corner < CORNERS; corner++) {
                        Vec3 at = placed.point(corner(own, corner));
                        widen(box, at.x(), at.y(), at.z());
                    }
                }
            }
        }
    }

    private static void widen(double[] of, double x, double y, double z) {
        double[] at = {x, y, z};
        for (int i = 0; i < 3; i++) {
            of[i] = Math.min(of[i], at[i]);
            of[3 + i] = Math.max(of[3 + i], at[i]);
        }
    }

    private double[] own(Solid solid) {
        return switch (solid) {
            case Solid.Canonical c -> c.box();
            case Solid.Triangles t -> meshes.computeIfAbsent(t.mesh(), NodeBox::of);
        };
    }

    private static double[] of(Mesh mesh) {
        double[] box = nothing();
        float[] at = mesh.positions();
        for (int i = 0; i < at.length; i += 3) {
            widen(box, at[i], at[i + 1], at[i + 2]);
        }
        return box[0] <= box[3] ? box : new double[6];
    }
}
