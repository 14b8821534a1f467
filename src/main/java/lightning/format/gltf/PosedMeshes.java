package lightning.format.gltf;

import java.io.IOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.base.text.RefusalException;
import lightning.format.mesh.MeshException;
import lightning.format.mesh.NamedMesh;
import lightning.format.mesh.UniqueNames;
import lightning.format.mesh.VertexNormals;
import lightning.scene.node.Mesh;
import org.jspecify.annotations.Nullable;

/**
 * Meshes that nodes show in another form than the file has them: bent by the joints of a skin, or mixed with morph targets, as the file's
 * transforms and weights have them (glTF 2.0, §3.7.2.2 and §3.7.3).
 */
public final class PosedMeshes {
    private final GltfFile file;
    private final AccessorReader accessors;
    private final ExpansionLimit limit;
    private final Map<Integer, Transform> worldTransforms = new HashMap<>();
    private final Map<Integer, List<GltfPart>> partsByNode = new HashMap<>();
    private final List<NamedMesh> meshes = new ArrayList<>();
    private final UniqueNames names = new UniqueNames();
    /** Values of accessors already read. */
    private final Map<Integer, float[]> cachedValues = new HashMap<>();
    /** Mesh and index of each primitive whose compressed data has been decoded. */
    private final Set<List<Integer>> decoded = new HashSet<>();
    private long bytes;

    private PosedMeshes(GltfFile file) throws IOException, MeshException {
        this.file = file;
        accessors = new AccessorReader(file);
        limit = new ExpansionLimit(file);
    }

    /**
     * Poses the meshes of all nodes that need it.
     *
     * @param nodes nodes of a scene
     * @param parts parts of each mesh
     * @throws MeshException if a skin or target is invalid, or they take more memory than the file justifies
     */
    public static PosedMeshes of(GltfFile file, List<GltfNode> nodes, Map<Integer, List<GltfPart>> parts)
            throws IOException, MeshException {
        var posed = new PosedMeshes(file);
        nodes.forEach(node -> posed.place(node, Transform.IDENTITY));
        for (GltfNode node : nodes) {
            posed.poseAll(node, parts);
        }
        return posed;
    }

    /** Returns the posed meshes, by unique name. */
    public List<NamedMesh> meshes() {
        return List.copyOf(meshes);
    }

    /** Returns the posed parts that a node shows, named as in {@link #meshes}; empty if it shows its mesh as it is. */
    public List<GltfPart> parts(GltfNode node) {
        return partsByNode.getOrDefault(node.index(), List.of());
    }

    private void place(GltfNode node, Transform parent) {
        Transform world = parent.times(node.local());
        worldTransforms.put(node.index(), world);
        node.children().forEach(child -> place(child, world));
    }

    private void poseAll(GltfNode node, Map<Integer, List<GltfPart>> parts) throws IOException, MeshException {
        if (node.mesh() >= 0 && node.index() >= 0) {
            List<Double> weights = weights(node);
            boolean isMorphed = weights.stream().anyMatch(w -> w != 0);
            List<GltfPart> own = parts.getOrDefault(node.mesh(), List.of());
            if (node.skin() >= 0 || isMorphed && own.stream().anyMatch(part -> part.vertices().length > 0)) {
                List<GltfPart> posed = new ArrayList<>();
                for (GltfPart part : own) {
                    posed.add(pose(node, part, weights));
                }
                partsByNode.put(node.index(), List.copyOf(posed));
            }
        }
        for (GltfNode child : node.children()) {
            poseAll(child, parts);
        }
    }

    private List<Double> weights(GltfNode node) throws MeshException {
        if (!node.weights().isEmpty()) {
            return node.weights();
        }
        List<Double> weights = new ArrayList<>();
        JsonValue array = file.array("meshes").element(node.mesh()).get("weights");
        for (int i = 0; i < array.size(); i++) {
            weights.add(array.element(i).number());
        }
        return weights;
    }

    private GltfPart pose(GltfNode node, GltfPart part, List<Double> weights) throws IOException, MeshException {
        JsonValue primitive = file.array("meshes").element(part.mesh()).get("primitives").element(part.primitive());
        Mesh rest = part.triangles();
        float[] positions = rest.positions().clone();
        float[] normals = rest.normals() == null ? null : rest.normals().clone();
        bytes += 8L * (positions.length + (normals == null ? 0 : normals.length));
        limit.checkBytes(bytes, primitive);
        if (part.vertices().length > 0) {
            if (decoded.add(List.of(part.mesh(), part.primitive()))) {
                new DracoPrimitive(file, accessors).decode(primitive);
            }
            morph(primitive, part, weights, positions, normals);
            if (node.skin() >= 0 && primitive.get("attributes").get("JOINTS_0").isPresent()) {
                bend(file.array("skins").element(node.skin()), primitive.get("attributes"), part, positions, normals);
            }
        }
        if (normals != null) {
            VertexNormals.normalizeAll(normals, positions, rest.triangles());
        }
        try {
            Mesh mesh = new Mesh(positions, rest.triangles(), normals, rest.coordinates(), rest.colors());
            String name = names.unique(node.name().isEmpty() ? part.name() : node.name(), "mesh");
            meshes.add(new NamedMesh(name, mesh));
            return new GltfPart(part.mesh(), part.primitive(), name, part.material(), mesh, new int[0]);
        } catch (RefusalException e) {
            throw primitive.problem(e.getMessage());
        }
    }

    /** Adds the weighted displacements of morph targets. */
    private void morph(JsonValue primitive, GltfPart part, List<Double> weights, float[] positions, float @Nullable [] normals)
            throws IOException, MeshException {
        JsonValue targets = primitive.get("targets");
        for (int t = 0; t < Math.min(targets.size(), weights.size()); t++) {
            if (weights.get(t) != 0) {
                add(targets.element(t).get("POSITION"), weights.get(t), part, positions);
                if (normals != null) {
                    add(targets.element(t).get("NORMAL"), weights.get(t), part, normals);
                }
            }
        }
    }

    private void add(JsonValue displacements, double weight, GltfPart part, float[] values) throws IOException, MeshException {
        if (!displacements.isPresent()) {
            return;
        }
        float[] all = values(displacements, 3, part);
        for (int v = 0; v < part.vertices().length; v++) {
            for (int axis = 0; axis < 3; axis++) {
                values[3 * v + axis] += (float) (weight * all[3 * part.vertices()[v] + axis]);
            }
        }
    }

    /** Moves vertices with the joints of a skin, into the space of the scene: the node's own transform does not act. */
    private void bend(JsonValue skin, JsonValue attributes, GltfPart part, float[] positions, float @Nullable [] normals)
            throws IOException, MeshException {
        Transform[] joints = joints(skin);
        int count = part.vertices().length;
        Transform[] total = new Transform[count];
        double[] sums = new double[count];
        for (int set = 0; attributes.get("JOINTS_" + set).isPresent() && attributes.get("WEIGHTS_" + set).isPresent(); set++) {
            float[] indices = values(attributes.get("JOINTS_" + set), 4, part);
            float[] weights = values(attributes.get("WEIGHTS_" + set), 4, part);
            for (int v = 0; v < count; v++) {
                for (int k = 4 * part.vertices()[v]; k < 4 * part.vertices()[v] + 4; k++) {
                    if (weights[k] > 0) {
                        int joint = (int) indices[k];
                        if (joint < 0 || joint >= joints.length) {
                            throw attributes.get("JOINTS_" + set)
                                    .problem("must be joints from 0 to " + (joints.length - 1) + ", was " + joint);
                        }
                        Transform weighted = joints[joint].times(weights[k]);
                        total[v] = total[v] == null ? weighted : total[v].plus(weighted);
                        sums[v] += weights[k];
                    }
                }
            }
        }
        for (int v = 0; v < count; v++) {
            if (sums[v] > 0) {
                Transform m = total[v].times(1 / sums[v]);
                Vec3 p = m.transformPoint(new Vec3(positions[3 * v], positions[3 * v + 1], positions[3 * v + 2]));
                set(positions, v, p);
                if (normals != null) {
                    set(normals, v, cofactors(m).transformVector(new Vec3(normals[3 * v], normals[3 * v + 1], normals[3 * v + 2])));
                }
            }
        }
    }

    private static void set(float[] values, int vertex, Vec3 v) {
        values[3 * vertex] = (float) v.x();
        values[3 * vertex + 1] = (float) v.y();
        values[3 * vertex + 2] = (float) v.z();
    }

    /** Returns each joint's transform from the mesh's space in the pose of the skin to the scene. */
    private Transform[] joints(JsonValue skin) throws IOException, MeshException {
        JsonValue nodes = skin.get("joints");
        JsonValue inverse = skin.get("inverseBindMatrices");
        float[] matrices = inverse.isPresent() ? accessors.floats(inverse, 16) : null;
        if (matrices != null && matrices.length < 16 * nodes.size()) {
            throw inverse.problem("must have a matrix for each of " + nodes.size() + " joints, has " + matrices.length / 16);
        }
        Transform[] joints = new Transform[nodes.size()];
        for (int j = 0; j < joints.length; j++) {
            Transform world = worldTransforms.getOrDefault(nodes.element(j).index(file.array("nodes")), Transform.IDENTITY);
            joints[j] = matrices == null ? world : world.times(columnMajor(matrices, 16 * j));
        }
        return joints;
    }

    private static Transform columnMajor(float[] m, int at) {
        return new Transform(m[at], m[at + 4], m[at + 8], m[at + 12], m[at + 1], m[at + 5], m[at + 9], m[at + 13], m[at + 2], m[at + 6],
                m[at + 10], m[at + 14]);
    }

    /** Returns the transform of normals: the cofactors of the linear part, parallel to its transposed inverse. */
    private static Transform cofactors(Transform m) {
        return new Transform(m.m11() * m.m22() - m.m12() * m.m21(), m.m12() * m.m20() - m.m10() * m.m22(),
                m.m10() * m.m21() - m.m11() * m.m20(), 0, m.m02() * m.m21() - m.m01() * m.m22(), m.m00() * m.m22() - m.m02() * m.m20(),
                m.m01() * m.m20() - m.m00() * m.m21(), 0, m.m01() * m.m12() - m.m02() * m.m11(), m.m02() * m.m10() - m.m00() * m.m12(),
                m.m00() * m.m11() - m.m01() * m.m10(), 0);
    }

    private float[] values(JsonValue accessor, int components, GltfPart part) throws IOException, MeshException {
        int needed = 0;
        for (int v : part.vertices()) {
            needed = Math.max(needed, v + 1);
        }
        if (accessors.count(accessor) < needed) {
            throw accessor.problem("must have one value per position, at least " + needed + ", has " + accessors.count(accessor));
        }
        int index = accessor.index(file.array("accessors"));
        float[] known = cachedValues.get(index);
        if (known == null) {
            known = accessors.floats(accessor, components);
            bytes += 4L * known.length;
            limit.checkBytes(bytes, accessor);
            cachedValues.put(index, known);
        }
        return known;
    }
}
