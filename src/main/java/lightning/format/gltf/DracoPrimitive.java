package lightning.format.gltf;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeoutException;
import lightning.format.mesh.MeshException;
import lightning.format.mesh.MeshLimits;
import tools.jackson.databind.JsonNode;

/** Decoder of compressed primitives (KHR_draco_mesh_compression). */
record DracoPrimitive(GltfFile file, AccessorReader accessors) {
    private static final String EXTENSION = "KHR_draco_mesh_compression";
    private static final byte[] MAGIC = "DRACO".getBytes(StandardCharsets.US_ASCII);
    /** Bytes before the data of the connectivity: magic, version, type, method, flags. */
    private static final int HEADER_BYTES = 11;
    private static final int METHOD = 8;
    private static final int EDGEBREAKER = 1;
    private static final int FLAGS = 9;
    private static final int METADATA_FLAG = 0x80;
    /** Time limit of all primitives of a file, and what each adds to it: on a slow machine, a million faces take 3 s. */
    static final Duration TIME = Duration.ofSeconds(4);
    private static final Duration TIME_PER_FACE = Duration.ofNanos(20_000);

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
        List<Map.Entry<String, JsonNode>> entries = compressed.get("attributes").node().properties().stream()
                .filter(entry -> primitive.node().path("attributes").has(entry.getKey())).toList();
        List<Integer> ids = entries.stream().map(entry -> entry.getValue().asInt(-1)).toList();
        Object[] mesh = mesh(compressed, data, ids, corners / 3);
        if ((int) mesh[0] != corners / 3 || (int) mesh[1] != vertices) {
            throw compressed.problem("must have " + corners / 3 + " faces of " + vertices + " vertices as its accessors say, has "
                    + mesh[0] + " of " + mesh[1]);
        }
        accessors.setIndices(indices, (int[]) mesh[2], corners);
        for (int i = 0; i < ids.size(); i++) {
            int at = DracoDecoder.FIRST + DracoDecoder.PER_ATTRIBUTE * i;
            if (!(mesh[at + 2] instanceof float[] values)) {
                throw compressed.problem("must have an attribute " + ids.get(i) + " in its data, has none");
            }
            JsonValue accessor = primitive.get("attributes").get(entries.get(i).getKey());
            int largest = (int) mesh[at + 1];
            if (largest > 0 && accessor.resolve(file.array("accessors")).get("normalized").bool(false)) {
                for (int k = 0; k < values.length; k++) {
                    values[k] = (float) AccessorReader.fraction((int) values[k], largest);
                }
            }
            accessors.setValues(accessor, values, (int) mesh[at]);
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

    private Object[] mesh(JsonValue json, byte[] data, List<Integer> ids, int faces) throws MeshException {
        try {
            Object[] mesh = file.decodingTime().call("Draco", TIME_PER_FACE.multipliedBy(faces),
                    () -> DracoDecoder.interruptible().apply(data, ids));
            if (mesh.length > 0) {
                return mesh;
            }
        } catch (ExecutionException e) {
            // The decoder throws arbitrary exceptions for damaged data, and asks for memory for any count.
            throw json.problem("must be undamaged data of Draco: " + e.getCause());
        } catch (TimeoutException e) {
            throw json.problem("must be undamaged data of Draco, which is decoded in " + TIME.toSeconds() + " s for all meshes of a file");
        }
        throw json.problem("must be a mesh of Draco, is a point cloud");
    }
}
