package lightning.format.gltf;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Base64;
import java.util.Collections;
import java.util.Random;
import java.util.concurrent.TimeoutException;
import lightning.base.work.Await;
import lightning.base.work.Progress;
import lightning.format.mesh.ConversionNotes;
import lightning.format.mesh.MeshException;
import lightning.sample.Slow;
import lightning.sample.TryFolder;
import lightning.scene.node.Mesh;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Compressed primitives, written by the Draco library: a pyramid over the unit square, by both of its methods. */
class DracoPrimitiveTest {
    private static final String SEQUENTIAL =
            "RFJBQ08CAgEAAAAEBQEAAQQBAgQCAwQDAAQBAQAJAwAAAgABAQAPA2kmzQwrzQwDBfWdiIT/v/8PAAAAAAAA/z8AAAAAAAAAAAAAAAAAAAAAgD8O";
    private static final String EDGEBREAKER =
            "RFJBQ08CAgEBAAAABQQABAAAAm8B/wERAf8AAAEACQMAAAIBAQEADwfNDCs1MwPy34L///8fAPz//r8AgPj/AIAAAAD4/wIAAAAAAP8/"
                    + "AAAAAAAAAAAAAAAAAAAAAIA/Dg==";

    /** Damaged grid of 72 faces: its decoder walks around a vertex without end. */
    private static final String ENDLESS =
            "RFJBQ08CAgEBAAABMUgASAUAB+/Tp0+fPh3/AREFAAAA/wYW12/qCoEB/wAAAQAJAwAAAgIBAQAMB1EBA1EBOQV1CkkSwQvBC50CUQETPE9m7o"
                    + "99sMxL9ES4dFkqc9vPgf//PxBWVfUGAFIFQwDAFgD4AwDQCwDAMgBAEBB4AqABACAtAIAOAAgB+ABAGwCQAwBgVQAAE98gAkAKABABoUUABGgB"
                    + "AIAF4ADQAwCQFRByAACWAwB+AACyAkApABQB4ASAAwBQAgB0AKANAEBhAGAKAMBwAIAOAMBJAHABEACYAgBsAkANAAAAAP8HAAAAAAAAAAAAAF"
                    + "z/f78AAMBACw==";

    @TempDir
    private Path folder;

    private static byte[] file(byte[] data, int faces, int vertices) {
        return file(data, faces, vertices, 1);
    }

    private static byte[] file(byte[] data, int faces, int vertices, int primitives) {
        String primitive = """
                {'attributes': {'POSITION': 0}, 'indices': 1,
                 'extensions': {'KHR_draco_mesh_compression': {'bufferView': 0, 'attributes': {'POSITION': 0}}}}
                """;
        String json = """
                {'asset': {'version': '2.0'}, 'scenes': [{'nodes': [0]}], 'nodes': [{'mesh': 0}],
                 'extensionsRequired': ['KHR_draco_mesh_compression'],
                 'meshes': [{'primitives': [PRIMITIVES]}],
                 'accessors': [{'componentType': 5126, 'count': VERTICES, 'type': 'VEC3'},
                  {'componentType': 5125, 'count': CORNERS, 'type': 'SCALAR'}],
                 'bufferViews': [{'buffer': 0, 'byteLength': LENGTH}], 'buffers': [{'byteLength': LENGTH}]}
                """.replace("PRIMITIVES", String.join(",", Collections.nCopies(primitives, primitive)))
                .replace("VERTICES", "" + vertices).replace("CORNERS", "" + 3 * faces).replace("LENGTH", "" + data.length);
        return GltfFixtures.binary(json, data);
    }

    private static Mesh read(Path file, byte[] content) throws IOException, MeshException {
        return GltfMeshReader.read(GltfFile.read(Files.write(file, content), Progress.NONE), new ConversionNotes()).getFirst().triangles();
    }

    @ParameterizedTest
    @ValueSource(strings = {SEQUENTIAL, EDGEBREAKER})
    void pyramid_isDecoded(String data) throws Exception {
        Mesh mesh = read(folder.resolve("a.glb"), file(Base64.getDecoder().decode(data), 4, 5));
        assertThat(mesh.triangleCount()).isEqualTo(4);
        double area = 0;
        for (int t = 0; t < 4; t++) {
            int tip = 0;
            for (int k = 0; k < 3; k++) {
                int v = mesh.triangles()[3 * t + k];
                float z = mesh.positions()[3 * v + 2];
                tip += z == 1 ? 1 : 0;
                assertThat(z).isIn(0f, 1f);
            }
            assertThat(tip).as("corners at the tip").isEqualTo(1);
            int a = 3 * mesh.triangles()[3 * t];
            int b = 3 * mesh.triangles()[3 * t + 1];
            int c = 3 * mesh.triangles()[3 * t + 2];
            float[] p = mesh.positions();
            area += ((p[b] - p[a]) * (p[c + 1] - p[a + 1]) - (p[b + 1] - p[a + 1]) * (p[c] - p[a])) / 2;
        }
        assertThat(area).as("area from above, of faces that look upward").isCloseTo(1, within(1e-4));
    }

    /** The accessor says how much memory the file justifies. */
    @Test
    void otherCountsThanTheAccessor_areRejected() {
        byte[] data = Base64.getDecoder().decode(SEQUENTIAL);
        assertThatExceptionOfType(MeshException.class).isThrownBy(() -> read(folder.resolve("a.glb"), file(data, 5, 5)))
                .withMessageEndingWith("must have 5 faces as its accessor says, has 4");
        assertThatExceptionOfType(MeshException.class).isThrownBy(() -> read(folder.resolve("a.glb"), file(data, 4, 6)))
                .withMessageEndingWith("must have 4 faces of 6 vertices as its accessors say, has 4 of 5");
        assertThatExceptionOfType(MeshException.class).isThrownBy(() -> read(folder.resolve("a.glb"), file(new byte[40], 4, 5)))
                .withMessageEndingWith("must be data of Draco, is not");
    }

    /** All primitives of a file share one limit of 4 s, and nothing goes on after it. */
    @Test
    @Slow
    void endlessData_endsByTheLimitOfTheFile() throws Exception {
        byte[] data = Base64.getDecoder().decode(ENDLESS);
        GltfFile file = GltfFile.read(Files.write(folder.resolve("a.glb"), file(data, 72, 49, 8)), Progress.NONE);
        assertThatExceptionOfType(MeshException.class).isThrownBy(() -> GltfMeshReader.read(file, new ConversionNotes()))
                .withMessageEndingWith("must be undamaged data of Draco, which is decoded in 4 s for all meshes of a file");
        assertThatExceptionOfType(TimeoutException.class).isThrownBy(() -> file.decodingTime().call("test", Duration.ofDays(1), () -> 7));
        Await.untilThreadEnded("Draco");
    }

    @Property
    void damagedData_isReadOrReported(@ForAll Random random) throws IOException {
        byte[] data = Base64.getDecoder().decode(random.nextBoolean() ? SEQUENTIAL : EDGEBREAKER);
        for (int i = 0; i <= random.nextInt(3); i++) {
            data[random.nextInt(data.length)] = (byte) random.nextInt();
        }
        try (TryFolder files = new TryFolder()) {
            read(files.file("draco.glb"), file(java.util.Arrays.copyOf(data, data.length - random.nextInt(4)), 4, 5));
        } catch (MeshException e) {
            assertThat(e.getMessage()).contains("must");
        }
    }
}
