package lightning.format;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import lightning.format.gltf.GltfFixtures;
import lightning.format.mesh.MeshException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Files that mesh files name. */
class FurtherFilesTest {
    private static final byte[] NO_DATA = {};

    @TempDir
    Path folder;

    private Path write(String name, byte[] content) throws IOException {
        return Files.write(folder.resolve(name), content);
    }

    private static String json(String buffers) {
        return "{'asset': {'version': '2.0'}, 'buffers': [" + buffers + "]}";
    }

    private static byte[] text(String buffers) {
        return json(buffers).replace('\'', '"').getBytes(StandardCharsets.UTF_8);
    }

    @Test
    void buffersOfGltf_areNamedOnce() throws Exception {
        Path data = write("my data.bin", new byte[3]).toRealPath();
        String buffer = "{'uri': 'my%20data.bin', 'byteLength': 3}";
        assertThat(MeshFormat.furtherFiles(write("a.gltf", text(buffer + ", " + buffer)))).containsExactly(data);
        assertThat(MeshFormat.furtherFiles(write("a.glb", GltfFixtures.binary(json(buffer), NO_DATA)))).containsExactly(data);
    }

    @Test
    void embeddedBuffers_nameNoFiles() throws Exception {
        assertThat(MeshFormat.furtherFiles(write("a.gltf", text("{'uri': 'data:;base64,AAAA', 'byteLength': 3}")))).isEmpty();
        assertThat(MeshFormat.furtherFiles(write("a.glb", GltfFixtures.binary(json("{'byteLength': 3}"), new byte[3])))).isEmpty();
    }

    @Test
    void otherFormats_nameNoFiles() throws Exception {
        assertThat(MeshFormat.furtherFiles(write("a.obj", "v 0 0 0\n".getBytes(StandardCharsets.UTF_8)))).isEmpty();
        assertThat(MeshFormat.furtherFiles(write("empty.obj", NO_DATA))).isEmpty();
        assertThat(MeshFormat.furtherFiles(Path.of("textures", "wood.png"))).isEmpty();
    }

    @Test
    void missingBuffer_isReported() throws Exception {
        Path mesh = write("a.gltf", text("{'uri': 'none.bin', 'byteLength': 3}"));
        assertThatThrownBy(() -> MeshFormat.furtherFiles(mesh)).isInstanceOf(MeshException.class)
                .hasMessageContaining("there is no file 'none.bin'");
    }
}
