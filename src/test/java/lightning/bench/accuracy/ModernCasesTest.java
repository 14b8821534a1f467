package lightning.bench.accuracy;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import lightning.format.jen.JenReader;
import lightning.scene.Scene;
import lightning.scene.paper.PaperCase;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ModernCasesTest {
    private static Scene scene(String text) throws Exception {
        return JenReader.read("jen 1\n" + text, "m.jen", Path.of("")).scene();
    }

    private static PaperCase find(Scene scene, String name) {
        return ModernCases.of(scene).stream().filter(edit -> edit.name().equals(name)).findFirst().orElseThrow();
    }

    @ParameterizedTest
    @ValueSource(strings = {"product", "stage", "window", "hall", "softbox", "night", "arbor"})
    void modernScenes_haveEachKindOfEdit(String name) throws Exception {
        Scene scene = JenReader.read(Path.of("scenes", name + ".jen")).scene();
        List<String> missing = name.equals("softbox") ? List.of(ModernCases.CONE) : List.of();
        assertThat(ModernCases.of(scene)).extracting(PaperCase::name)
                .containsExactlyElementsOf(ModernCases.NAMES.stream().filter(edit -> !missing.contains(edit)).toList());
        assertThat(ModernCases.of(scene)).allSatisfy(edit -> {
            assertThat(edit.before()).isEqualTo(scene);
            assertThat(edit.after()).isNotEqualTo(scene);
        });
    }

    @Test
    void lightNamedKey_isEditedBeforeTheFirst() throws Exception {
        Scene scene = scene("light fill point { intensity 2 }\nlight key point { intensity 3 }");
        assertThat(find(scene, ModernCases.INTENSITY).value()).startsWith("key: ");
    }

    @Test
    void darkLights_areSkipped() throws Exception {
        Scene scene = scene("light key point { on no }\nlight black point { color 0 0 0 }\nlight lamp point { intensity 3 }");
        assertThat(find(scene, ModernCases.COLOR).value()).startsWith("lamp: ");
    }

    @Test
    void cone_isTheFirstSpots() throws Exception {
        Scene scene = scene("light key point { }\nlight spot1 spot { angle 180 }\nlight spot2 spot { angle 30 }");
        assertThat(find(scene, ModernCases.CONE).after().lights().get(2).angle()).isEqualTo(24);
    }

    @Test
    void sceneWithoutLightsAndObjects_hasNoCase() throws Exception {
        assertThat(ModernCases.of(scene(""))).isEmpty();
    }
}
