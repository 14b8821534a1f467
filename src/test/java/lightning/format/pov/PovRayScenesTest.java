package lightning.format.pov;

import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assumptions.assumeThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import lightning.format.jen.JenReader;
import lightning.sample.Slow;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Lets the installed POV-Ray trace the exported scenes of {@code scenes}. */
@Slow
class PovRayScenesTest {
    static List<Path> scenes() throws IOException {
        try (Stream<Path> files = Files.list(Path.of("scenes"))) {
            return files.filter(file -> file.toString().endsWith(".jen")).sorted().toList();
        }
    }

    @ParameterizedTest
    @MethodSource("scenes")
    void exportedScene_isTraced(Path file) throws Exception {
        Optional<PovRayRunner> povRay = PovRayRunner.find();
        assumeThat(povRay).as("POV-Ray is installed").isPresent();
        PovScene scene = PovScene.of(JenReader.read(file).scene(), "scene");
        assertThatCode(() -> povRay.orElseThrow().traceMs(scene, 32, 24, 1)).doesNotThrowAnyException();
    }
}
