package lightning.render.engine.choice;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.HashSet;
import java.util.Set;
import java.util.stream.IntStream;
import lightning.render.engine.Engine;
import lightning.sample.MixedEngineChoice;
import net.jqwik.api.Example;
import org.junit.jupiter.api.Test;

class EnginesTest {
    private static Set<Engine> currentEngine() {
        Set<Engine> asked = new HashSet<>();
        IntStream.range(0, 100).forEach(tile -> asked.add(Engines.CURRENT.forTile(tile)));
        return asked;
    }

    @Test
    void unitTests_runOnBothEngines() {
        assertThat(currentEngine()).containsExactlyInAnyOrder(Engines.SCALAR, Engines.LANES);
    }

    @Example
    void properties_runOnBothEngines() {
        assertThat(currentEngine()).containsExactlyInAnyOrder(Engines.SCALAR, Engines.LANES);
    }

    @Test
    void processChoice_appliesToEarlierReferences() {
        try {
            Engines.use(_ -> Engines.LANES);
            assertThat(currentEngine()).containsExactly(Engines.LANES);
        } finally {
            Engines.use(new MixedEngineChoice(2));
        }
    }
}
