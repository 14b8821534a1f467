package lightning.format.usd;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import lightning.base.process.PythonConverter;
import lightning.base.work.Await;
import lightning.base.work.Progress;
import lightning.format.mesh.MeshException;
import lightning.sample.PythonPrograms;
import lightning.sample.Slow;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** Stages that need too much time or memory, and converters whose Lightning has ended. */
@Slow
@Timeout(value = Await.TIMEOUT_SECONDS, unit = TimeUnit.SECONDS)
class UsdLimitsTest {
    private static final Path SCRIPT = Path.of("src/main/python/lightning_usd").toAbsolutePath();

    @TempDir
    private Path folder;

    @BeforeEach
    void requireUsd() {
        PythonPrograms.require("pxr");
    }

    private void convert(Path stage, long memory) throws IOException, MeshException {
        convert(SCRIPT, stage, memory);
    }

    private static void convert(Path script, Path stage, long memory) throws IOException, MeshException {
        var program = new PythonConverter(Path.of(PythonPrograms.require("pxr")), script, Duration.ofMinutes(2), UsdConverter.USD);
        new UsdConverter(program, memory, 999_999).convert(stage, StageChoice.DEFAULT, Progress.NONE, _ -> "");
    }

    @Test
    void referencesThatMultiplyPrims_endBeforeTheyAreComposed() throws Exception {
        Path stage = NestedStages.write(folder.resolve("laughs.usda"), 9);
        assertThatThrownBy(() -> convert(stage, 1L << 30)).isInstanceOf(MeshException.class)
                .hasMessageContaining("laughs.usda: has more than 1000000 prims, because references multiply them to about 4e+09");
    }

    @Test
    @EnabledOnOs(OS.LINUX)
    void crashOfUsdCore_isOneSentence() throws Exception {
        Files.copy(SCRIPT.resolveSibling("converter.py"), folder.resolve("converter.py"));
        Path script = Files.createDirectory(folder.resolve("script"));
        Files.writeString(script.resolve("reader.py"), "import os\ndef main(arguments):\n    os.abort()\n");
        Path stage = Files.writeString(folder.resolve("a.usda"), "#usda 1.0\n");
        assertThatThrownBy(() -> convert(script, stage, 1L << 30)).isInstanceOf(MeshException.class)
                .hasMessageEndingWith("a.usda: cannot be read by usd-core, which ended with signal 6");
    }

    @Test
    @EnabledOnOs(OS.LINUX)
    void memoryOfConverter_isLimited() throws Exception {
        Path stage = NestedStages.write(folder.resolve("large.usda"), 6);
        assertThatThrownBy(() -> convert(stage, 150L << 20)).isInstanceOf(MeshException.class)
                .hasMessageContaining("large.usda: needs more than 150 MiB of memory in usd-core; give Java more memory");
    }

    @Test
    void trianglesBeyondMemory_endBeforeTheyAreConverted() throws Exception {
        Path stage = folder.resolve("faces.usdc");
        PythonPrograms.script(folder, List.of("-c", """
                import sys
                from pxr import Usd, UsdGeom, Vt
                stage = Usd.Stage.CreateNew(sys.argv[1])
                mesh = UsdGeom.Mesh.Define(stage, "/m")
                mesh.CreatePointsAttr([(0, 0, 0), (1, 0, 0), (0, 1, 0)])
                mesh.CreateFaceVertexCountsAttr(Vt.IntArray(1000000, 3))
                mesh.CreateFaceVertexIndicesAttr(Vt.IntArray([0, 1, 2] * 1000000))
                stage.Save()
                """, stage.toString()));
        assertThat(Files.size(stage)).isLessThan(20_000);
        assertThatThrownBy(() -> convert(stage, 1L << 30)).isInstanceOf(MeshException.class)
                .hasMessageContaining("has more than 999999 triangles, too many for Java's memory; give it more");
    }

    @Test
    @EnabledOnOs(OS.LINUX)
    void converter_endsWithKilledLightning() throws Exception {
        Path stage = NestedStages.write(folder.resolve("slow.usda"), 6);
        Path scratch = Files.createDirectory(folder.resolve("tmp"));
        var builder = new ProcessBuilder(Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-Djava.io.tmpdir=" + scratch, "-cp", System.getProperty("java.class.path"), StageHolder.class.getName(), stage.toString());
        builder.environment().put("LIGHTNING_PYTHON", PythonPrograms.require("pxr"));
        Process lightning = builder.start();
        List<ProcessHandle> converters = List.of();
        try {
            assertThat(lightning.inputReader().readLine()).isEqualTo("reading");
            while (converters.size() < 2) {
                Thread.sleep(20);
                converters = lightning.descendants().toList();
            }
            // usd-core composes by now.
            Thread.sleep(1500);
            assertThat(converters).allMatch(ProcessHandle::isAlive);
            lightning.destroyForcibly().waitFor();
            Await.untilEnded(converters);
            try (Stream<Path> left = Files.list(scratch)) {
                assertThat(left).isEmpty();
            }
        } finally {
            lightning.destroyForcibly();
            converters.forEach(ProcessHandle::destroyForcibly);
        }
    }
}
