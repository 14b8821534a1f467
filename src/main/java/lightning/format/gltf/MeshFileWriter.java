package lightning.format.gltf;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.List;
import lightning.base.text.RefusalException;
import lightning.format.mesh.NamedMesh;
import lightning.scene.node.Mesh;
import org.jspecify.annotations.Nullable;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/** Writer of meshes without a scene, as a binary glTF file: the scene refers to its parts by name. */
public final class MeshFileWriter {
    private static final JsonMapper JSON = JsonMapper.builder().build();
    private static final int MAGIC = 0x46546C67;
    private static final int JSON_CHUNK = 0x4E4F534A;
    private static final int BINARY_CHUNK = 0x004E4942;
    private static final int FLOAT = 5126;
    private static final int UNSIGNED_INT = 5125;
    private static final int HEADER_BYTES = 12;
    private static final int CHUNK_BYTES = 8;

    private final ObjectNode root = JSON.createObjectNode();
    private final ArrayNode views = root.putArray("bufferViews");
    private final ArrayNode accessors = root.putArray("accessors");
    private final ByteBuffer data;

    private MeshFileWriter(int bytes) {
        data = ByteBuffer.allocate(bytes).order(ByteOrder.LITTLE_ENDIAN);
    }

    /**
     * Returns the file.
     *
     * @throws RefusalException if it would have more than 2 GiB
     */
    public static byte[] write(List<NamedMesh> meshes) {
        long bytes = 0;
        for (NamedMesh named : meshes) {
            Mesh mesh = named.mesh();
            bytes += 4L * (mesh.positions().length + mesh.triangles().length + length(mesh.normals()) + length(mesh.coordinates())
                    + length(mesh.colors()));
        }
        if (bytes > Integer.MAX_VALUE / 2) {
            throw new RefusalException("its meshes take " + (bytes >> 20) + " MiB, more than 1024");
        }
        return new MeshFileWriter((int) bytes).file(meshes);
    }

    private static int length(float @Nullable [] values) {
        return values == null ? 0 : values.length;
    }

    private byte[] file(List<NamedMesh> meshes) {
        root.putObject("asset").put("version", "2.0").put("generator", "Lightning");
        ArrayNode list = root.putArray("meshes");
        for (NamedMesh named : meshes) {
            Mesh mesh = named.mesh();
            ObjectNode primitive = list.addObject().put("name", named.name()).putArray("primitives").addObject();
            ObjectNode attributes = primitive.putObject("attributes");
            attributes.put("POSITION", add(mesh.positions(), "VEC3", 3));
            bounds(mesh.positions());
            if (mesh.normals() != null) {
                attributes.put("NORMAL", add(mesh.normals(), "VEC3", 3));
            }
            if (mesh.coordinates() != null) {
                attributes.put("TEXCOORD_0", add(downward(mesh.coordinates()), "VEC2", 2));
            }
            if (mesh.colors() != null) {
                attributes.put("COLOR_0", add(mesh.colors(), "VEC3", 3));
            }
            primitive.put("indices", add(mesh.triangles()));
        }
        root.putArray("buffers").addObject().put("byteLength", data.position());
        byte[] json = JSON.writeValueAsBytes(root);
        int padded = (json.length + 3) / 4 * 4;
        ByteBuffer out = ByteBuffer.allocate(HEADER_BYTES + 2 * CHUNK_BYTES + padded + data.position()).order(ByteOrder.LITTLE_ENDIAN);
        out.putInt(MAGIC).putInt(2).putInt(out.capacity()).putInt(padded).putInt(JSON_CHUNK).put(json);
        out.put(" ".repeat(padded - json.length).getBytes(StandardCharsets.US_ASCII));
        out.putInt(data.position()).putInt(BINARY_CHUNK).put(data.flip());
        return out.array();
    }

    /** Returns coordinates with v downwards, as glTF has it. */
    private static float[] downward(float[] coordinates) {
        float[] result = coordinates.clone();
        for (int i = 1; i < result.length; i += 2) {
            result[i] = (float) (1.0 - result[i]);
        }
        return result;
    }

    private int add(float[] values, String type, int components) {
        view(4 * values.length);
        data.asFloatBuffer().put(values);
        data.position(data.position() + 4 * values.length);
        return accessor(FLOAT, values.length / components, type);
    }

    private int add(int[] values) {
        view(4 * values.length);
        data.asIntBuffer().put(values);
        data.position(data.position() + 4 * values.length);
        return accessor(UNSIGNED_INT, values.length, "SCALAR");
    }

    private void view(int bytes) {
        views.addObject().put("buffer", 0).put("byteOffset", data.position()).put("byteLength", bytes);
    }

    private int accessor(int componentType, int count, String type) {
        accessors.addObject().put("bufferView", views.size() - 1).put("componentType", componentType).put("count", count).put("type", type);
        return accessors.size() - 1;
    }

    /** Adds the bounds that glTF requires of positions to the newest accessor. */
    private void bounds(float[] positions) {
        ObjectNode accessor = (ObjectNode) accessors.get(accessors.size() - 1);
        ArrayNode min = accessor.putArray("min");
        ArrayNode max = accessor.putArray("max");
        for (int axis = 0; axis < 3; axis++) {
            float low = positions[axis];
            float high = positions[axis];
            for (int i = axis; i < positions.length; i += 3) {
                low = Math.min(low, positions[i]);
                high = Math.max(high, positions[i]);
            }
            min.add(low);
            max.add(high);
        }
    }
}
