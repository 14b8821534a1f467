package lightning.format.exchange;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import lightning.base.work.Progress;
import lightning.format.exchange.assembly.LightUnits;
import lightning.format.gltf.MeshFileWriter;
import lightning.format.jen.JenReader;
import lightning.format.mesh.NamedMesh;
import lightning.sample.AttributeArbitraries;
import lightning.sample.SampleMeshes;
import lightning.sample.Slow;
import lightning.scene.Camera;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.Stage;
import lightning.scene.World;
import lightning.scene.light.Light;
import lightning.scene.light.LightRig;
import lightning.scene.light.LightType;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Written glTF files, by the validator of the Khronos Group. The environment variable {@code LIGHTNING_NODE_MODULES} names the folder of
 * Node.js packages with {@code gltf-validator}; without it, the tests are skipped.
 */
@Slow
class GltfValidatorTest {
    private static final Path SCRIPT = Path.of("src/test/resources/lightning/format/exchange/validate_gltf.js");
    private static final String MODULES = System.getenv("LIGHTNING_NODE_MODULES");
    private static final int RIGS = 60;

    @TempDir
    private Path folder;

    @BeforeAll
    static void requireValidator() {
        Assumptions.assumeTrue(MODULES != null, "no gltf-validator");
    }

    private static void assertValid(List<Path> files) throws IOException, InterruptedException {
        List<String> command = new ArrayList<>(List.of("node", SCRIPT.toString()));
        files.forEach(file -> command.add(file.toString()));
        var builder = new ProcessBuilder(command).redirectErrorStream(true);
        builder.environment().put("NODE_PATH", MODULES);
        Process process = builder.start();
        process.getOutputStream().close();
        String text = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertThat(process.waitFor(1, TimeUnit.MINUTES)).isTrue();
        assertThat(text.lines().toList()).isEqualTo(Collections.nCopies(files.size(), "checked"));
    }

    private Path exported(String name, Scene scene, LightUnits units) throws Exception {
        Path source = Files.write(folder.resolve("source.glb"), MeshFileWriter.write(List.of(new NamedMesh("cube", SampleMeshes.cube()))));
        return Files.write(folder.resolve(name), LightExport.toGltf(source, scene, units, Progress.NONE).bytes());
    }

    private static Scene scene(Light light) {
        return new Scene(PictureSettings.DEFAULT, Camera.DEFAULT, World.DEFAULT, new Stage(List.of(), List.of()),
                LightRig.of(List.of(light), List.of()));
    }

    @Test
    void lightsOfShippedScenes_areValid() throws Exception {
        List<Path> files = new ArrayList<>();
        try (Stream<Path> scenes = Files.list(Path.of("scenes"))) {
            for (Path scene : scenes.filter(file -> file.toString().endsWith(".jen")).sorted().toList()) {
                files.add(exported(scene.getFileName() + ".glb", JenReader.read(scene).scene(), LightUnits.CANDELA));
            }
        }
        assertThat(files).hasSizeGreaterThan(10);
        assertValid(files);
    }

    @Test
    void lightsOfRandomRigs_areValid() throws Exception {
        List<Path> files = new ArrayList<>();
        List<Light> lights = AttributeArbitraries.lights()
                .map(change -> change.after().withGobo(Optional.empty()).withProfile(Optional.empty()).withTexture(Optional.empty())
                        .retainLinks(_ -> false))
                .list().ofSize(RIGS).sample();
        for (Light light : lights) {
            for (LightUnits units : LightUnits.values()) {
                Scene scene = scene(light);
                files.add(exported(files.size() + ".glb", scene, units));
            }
        }
        assertValid(files);
    }

    @Test
    void spotsOfExtremeAngles_areValid() throws Exception {
        List<Path> files = new ArrayList<>();
        for (double angle : new double[] {0, 1e-9, 45, 89.9999999, 90, 180}) {
            Light spot = Light.of("key", LightType.SPOT).withAngle(angle);
            files.add(exported(files.size() + ".glb", scene(spot), LightUnits.CANDELA));
        }
        assertValid(files);
    }

    @Test
    void writtenMeshes_areValid() throws Exception {
        assertValid(List.of(Files.write(folder.resolve("a.glb"),
                MeshFileWriter.write(List.of(new NamedMesh("one", SampleMeshes.cube()), new NamedMesh("two", SampleMeshes.cube()))))));
    }
}
