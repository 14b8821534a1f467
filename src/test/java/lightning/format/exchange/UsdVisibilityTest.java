package lightning.format.exchange;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import lightning.base.work.Progress;
import lightning.format.exchange.assembly.ImportedScene;
import lightning.format.exchange.assembly.LightUnits;
import lightning.sample.PythonPrograms;
import lightning.scene.node.SceneNode;
import lightning.scene.shot.AnimatedScene;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What a stage shows: visibility, purposes, payloads and missing files; through usd-core. */
class UsdVisibilityTest {
    @TempDir
    private Path folder;

    @BeforeEach
    void requireUsd() {
        PythonPrograms.require("pxr");
    }

    private ImportedScene imported(String prims) throws Exception {
        Path stage = Files.writeString(folder.resolve("a.usda"), "#usda 1.0\n(\nstartTimeCode = 1\nendTimeCode = 10\n)\n" + prims);
        return SceneImporter.read(stage, folder.resolve("a.jen"), LightUnits.CANDELA, Progress.NONE);
    }

    private static List<String> hidden(ImportedScene imported) {
        return imported.scene().stage().nodes().stream().filter(node -> !node.visible()).map(SceneNode::name).toList();
    }

    @Test
    void hiddenRenderPurpose_isHidden() throws Exception {
        String purposes = """
                def Sphere "%s" ( prepend apiSchemas = ["VisibilityAPI"] )
                {
                    uniform token purpose = "%s"
                    uniform token renderVisibility = "%s"
                }
                """;
        assertThat(hidden(imported(String.format(Locale.ROOT, purposes.repeat(3), "shown", "render", "visible", "gone", "render",
                "invisible", "plain", "default", "invisible")))).containsExactly("gone");
    }

    @Test
    void guidesAndProxies_areNoted() throws Exception {
        ImportedScene imported = imported("""
                def Sphere "shown" {}
                def Xform "group"
                {
                    uniform token purpose = "proxy"
                    def Sphere "inside" {}
                }
                def Sphere "helper"
                {
                    uniform token purpose = "guide"
                }
                """);
        assertThat(imported.scene().stage().nodes()).extracting(SceneNode::name).containsExactly("shown");
        assertThat(imported.notes()).containsEntry("objects of purpose proxy", 1).containsEntry("objects of purpose guide", 1);
    }

    @Test
    void lightUnderAParentThatIsHiddenLater_isSwitchedThere() throws Exception {
        ImportedScene imported = imported("""
                def Xform "group"
                {
                    token visibility.timeSamples = { 1: "inherited", 5: "invisible" }
                    def SphereLight "lamp" {}
                }
                """);
        assertThat(imported.scene().lights().getFirst().on()).isTrue();
        var animated = new AnimatedScene(imported.scene(), imported.shot());
        assertThat(animated.sceneAt(4).lights().getFirst().on()).isTrue();
        assertThat(animated.sceneAt(5).lights().getFirst().on()).isFalse();
    }

    @Test
    void payload_isLoaded() throws Exception {
        Files.writeString(folder.resolve("b.usda"),
                "#usda 1.0\n(\ndefaultPrim = \"ball\"\n)\ndef Sphere \"ball\" {\ndouble radius = 3\n}\n");
        assertThat(imported("def \"thing\" ( prepend payload = @b.usda@ ) {}\n").scene().stage().nodes().getFirst().placement().scale().x())
                .isEqualTo(3);
    }

    @Test
    void filesThatAreMissing_areNamed() throws Exception {
        assertThat(imported("""
                def Sphere "ball" {}
                def "a" ( prepend payload = @gone.usda@ ) {}
                def "b" ( prepend references = @sub/none.usda@</x> ) {}
                def "c" ( prepend references = </nowhere> ) {}
                """).notes()).containsEntry("references that cannot be loaded: 'a.usda</nowhere>', 'gone.usda', 'none.usda'", 3);
    }
}
