package lightning.format.gltf;

import com.openize.drako.DataType;
import com.openize.drako.Draco;
import com.openize.drako.DracoMesh;
import com.openize.drako.PointAttribute;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.Arrays;
import java.util.Map;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeoutException;
import lightning.base.work.TimeLimit;
import lightning.format.mesh.MeshException;
import lightning.format.mesh.MeshLimits;
import tools.jackson.databind.JsonNode;

/** Decoder of compressed primitives (KHR_draco_mesh_compression). */
final class DracoPrimitive {
    private static final String EXTENSION = "KHR_draco_mesh_compression";
    private static final byte[] MAGIC = "DRACO".getBytes(StandardCharsets.US_ASCII);
    /** Bytes before the data of the connectivity: magic, version, type, method, flags. */
    private static final int HEADER_BYTES = 11;
    private static final int METHOD = 8;
    private static final int EDGEBREAKER = 1;
    private static final int FLAGS = 9;
    private static final int METADATA_FLAG = 0x80;
    /** Time limit: on a slow machine, a million faces take 3 s. */
    private static final Duration TIME = Duration.ofSeconds(4);
    private static final Duration TIME_PER_FACE = Duration.ofNanos(20_000);

    private final GltfFile file;
    private final AccessorReader accessors;

    DracoPrimitive(GltfFile file, AccessorReader accessors) {
        this.file = file;
        this.accessors = accessors;
    }

    /**
     * Decodes a primitive if it is compressed: its accessors then have values.
     *
     * @throws MeshException if the data is damaged, or has other counts than the accessors
     */
    void decode(JsonValue primitive) throws IOException, MeshException {
        JsonValue compressed = primitive.get("extensions").get(EXTENSION);
        if (!compressed.isPresent()) {
            return;
        }
        JsonValue indices = primitive.get("indices");
        JsonValue position = primitive.get("attributes").get("POSITION");
        int corners = indices.resolve(file.array("accessors")).get("count").integer(1, 3 * MeshLimits.TRIANGLES);
        int vertices = accessors.count(position);
        ByteBuffer view = file.buffers().view(compressed.get("bufferView"));
        byte[] data = new byte[view.remaining()];
        view.get(data);
        checkCounts(compressed, data, corners / 3);
        new ExpansionLimit(file).checkBytes(4L * corners + 16L * vertices, compressed);
        DracoMesh mesh = mesh(compressed, data, corners / 3);
        if (mesh.getNumFaces() != corners / 3 || mesh.getNumPoints() != vertices) {
            throw compressed.problem("must have " + corners / 3 + " faces of " + vertices + " vertices as its accessors say, has "
                    + mesh.getNumFaces() + " of " + mesh.getNumPoints());
        }
        accessors.setIndices(indices, mesh.getIndices().toArray(), corners);
        for (Map.Entry<String, JsonNode> entry : compressed.get("attributes").node().properties()) {
            JsonValue accessor = primitive.get("attributes").get(entry.getKey());
            if (accessor.isPresent()) {
                PointAttribute attribute = attribute(compressed, mesh, entry.getValue().asInt(-1));
                accessors.setValues(accessor, values(compressed, attribute, accessor, vertices), attribute.getComponentsCount());
            }
        }
    }

    /** Rejects data that promises more faces than the accessors, before anything of that size is made. */
    private static void checkCounts(JsonValue json, byte[] data, int faces) throws MeshException {
        boolean isDraco = data.length > HEADER_BYTES + 2 && Arrays.equals(data, 0, MAGIC.length, MAGIC, 0, MAGIC.length);
        if (!isDraco) {
            throw json.problem("must be data of Draco, is not");
        }
        if ((data[FLAGS + 1] & METADATA_FLAG) != 0) {
            // Metadata of unknown length precedes the counts; the decoder's own checks apply.
            return;
        }
        boolean isEdgebreaker = data[METHOD] == EDGEBREAKER;
        int[] at = {HEADER_BYTES + (isEdgebreaker ? 1 : 0)};
        long first = varint(data, at);
        long declared = isEdgebreaker ? varint(data, at) : first;
        if (declared != faces) {
            throw json.problem("must have " + faces + " faces as its accessor says, has " + declared);
        }
    }

    /** Reads a number of seven bits for each byte, the lowest first. */
    private static long varint(byte[] data, int[] at) {
        long v = 0;
        for (int shift = 0; shift < 35 && at[0] < data.length; shift += 7) {
            byte b = data[at[0]++];
            v |= (long) (b & 0x7F) << shift;
            if (b >= 0) {
                break;
            }
        }
        return v;
    }

    private static DracoMesh mesh(JsonValue json, byte[] data, int faces) throws MeshException {
        try {
            // Some damaged data makes the decoder run forever.
            if (TimeLimit.call("Draco", TIME.plus(TIME_PER_FACE.multipliedBy(faces)), () -> Draco.decode(data)) instanceof DracoMesh mesh) {
                return mesh;
            }
        } catch (ExecutionException e) {
            // The decoder throws arbitrary runtime exceptions for damaged data, and asks for memory for any count.
            throw json.problem("must be undamaged data of Draco: " + e.getCause());
        } catch (TimeoutException e) {
            throw json.problem("must be undamaged data of Draco: its decoder does not end");
        }
        throw json.problem("must be a mesh of Draco, is a point cloud");
    }

    private static PointAttribute attribute(JsonValue json, DracoMesh mesh, int id) throws MeshException {
        for (int i = 0; i < mesh.getNumAttributes(); i++) {
            if (mesh.attribute(i).getUniqueId() == id) {
                return mesh.attribute(i);
            }
        }
        throw json.problem("must have an attribute " + id + " in its data, has none");
    }

    private float[] values(JsonValue json, PointAttribute attribute, JsonValue accessor, int vertices) throws MeshException {
        int components = attribute.getComponentsCount();
        boolean isNormalized = accessor.resolve(file.array("accessors")).get("normalized").bool(false);
        float[] values = new float[components * vertices];
        try {
            for (int v = 0; v < vertices; v++) {
                read(attribute, attribute.mappedIndex(v), isNormalized, values, components * v, components);
            }
        } catch (RuntimeException e) {
            throw json.problem("must be undamaged data of Draco: " + e);
        }
        return values;
    }

    private static void read(PointAttribute attribute, int index, boolean isNormalized, float[] out, int at, int components) {
        int type = attribute.getDataType();
        if (type == DataType.FLOAT32) {
            float[] v = new float[components];
            attribute.getValue(index, v);
            System.arraycopy(v, 0, out, at, components);
        } else if (type == DataType.UINT8 || type == DataType.INT8) {
            byte[] v = new byte[components];
            attribute.getValue(index, v);
            for (int c = 0; c < components; c++) {
                int code = type == DataType.UINT8 ? v[c] & 0xFF : v[c];
                out[at + c] = isNormalized ? (float) AccessorReader.fraction(code, type == DataType.UINT8 ? 255 : 127) : code;
            }
        } else if (type == DataType.UINT16 || type == DataType.INT16) {
            short[] v = new short[components];
            attribute.getValue(index, v);
            for (int c = 0; c < components; c++) {
                int code = type == DataType.UINT16 ? v[c] & 0xFFFF : v[c];
                out[at + c] = isNormalized ? (float) AccessorReader.fraction(code, type == DataType.UINT16 ? 65535 : 32767) : code;
            }
        } else {
            int[] v = new int[components];
            attribute.getValue(index, v);
            for (int c = 0; c < components; c++) {
                out[at + c] = v[c];
            }
        }
    }
}
