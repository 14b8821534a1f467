package lightning.format.exchange;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import lightning.base.work.Progress;
import lightning.format.exchange.assembly.ExportedLights;
import lightning.format.exchange.assembly.LightUnits;
import lightning.format.jen.JenDocument;
import lightning.format.jen.JenReader;
import lightning.sample.AttributeArbitraries;
import lightning.sample.PythonPrograms;
import lightning.scene.Scene;
import lightning.scene.light.Falloff;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.shot.AnimatedScene;
import lightning.scene.value.Attenuation;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Written layers, alone and over their stage, by the validators of usd-core. */
class UsdValidationTest {
    private static final int RIGS = 40;
    @TempDir
    private Path folder;

    @BeforeEach
    void requireUsd() throws IOException {
        PythonPrograms.require("pxr");
        for (String name : List.of("validate.py", "sparse.usda")) {
            try (InputStream in = UsdValidationTest.class.getResourceAsStream(name)) {
                Files.copy(in, folder.resolve(name));
            }
        }
    }

    private void assertValid(List<String> files) throws IOException {
        List<String> arguments = new ArrayList<>(List.of("validate.py"));
        arguments.addAll(files);
        assertThat(PythonPrograms.script(folder, arguments).lines().toList()).isEqualTo(Collections.nCopies(files.size(), "checked"));
    }

    private String exported(String name, String text, AnimatedScene scene, Path sceneFile) throws IOException {
        Path layer = folder.resolve(name);
        Files.write(layer, LightExport.toUsd(text, scene, sceneFile, layer).bytes());
        return name;
    }

    private static List<Light> randomLights(int count) {
        return AttributeArbitraries.lights().map(change -> change.after().withGobo(Optional.empty()).withProfile(Optional.empty())
                .withTexture(Optional.empty()).retainLinks(_ -> false)).list().ofSize(count).sample();
    }

    @Test
    void intensityBeyondAllFloats_isLimitedWithANote() throws Exception {
        Scene empty = JenReader.read(Path.of("scenes/bird.jen")).scene();
        Light light = Light.of("key", LightType.POINT).withIntensity(1e30).withFalloff(Falloff.CUSTOM)
                .withAttenuation(new Attenuation(0, 0, 1e-12));
        Path layer = folder.resolve("large.usda");
        ExportedLights export = LightExport.toUsd("", AnimatedScene.of(empty.withLights(List.of(light))), folder.resolve("a.jen"), layer);
        Files.write(layer, export.bytes());
        assertThat(export.notes()).containsEntry("values that no float can have, limited", 1);
        assertValid(List.of("large.usda"));
    }

    @Test
    void lightsOfShippedScenes_areValid() throws Exception {
        List<String> files = new ArrayList<>();
        try (Stream<Path> scenes = Files.list(Path.of("scenes"))) {
            for (Path scene : scenes.filter(file -> file.toString().endsWith(".jen")).sorted().toList()) {
                JenDocument document = JenReader.read(scene);
                files.add(exported(scene.getFileName() + ".usda", document.text(), document.animatedScene(), scene));
            }
        }
        assertThat(files).hasSizeGreaterThan(10);
        assertValid(files);
    }

    @Test
    void lightsOfRandomRigs_areValid() throws Exception {
        List<String> files = new ArrayList<>();
        Scene empty = JenReader.read(Path.of("scenes/bird.jen")).scene();
        for (int i = 0; i < RIGS; i++) {
            List<Light> lights = randomLights(4);
            List<Light> named = new ArrayList<>();
            for (int l = 0; l < lights.size(); l++) {
                // Names that are no identifiers, and that are the same as identifiers.
                named.add(lights.get(l).withName(List.of("1 ä", "1 ö", "key/light", "Key").get(l)));
            }
            files.add(exported("rig" + i + ".usda", "", AnimatedScene.of(empty.withLights(named)), folder.resolve("rig.jen")));
        }
        assertValid(files);
    }

    @Test
    void randomEditsOfAStage_areValidOverIt() throws Exception {
        Path sceneFile = folder.resolve("sparse.jen");
        SceneImporter.read(folder.resolve("sparse.usda"), sceneFile, LightUnits.CANDELA, Progress.NONE).write();
        JenDocument document = JenReader.read(sceneFile);
        List<Light> imported = document.scene().lights();
        List<String> files = new ArrayList<>();
        for (int i = 0; i < RIGS; i++) {
            List<Light> edits = randomLights(imported.size());
            List<Light> lights = new ArrayList<>();
            // One is deleted, and one is new.
            for (int l = i % 2; l < imported.size(); l++) {
                lights.add(edits.get(l).withName(imported.get(l).name()));
            }
            lights.add(Light.of("new", LightType.values()[i % LightType.values().length]));
            exported("edit" + i + ".usda", document.text(), new AnimatedScene(document.scene().withLights(lights), Optional.empty()),
                    sceneFile);
            Files.writeString(folder.resolve("composed" + i + ".usda"), "#usda 1.0\n(\ndefaultPrim = \"World\"\nupAxis = \"Z\"\n"
                    + "metersPerUnit = 0.01\nsubLayers = [@edit" + i + ".usda@, @sparse.usda@]\n)\n");
            files.add("composed" + i + ".usda");
        }
        assertValid(files);
    }
}
