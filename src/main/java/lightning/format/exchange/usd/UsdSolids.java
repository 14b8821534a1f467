package lightning.format.exchange.usd;

import java.util.List;
import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.format.gltf.JsonValue;
import lightning.format.mesh.MeshException;
import lightning.scene.node.Solid;

/** Solids of a stage: spheres, cylinders, cones, capsules and planes. */
final class UsdSolids {
    private static final Solid.Canonical OPEN_CYLINDER = new Solid.Cylinder(false);

    private UsdSolids() {}

    /** Solid with its place in the space of its prim. */
    record Part(Solid.Canonical solid, Transform transform) {}

    /** Returns the number of solids that a prim becomes; 0 if absent. */
    static int count(JsonValue in) throws MeshException {
        return of(in).size();
    }

    /** Returns the solids that a prim becomes; empty if absent. */
    static List<Part> of(JsonValue in) throws MeshException {
        if (!in.isPresent()) {
            return List.of();
        }
        double radius = in.get("radius").number(1);
        double height = in.get("height").number(2);
        Transform axis = axis(in.get("axis").text().orElse("Z"));
        return switch (in.get("type").text().orElse("")) {
            case "Sphere" -> List.of(new Part(Solid.SPHERE, scale(radius, radius, radius)));
            case "Cylinder" -> List.of(frustum(in, axis, radius, height));
            case "Cone" -> List.of(new Part(Solid.CONE, axis.times(lifted(-height / 2, radius, height))));
            case "Capsule" -> List.of(new Part(OPEN_CYLINDER, axis.times(lifted(-height / 2, radius, height))),
                    new Part(Solid.SPHERE, axis.times(lifted(height / 2, radius, radius))),
                    new Part(Solid.SPHERE, axis.times(lifted(-height / 2, radius, radius))));
            // A plane here has its normal along y, its width along x and its length along z.
            case "Plane" -> List.of(new Part(Solid.PLANE, axis.times(scale(in.get("width").number(2), 1, in.get("length").number(2)))));
            default -> List.of();
        };
    }

    private static Part frustum(JsonValue in, Transform axis, double radius, double height) throws MeshException {
        double bottom = in.get("radiusBottom").number(radius);
        double top = in.get("radiusTop").number(radius);
        double base = Math.max(bottom, top);
        Transform turned = bottom >= top ? axis : axis.times(scale(1, -1, 1));
        Solid.Canonical solid = bottom == top ? Solid.CYLINDER : new Solid.Frustum(Math.min(bottom, top) / base, true);
        return new Part(solid, turned.times(lifted(-height / 2, base, height)));
    }

    private static Transform lifted(double y, double radius, double height) {
        return Transform.translation(new Vec3(0, y, 0)).times(scale(radius, height, radius));
    }

    private static Transform scale(double x, double y, double z) {
        return Transform.scaling(new Vec3(x, y, z));
    }

    /** Returns the rotation of the y axis to another. */
    private static Transform axis(String axis) {
        return switch (axis) {
            case "X" -> Transform.rotation(new Vec3(0, 0, -90));
            case "Y" -> Transform.IDENTITY;
            default -> Transform.rotation(new Vec3(90, 0, 0));
        };
    }
}
