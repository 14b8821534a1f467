package lightning.scene.light;

import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.scene.node.Mesh;

/**
 * Triangles of a mesh, in the scene.
 *
 * @param sides   order of the triangles, and the sides to which they shine
 * @param mirrors whether the map to the scene turns left to right
 * @param areas   areas of the triangles in that order
 * @param emittingArea area of all sides that shine
 */
record MeshSurface(Mesh mesh, Transform toScene, MeshSides sides, boolean mirrors, AreaSums areas, double emittingArea)
        implements ObjectSurface.Strip {

    MeshSurface(Mesh mesh, Transform toScene, MeshSides sides) {
        this(mesh, toScene, sides, isMirror(toScene), areas(mesh, toScene, sides), emittingArea(mesh, toScene, sides));
    }

    private static boolean isMirror(Transform t) {
        Vec3 x = new Vec3(t.m00(), t.m10(), t.m20());
        Vec3 y = new Vec3(t.m01(), t.m11(), t.m21());
        Vec3 z = new Vec3(t.m02(), t.m12(), t.m22());
        return x.cross(y).dot(z) < 0;
    }

    private static AreaSums areas(Mesh mesh, Transform toScene, MeshSides sides) {
        double[] sums = new double[mesh.triangleCount()];
        double sum = 0;
        for (int i = 0; i < sums.length; i++) {
            sum += area(mesh, toScene, sides.order()[i]);
            sums[i] = sum;
        }
        return new AreaSums(sums);
    }

    private static double emittingArea(Mesh mesh, Transform toScene, MeshSides sides) {
        double sum = 0;
        for (int t = 0; t < mesh.triangleCount(); t++) {
            sum += area(mesh, toScene, t) * (sides.side()[t] == 0 ? 2 : 1);
        }
        return sum;
    }

    private static double area(Mesh mesh, Transform toScene, int triangle) {
        return 0.5 * scaledNormal(mesh, toScene, triangle).length();
    }

    private static Vec3 scaledNormal(Mesh mesh, Transform toScene, int triangle) {
        Vec3 first = corner(mesh, triangle, 0);
        return toScene.transformVector(corner(mesh, triangle, 1).minus(first))
                .cross(toScene.transformVector(corner(mesh, triangle, 2).minus(first)));
    }

    static Vec3 corner(Mesh mesh, int triangle, int corner) {
        int at = 3 * mesh.triangles()[3 * triangle + corner];
        return new Vec3(mesh.positions()[at], mesh.positions()[at + 1], mesh.positions()[at + 2]);
    }

    @Override
    public double area() {
        return areas.total();
    }

    @Override
    public ObjectSurface.Point point(double across, double along) {
        AreaSums.Place place = areas.at(across);
        int triangle = sides.order()[place.index()];
        // Uniform in a triangle: Turk, Generating random points in triangles, 1990.
        double root = Math.sqrt(place.share());
        double[] weight = {1 - root, root * (1 - along), root * along};
        Vec3 local = Vec3.ZERO;
        double u = 0;
        double v = 0;
        float[] coordinates = mesh.coordinates();
        for (int c = 0; c < 3; c++) {
            local = local.plus(corner(mesh, triangle, c).times(weight[c]));
            int vertex = mesh.triangles()[3 * triangle + c];
            u += coordinates == null ? 0 : weight[c] * coordinates[2 * vertex];
            v += coordinates == null ? 0 : weight[c] * coordinates[2 * vertex + 1];
        }
        Vec3 normal = scaledNormal(mesh, toScene, triangle).normalized();
        boolean turned = mirrors != sides.side()[triangle] < 0;
        return new ObjectSurface.Point(toScene.transformPoint(local), turned ? normal.negated() : normal, u, v,
                sides.side()[triangle] == 0);
    }
}
