package lightning.serve.resident;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import org.junit.jupiter.api.Test;

class SurroundingsTest {
    private static final String HASH = Surroundings.hash("program", "/a", Map.of("LANG", "de_DE.UTF-8"), "Umask: 0022");

    @Test
    void eachPart_changesTheHash() {
        assertThat(Surroundings.hash("newer", "/a", Map.of("LANG", "de_DE.UTF-8"), "Umask: 0022")).isNotEqualTo(HASH);
        assertThat(Surroundings.hash("program", "/b", Map.of("LANG", "de_DE.UTF-8"), "Umask: 0022")).isNotEqualTo(HASH);
        assertThat(Surroundings.hash("program", "/a", Map.of("LANG", "C"), "Umask: 0022")).isNotEqualTo(HASH);
        assertThat(Surroundings.hash("program", "/a", Map.of(), "Umask: 0022")).isNotEqualTo(HASH);
        assertThat(Surroundings.hash("program", "/a", Map.of("LANG", "de_DE.UTF-8"), "Umask: 0077")).isNotEqualTo(HASH);
    }

    @Test
    void variablesOfTheTerminal_changeNothing() {
        assertThat(Surroundings.hash("program", "/a", Map.of("LANG", "de_DE.UTF-8", "SHLVL", "3", "COLUMNS", "80"), "Umask: 0022"))
                .isEqualTo(HASH);
    }

    @Test
    void thisProcess_keepsItsHash() throws Exception {
        assertThat(Surroundings.ofThisProcess()).hasSize(64).isEqualTo(Surroundings.ofThisProcess());
    }
}
