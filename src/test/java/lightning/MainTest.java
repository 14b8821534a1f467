package lightning;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class MainTest {
    @Test
    void noArgumentsOrALoneScene_nameTheEditor() {
        assertThat(Main.namesTheEditor()).isTrue();
        assertThat(Main.namesTheEditor("scenes/bird.jen")).isTrue();
    }

    @Test
    void fileThatTheEditorMakesASceneOf_namesIt_withOrWithoutTheWord() {
        for (String file : new String[] {"a.gltf", "a.glb", "a.obj", "a.ply", "a.nff", "A.GLB", "a.jen"}) {
            assertThat(Main.namesTheEditor(file)).as(file).isTrue();
            assertThat(Main.namesTheEditor("edit", file)).as(file).isTrue();
        }
        assertThat(Main.namesTheEditor("edit")).isTrue();
        assertThat(Main.namesTheEditor("edit", "--help")).isFalse();
        assertThat(Main.namesTheEditor("edit", "a.png")).isFalse();
        assertThat(Main.namesTheEditor("edit", "a.jen", "b.jen")).isFalse();
    }

    @Test
    void everythingElse_namesACommand() {
        assertThat(Main.namesTheEditor("render", "scenes/bird.jen")).isFalse();
        assertThat(Main.namesTheEditor("--help")).isFalse();
        assertThat(Main.namesTheEditor("a.jen", "b.jen")).isFalse();
        assertThat(Main.namesTheEditor("bird")).isFalse();
        assertThat(Main.namesTheEditor("--x=a.jen")).isFalse();
    }
}
