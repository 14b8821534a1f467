package lightning.format.gltf;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import lightning.base.work.Await;
import lightning.base.work.Progress;
import lightning.format.mesh.ConversionNotes;
import lightning.format.mesh.MeshException;
import lightning.scene.node.Mesh;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Meshes of glTF files, and their errors. */
class GltfMeshReaderTest {
    private final ConversionNotes notes = new ConversionNotes();

    @TempDir
    private Path folder;

    @Test
    void square_isEqualInTextAndBinary() throws IOException, MeshException {
        Mesh mesh = onlyMesh(GltfFixtures.SQUARE_JSON);
        assertThat(mesh.positions()).containsExactly(0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0);
        assertThat(mesh.triangles()).containsExactly(0, 1, 2, 0, 2, 3);
        assertThat(mesh.normals()).containsExactly(0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1);
        assertThat(mesh.coordinates()).as("v upwards").containsExactly(0, 1, 1, 1, 1, 0, 0, 0);
        assertThat(read("a.gltf", GltfFixtures.text(GltfFixtures.SQUARE_JSON, GltfFixtures.SQUARE)).getFirst().triangles()).isEqualTo(mesh);
        Files.write(folder.resolve("my data.bin"), GltfFixtures.SQUARE);
        assertThat(read("a.gltf",
                json("'buffers': [{", "'buffers': [{'uri': 'my%20data.bin', ").replace('\'', '"').getBytes(StandardCharsets.UTF_8))
                .getFirst()
                .triangles()).isEqualTo(mesh);
        assertThat(notes.counts()).isEmpty();
    }

    @Test
    void stripsAndFans_becomeTriangles() throws IOException, MeshException {
        assertThat(onlyMesh(json("'indices': 3", "'mode': 5")).triangles()).containsExactly(0, 1, 2, 1, 3, 2);
        Mesh fan = onlyMesh(json("'indices': 3", "'mode': 6"));
        assertThat(corners(fan)).containsExactly(1, 0, 0, 1, 1, 0, 0, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 0);
    }

    @Test
    void unusedVertex_isRemoved() throws IOException, MeshException {
        assertThat(onlyMesh(json("'count': 6", "'count': 3")).vertexCount()).isEqualTo(3);
    }

    @Test
    void normalizedPositions_areScaled() throws IOException, MeshException {
        String quantized = json("'byteOffset': 128, 'byteLength': 12", "'byteOffset': 128, 'byteLength': 12, 'byteStride': 4")
                .replace("'accessors': [",
                        "'accessors': [{'bufferView': 1, 'componentType': 5123, 'normalized': true, 'count': 3, 'type': 'VEC2'},");
        String moved = quantized.replace("'POSITION': 0, 'NORMAL': 1, 'TEXCOORD_0': 2}, 'indices': 3", "'POSITION': 1, 'TEXCOORD_0': 0}")
                .replace("'count': 4", "'count': 3");
        assertThat(onlyMesh(moved).coordinates()).containsExactly(0, (float) (1 - 1 / 65535.0), 2 / 65535f, 1, 2 / 65535f,
                (float) (1 - 3 / 65535.0));
    }

    @Test
    void sparseValues_replaceOthers() throws IOException, MeshException {
        Mesh mesh = onlyMesh(json("{'bufferView': 0, 'componentType': 5126, 'count': 4, 'type': 'VEC3'}",
                "{'bufferView': 0, 'componentType': 5126, 'count': 4, 'type': 'VEC3', 'sparse': {'count': 1,"
                        + " 'indices': {'bufferView': 1, 'byteOffset': 2, 'componentType': 5123}, 'values': {'bufferView': 0, 'byteOffset': 24}}}"));
        assertThat(mesh.positions()).containsExactly(0, 0, 0, 1, 1, 0, 1, 1, 0, 0, 1, 0);
    }

    /** Reuses positions as tangents: four numbers from an offset on. */
    @Test
    void tangents_needNormals() throws IOException, MeshException {
        String tangents = json("'accessors': [",
                "'accessors': [{'bufferView': 0, 'byteOffset': 64, 'componentType': 5126, 'count': 4, 'type': 'VEC4'},")
                .replace("'POSITION': 0, 'NORMAL': 1, 'TEXCOORD_0': 2}, 'indices': 3",
                        "'POSITION': 1, 'NORMAL': 2, 'TANGENT': 0}, 'indices': 4");
        // The numbers are 0 1 0 0, 1 0 0 1, 0 0 1 0, 1 1 0 1.
        float half = (float) Math.sqrt(0.5);
        assertThat(onlyMesh(tangents).tangents()).containsExactly(0, 1, 0, 1, 1, 0, 0, 1, 0, 0, 1, 1, half, half, 0, 1);
        assertThat(notes.counts()).doesNotContainKey("attributes TANGENT of primitives")
                .containsEntry("tangents with a handedness (w) other than 1 or -1", 2);
        assertThat(onlyMesh(tangents.replace("'NORMAL': 2, ", "")).tangents()).isNull();
        assertThat(notes.counts()).containsEntry("attributes TANGENT of primitives", 1);
    }

    /**
     * Vertex colors of floating-point and integer types are linear, as glTF 2.0 and docs/jen-format.md define: 0, 1, 2 and 0
     * of 65535.
     */
    @Test
    void vertexColors_areLinear() throws IOException, MeshException {
        String integers = json("'accessors': [",
                "'accessors': [{'bufferView': 1, 'componentType': 5121, 'normalized': true, 'count': 4, 'type': 'VEC3'},")
                .replace("'POSITION': 0, 'NORMAL': 1, 'TEXCOORD_0': 2}, 'indices': 3", "'POSITION': 1, 'COLOR_0': 0}");
        // The bytes are 0 0 1, 0 2 0, 0 0 2, 0 3 0; triangles without indices take the first three vertices.
        assertThat(onlyMesh(integers).colors()).containsExactly(0, 0, 1 / 255f, 0, 2 / 255f, 0, 0, 0, 2 / 255f);
        String floats = json("'TEXCOORD_0': 2}", "'COLOR_0': 0}");
        assertThat(onlyMesh(floats).colors()).containsExactly(0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0);
    }

    @Test
    void tangentsWithThreeComponents_areRejected() {
        assertRejected(json("'TEXCOORD_0': 2}", "'TANGENT': 1}"), "accessors[1].type: must have 4 numbers each, has 3");
    }

    @ParameterizedTest
    @ValueSource(strings = {"baseColorTexture", "metallicRoughnessTexture"})
    void textureTransform_isApplied(String texture) throws IOException, MeshException {
        Mesh mesh =
                onlyMesh(json("'indices': 3", "'indices': 3, 'material': 0").replace("'accessors'", "'materials': [{'pbrMetallicRoughness':"
                        + " {'" + texture
                        + "': {'index': 0, 'extensions': {'KHR_texture_transform': {'offset': [0.5, 0], 'scale': [2, 4]}}}}}], 'accessors'"));
        assertThat(mesh.coordinates()).containsExactly(0.5f, 1, 2.5f, 1, 2.5f, -3, 0.5f, -3);
    }

    @Test
    void meshParts_areNamedByMaterial() throws IOException, MeshException {
        String two = json("'indices': 3}",
                "'indices': 3, 'material': 1}, {'attributes': {'POSITION': 0}, 'indices': 3}, {'attributes': {'POSITION': 0}, 'mode': 1}")
                .replace("'accessors'", "'materials': [{}, {'name': 'red'}], 'accessors'");
        List<GltfPart> parts = read("a.glb", GltfFixtures.binary(two, GltfFixtures.SQUARE));
        assertThat(parts).extracting(GltfPart::name).containsExactly("square (red)", "square");
        assertThat(parts).extracting(GltfPart::material).containsExactly(1, -1);
        assertThat(notes.counts()).containsOnlyKeys("primitives of lines");
    }

    @Test
    @Timeout(Await.TIMEOUT_SECONDS)
    void oversizedCount_isRejectedBeforeAllocation() {
        assertRejected(json("'count': 4, 'type': 'VEC3'", "'count': 60000000, 'type': 'VEC3'"),
                "accessors[0]: needs 720000000 bytes of its bufferView, which has 128");
        assertRejected(json("'bufferView': 0, 'componentType': 5126, 'count': 4", "'componentType': 5126, 'count': 60000000"),
                "accessors[0].count: must be at most the file's size if there is no bufferView, was 60000000");
        assertRejected(json("'byteLength': 140", "'byteLength': 2000000000"),
                "buffers[0].byteLength: must be at most the available bytes, 140, was 2000000000");
        assertRejected(json("'byteLength': 128", "'byteLength': 141"),
                "bufferViews[0].byteLength: must be a whole number from 0 to 140, was '141'");
    }

    @Test
    void invalidFiles_areReportedWithPath() {
        assertRejected(json("'2.0'", "'3.0'"), "asset.version: must be 2.0, was 3.0");
        assertRejected(json("'2.0'", "7"), "asset.version: must be text in quotes, was '7'");
        assertRejected(json("'indices': 3", "'indices': 4"),
                "meshes[0].primitives[0].indices: must be a whole number from 0 to 3, was '4'");
        assertRejected(json("'VEC2'", "'MAT3'"), "accessors[2].type: must be SCALAR, VEC2, VEC3, VEC4 or MAT4, was 'MAT3'");
        assertRejected(json("'componentType': 5123", "'componentType': 5126"), "accessors[3]: indices must be unsigned scalars");
        assertRejected(json("'scene': 0", "'extensionsRequired': ['KHR_gaussian_splatting']"),
                "extensionsRequired[0]: requires KHR_gaussian_splatting, which Lightning does not support; export without it");
        assertRejected(json("'meshes': [{", "'meshes': [7, {"), "meshes[0]: must be an object, was '7'");
        assertRejected(json("'buffers': [{", "'buffers': [{'uri': '../secret.bin', "),
                "buffers[0].uri: must be data or a file in the folder of this one, was '../secret.bin'");
        assertRejected(json("'buffers': [{", "'buffers': [{'uri': 'file:///etc/passwd', "),
                "buffers[0].uri: must be data or a file in the folder");
        assertRejected(json("'buffers': [{", "'buffers': [{'uri': 'not there.bin', "), "buffers[0].uri: there is no file 'not there.bin'");
        assertRejected(json("'mode'", "'mode'").replace("'asset'", "asset"), "line 1, column ");
    }

    /** Version as text, as a number in early files, missing, and in the header of a GLB. */
    @Test
    void versionOne_isRejectedWithExportHint() throws IOException {
        String message = "is glTF 1.0; export it as glTF 2.0";
        assertRejected(json("'2.0'", "'1.0'"), message);
        assertRejected(json("'2.0'", "'1.0.1'"), message);
        assertRejected(json("'2.0'", "1"), message);
        assertRejected("{'meshes': {'a': {}}, 'nodes': {}, 'asset': {}}", message);
        byte[] binary = GltfFixtures.binary(GltfFixtures.SQUARE_JSON, GltfFixtures.SQUARE);
        binary[4] = 1;
        assertThatExceptionOfType(MeshException.class).isThrownBy(() -> read("b.glb", binary))
                .withMessage(folder.resolve("b.glb") + ": " + message);
        binary[4] = 3;
        assertThatExceptionOfType(MeshException.class).isThrownBy(() -> read("b.glb", binary))
                .withMessage(folder.resolve("b.glb") + ": version: must be 2, was 3");
    }

    private static String json(String from, String to) {
        return GltfFixtures.SQUARE_JSON.replaceFirst(Pattern.quote(from), Matcher.quoteReplacement(to));
    }

    private static float[] corners(Mesh mesh) {
        float[] corners = new float[9 * mesh.triangleCount()];
        for (int i = 0; i < corners.length; i++) {
            corners[i] = mesh.positions()[3 * mesh.triangles()[i / 3] + i % 3];
        }
        return corners;
    }

    private void assertRejected(String json, String message) {
        assertThatExceptionOfType(MeshException.class).isThrownBy(() -> read("a.glb", GltfFixtures.binary(json, GltfFixtures.SQUARE)))
                .withMessageStartingWith(folder.resolve("a.glb") + ": " + message);
    }

    private Mesh onlyMesh(String json) throws IOException, MeshException {
        List<GltfPart> parts = read("a.glb", GltfFixtures.binary(json, GltfFixtures.SQUARE));
        assertThat(parts).hasSize(1);
        return parts.getFirst().triangles();
    }

    private List<GltfPart> read(String name, byte[] file) throws IOException, MeshException {
        return GltfMeshReader.read(GltfFile.read(Files.write(folder.resolve(name), file), Progress.NONE), notes);
    }
}
