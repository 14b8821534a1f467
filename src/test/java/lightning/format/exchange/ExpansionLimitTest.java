package lightning.format.exchange;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import com.sun.management.ThreadMXBean;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collections;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import lightning.base.work.Progress;
import lightning.format.exchange.assembly.ImportedScene;
import lightning.format.exchange.assembly.LightUnits;
import lightning.format.gltf.GltfFixtures;
import lightning.format.mesh.MeshException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Limits for the memory that a glTF file expands to. */
class ExpansionLimitTest {
    private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    private static final String PRIMITIVE = "{'attributes': {'POSITION': 0}, 'indices': 3}";
    @TempDir
    private Path folder;

    /** Nodes that all show one mesh. */
    private static String scene(int nodes, String primitive, int primitives) {
        String list = IntStream.range(0, nodes).mapToObj(String::valueOf).collect(Collectors.joining(","));
        return GltfFixtures.SQUARE_JSON.replace("'nodes': [0]", "'nodes': [" + list + "]")
                .replace("{'mesh': 0, 'name': 'floor'}", repeated("{'mesh': 0}", nodes))
                .replace("{'attributes': {'POSITION': 0, 'NORMAL': 1, 'TEXCOORD_0': 2}, 'indices': 3}", repeated(primitive, primitives));
    }

    private static String repeated(String text, int times) {
        return String.join(",", Collections.nCopies(times, text));
    }

    @Test
    void tooManyInstances_areRejectedBeforeAllocation() throws IOException {
        Path file = writeFile(scene(1000, PRIMITIVE, 1000));
        long startBytes = THREADS.getCurrentThreadAllocatedBytes();
        assertThatExceptionOfType(MeshException.class).isThrownBy(() -> read(file)).withMessage(file + ": nodes: must show at most 100000"
                + " shapes for a file and buffers of " + Files.size(file) + " bytes, found 1000000; each node shows every"
                + " primitive of its mesh");
        assertThat(THREADS.getCurrentThreadAllocatedBytes() - startBytes).as("bytes for a file of %d", Files.size(file))
                .isLessThan(16L << 20);
    }

    @Test
    void nestedNodes_areCounted() throws IOException {
        String children = IntStream.range(1, 500).mapToObj(String::valueOf).collect(Collectors.joining(","));
        Path file = writeFile(scene(1, PRIMITIVE, 300).replace("{'mesh': 0}",
                "{'mesh': 0, 'children': [" + children + "]}, " + repeated("{'mesh': 0}", 499)));
        assertThatExceptionOfType(MeshException.class).isThrownBy(() -> read(file))
                .withMessageContaining("found 150000; each node shows every primitive");
    }

    @Test
    void linesAndPoints_areNotCounted() throws Exception {
        ImportedScene imported = read(writeFile(scene(400, "{'attributes': {'POSITION': 0}, 'mode': 1}," + PRIMITIVE, 1)
                .replace("'mode': 1}", "'mode': 1}, " + repeated("{'attributes': {'POSITION': 0}, 'mode': 0}", 300))));
        assertThat(imported.scene().stage().shapeCount()).isEqualTo(400);
    }

    /** Object of a few parts with a hundred instances. */
    @Test
    void ordinaryNodes_areAccepted() throws Exception {
        assertThat(read(writeFile(scene(100, PRIMITIVE, 20))).scene().stage().shapeCount()).isEqualTo(2000);
    }

    /** 200 primitives of 30 000 zero vertices, none of which are in the file. */
    @Test
    void sharedVertices_areLimitedByFileSize() throws IOException {
        String zeros = scene(1, "{'attributes': {'POSITION': 0}}", 200)
                .replace("{'bufferView': 0, 'componentType': 5126, 'count': 4, 'type': 'VEC3'}", "{'count': 30000, 'type': 'VEC3'}")
                .replace("'asset'", "'extras': '" + "x".repeat(30_000) + "', 'asset'");
        Path file = writeFile(zeros);
        long startBytes = THREADS.getCurrentThreadAllocatedBytes();
        assertThatExceptionOfType(MeshException.class).isThrownBy(() -> read(file))
                .withMessageContaining("the meshes up to here must take at most 68 MiB for a file and buffers of");
        assertThat(THREADS.getCurrentThreadAllocatedBytes() - startBytes).isLessThan(512L << 20);
    }

    private Path writeFile(String json) throws IOException {
        return Files.write(folder.resolve("a.glb"), GltfFixtures.binary(json, GltfFixtures.SQUARE));
    }

    private ImportedScene read(Path file) throws IOException, MeshException {
        return SceneImporter.read(file, folder.resolve("a.jen"), LightUnits.CANDELA, Progress.NONE);
    }
}
