package lightning.cli.option;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ResidentOptionTest {
    @ParameterizedTest
    @ValueSource(strings = {"render a.jen -o a.png --resident", "relight --resident a.jen", "shot render a.jen --resident"})
    void commandsWithTheOption_runInTheResidentProcess(String line) {
        assertThat(ResidentOption.appliesTo(List.of(line.split(" ")))).isTrue();
    }

    @ParameterizedTest
    @ValueSource(strings = {"render a.jen -o a.png", "serve --resident", "bench --resident", "--resident", "a.jen --resident",
        "shot relight a.jen --resident --cluster farm", "shot relight a.jen --cluster=farm --resident"})
    void otherCommands_runInTheirOwn(String line) {
        assertThat(ResidentOption.appliesTo(List.of(line.split(" ")))).isFalse();
    }

    @Test
    void option_isLeftOutOfTheLine() {
        assertThat(ResidentOption.without(List.of("render", "--resident", "a.jen"))).containsExactly("render", "a.jen");
    }
}
