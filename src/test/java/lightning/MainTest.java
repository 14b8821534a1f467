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
    void everythingElse_namesACommand() {
        assertThat(Main.namesTheEditor("render", "scenes/bird.jen")).isFalse();
        assertThat(Main.namesTheEditor("--help")).isFalse();
        assertThat(Main.namesTheEditor("a.jen", "b.jen")).isFalse();
        assertThat(Main.namesTheEditor("bird")).isFalse();
        assertThat(Main.namesTheEditor("--x=a.jen")).isFalse();
    }
}
