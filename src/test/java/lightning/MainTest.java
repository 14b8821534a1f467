package lightning;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;

class MainTest {
    @Test
    void noArgumentsOrSingleScene_openEditor() {
        assertThat(Main.opensEditor()).isTrue();
        assertThat(Main.opensEditor("scenes/bird.jen")).isTrue();
    }

    @Test
    void importableFile_opensEditor() {
        for (String file : new String[] {"a.gltf", "a.glb", "a.obj", "a.ply", "a.nff", "A.GLB", "a.jen"}) {
            assertThat(Main.opensEditor(file)).as(file).isTrue();
            assertThat(Main.opensEditor("edit", file)).as(file).isTrue();
        }
        assertThat(Main.opensEditor("edit")).isTrue();
        assertThat(Main.opensEditor("edit", "--help")).isFalse();
        assertThat(Main.opensEditor("edit", "a.png")).isFalse();
        assertThat(Main.opensEditor("edit", "a.jen", "b.jen")).isFalse();
    }

    @Test
    void withoutDisplay_messageNamesTheCommands() {
        assertThat(Main.withoutWindow("no display", List.of())).startsWith("lightning: no display\n")
                .contains("lightning render scenes/bird.jen", "lightning tour scenes/bird.jen", "lightning --help").hasLineCount(5);
        assertThat(Main.withoutWindow("no display", List.of("my.jen"))).contains("lightning tour my.jen");
        assertThat(Main.withoutWindow("no display", List.of("my.glb"))).contains("lightning import").hasLineCount(2);
    }

    @Test
    void otherArguments_runCommand() {
        assertThat(Main.opensEditor("render", "scenes/bird.jen")).isFalse();
        assertThat(Main.opensEditor("--help")).isFalse();
        assertThat(Main.opensEditor("a.jen", "b.jen")).isFalse();
        assertThat(Main.opensEditor("bird")).isFalse();
        assertThat(Main.opensEditor("--x=a.jen")).isFalse();
    }
}
