package lightning.format.gltf;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Base64;

/** Builds glTF files for tests: a JSON with single quotes instead of double ones, followed by binary data. */
public final class GltfFixtures {
    /** Square of four vertices: positions, normals, texture coordinates, then six indices. */
    public static final byte[] SQUARE =
            bytes(new float[] {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 1, 1, 0, 1},
                    0, 1, 2, 0, 2, 3);
    /** The square as a scene of one node. */
    public static final String SQUARE_JSON = """
            {'asset': {'version': '2.0'}, 'scene': 0, 'scenes': [{'nodes': [0]}], 'nodes': [{'mesh': 0, 'name': 'floor'}],
             'meshes': [{'name': 'square', 'primitives': [{'attributes': {'POSITION': 0, 'NORMAL': 1, 'TEXCOORD_0': 2}, 'indices': 3}]}],
             'accessors': [{'bufferView': 0, 'componentType': 5126, 'count': 4, 'type': 'VEC3'},
              {'bufferView': 0, 'byteOffset': 48, 'componentType': 5126, 'count': 4, 'type': 'VEC3'},
              {'bufferView': 0, 'byteOffset': 96, 'componentType': 5126, 'count': 4, 'type': 'VEC2'},
              {'bufferView': 1, 'componentType': 5123, 'count': 6, 'type': 'SCALAR'}],
             'bufferViews': [{'buffer': 0, 'byteLength': 128}, {'buffer': 0, 'byteOffset': 128, 'byteLength': 12}],
             'buffers': [{'byteLength': 140}]}
            """;

    /** The square below a light of intensity 100, in unspecified units. */
    public static final String LIT_JSON = SQUARE_JSON.replace("'nodes': [{'mesh': 0, 'name': 'floor'}]", """
            'nodes': [{'mesh': 0, 'name': 'floor', 'children': [1]},
              {'name': 'bulb', 'translation': [0.5, 0.5, 1], 'extensions': {'KHR_lights_punctual': {'light': 0}}}],
             'extensions': {'KHR_lights_punctual': {'lights': [{'type': 'point', 'intensity': 100}]}}""");

    private GltfFixtures() {}

    private static byte[] bytes(float[] floats, int... shorts) {
        ByteBuffer b = ByteBuffer.allocate(4 * floats.length + 2 * shorts.length).order(ByteOrder.LITTLE_ENDIAN);
        for (float f : floats) {
            b.putFloat(f);
        }
        for (int i : shorts) {
            b.putShort((short) i);
        }
        return b.array();
    }

    public static byte[] binary(String json, byte[] data) {
        byte[] text = json.replace('\'', '"').getBytes(StandardCharsets.UTF_8);
        int padded = (text.length + 3) / 4 * 4;
        ByteBuffer b = ByteBuffer.allocate(12 + 8 + padded + 8 + data.length).order(ByteOrder.LITTLE_ENDIAN);
        b.put(GltfFile.MAGIC).putInt(2).putInt(b.capacity()).putInt(padded).putInt(GltfFile.JSON_CHUNK).put(text);
        while (b.position() < 20 + padded) {
            b.put((byte) ' ');
        }
        return b.putInt(data.length).putInt(GltfFile.BINARY_CHUNK).put(data).array();
    }

    public static byte[] text(String json, byte[] data) {
        return json.replace("'buffers': [{",
                "'buffers': [{'uri': 'data:application/octet-stream;base64," + Base64.getEncoder().encodeToString(data)
                        + "', ")
                .replace('\'', '"').getBytes(StandardCharsets.UTF_8);
    }
}
