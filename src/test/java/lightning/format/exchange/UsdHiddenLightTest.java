package lightning.format.exchange;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Set;
import lightning.base.work.Progress;
import lightning.format.exchange.assembly.ExportedLights;
import lightning.format.exchange.assembly.LightUnits;
import lightning.format.jen.JenDocument;
import lightning.format.jen.JenReader;
import lightning.sample.PythonPrograms;
import lightning.scene.Scene;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Lights that prims above them hide in the stage, switched on in the scene. */
class UsdHiddenLightTest {
    private static final String STAGE = """
            #usda 1.0
            (
                startTimeCode = 1
                endTimeCode = 9
            )
            def Xform "world"
            {
                def Cube "ground" {}
                def Xform "rig"
                {
                    token visibility = "invisible"
                    def SphereLight "a" {}
                    def Sphere "ball" {}
                    def Xform "sub"
                    {
                        def SphereLight "b" {}
                        def SphereLight "c" {}
                        def Cube "cube" {}
                    }
                    def "untyped"
                    {
                        def Cube "inUntyped" {}
                    }
                    def Xform "dark"
                    {
                        token visibility = "invisible"
                        def SphereLight "d" {}
                        def Cube "inDark" {}
                    }
                }
            }
            """;
    @TempDir
    private Path folder;
    private ExportedLights export = new ExportedLights(new byte[0], Map.of(), Map.of());

    @BeforeEach
    void requireUsd() throws IOException {
        PythonPrograms.require("pxr");
        try (InputStream in = UsdHiddenLightTest.class.getResourceAsStream("visible.py")) {
            Files.copy(in, folder.resolve("visible.py"));
        }
    }

    /** Returns the visible prims of the stage with a layer that switches lights on. */
    private List<String> visible(String stage, String... lights) throws Exception {
        Files.writeString(folder.resolve("shot.usda"), stage);
        Path file = folder.resolve("shot.jen");
        SceneImporter.read(folder.resolve("shot.usda"), file, LightUnits.CANDELA, Progress.NONE).write();
        JenDocument document = JenReader.read(file);
        Scene scene = document.scene();
        Scene edited = scene.withLights(
                scene.lights().stream().map(light -> Set.of(lights).contains(light.name()) ? light.withOn(true) : light).toList());
        Path layer = folder.resolve("lights.usda");
        export = LightExport.toUsd(document.text(), document.animatedScene().withScene(edited), file, layer);
        Files.write(layer, export.bytes());
        Files.writeString(folder.resolve("composed.usda"), "#usda 1.0\n(\nsubLayers = [@lights.usda@, @shot.usda@]\n)\n");
        return PythonPrograms.script(folder, List.of("visible.py", "composed.usda")).lines().toList();
    }

    @Test
    void nothingSwitchedOn_staysHidden() throws Exception {
        assertThat(visible(STAGE)).containsExactly("/world", "/world/ground");
        assertThat(new String(export.bytes(), StandardCharsets.UTF_8)).doesNotContain("visibility");
    }

    @Test
    void lightSwitchedOn_isAllThatShowsOfItsGroup() throws Exception {
        assertThat(visible(STAGE, "b")).containsExactly("/world", "/world/ground", "/world/rig", "/world/rig/sub", "/world/rig/sub/b");
        assertThat(export.notes()).containsEntry("lights that are on below hidden objects, which the layer shows without their other parts",
                1);
    }

    @Test
    void severalLights_shareTheirParents() throws Exception {
        assertThat(visible(STAGE, "a", "c", "d")).containsExactly("/world", "/world/ground", "/world/rig", "/world/rig/a",
                "/world/rig/sub", "/world/rig/sub/c", "/world/rig/dark", "/world/rig/dark/d");
    }

    @Test
    void lightInAHiddenInstance_isShownThereOnly() throws Exception {
        String instances = STAGE.replace("def Xform \"rig\"", "def Xform \"rig\" ( instanceable = true; prepend references = </copy> )\n{\n"
                + "token visibility = \"invisible\"\n}\ndef Xform \"second\" ( instanceable = true; prepend references = </copy> ) {}\n}\n"
                + "class Xform \"copy\"").replaceFirst("\\}\\s*$", "");
        assertThat(visible(instances, "a")).contains("/world/rig/a").doesNotContain("/world/rig/ball", "/world/second/ball",
                "/world/second/a");
    }

    @Test
    void parentHiddenAtSomeFrames_isNoted() throws Exception {
        String switched =
                STAGE.replaceFirst("token visibility = \"invisible\"",
                        "token visibility.timeSamples = { 1: \"invisible\", 5: \"inherited\" }");
        String note = "lights that are on, visible only when the stage shows the objects above them";
        visible(switched);
        assertThat(export.notes()).doesNotContainKey(note);
        visible(switched, "a");
        assertThat(export.notes()).containsEntry(note, 1);
    }

    @Test
    void parentOfManyObjects_isNoted() throws Exception {
        var cubes = new StringBuilder();
        for (int i = 0; i < 1001; i++) {
            cubes.append("def Cube \"cube").append(i).append("\" {}\n");
        }
        assertThat(visible(STAGE.replace("def Sphere \"ball\" {}", cubes), "a")).containsExactly("/world", "/world/ground");
        assertThat(export.notes()).containsEntry(
                "lights that are on, but hidden by an object above them that has too many parts to hide them one by one", 1);
    }
}
