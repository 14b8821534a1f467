package lightning.render.engine.choice;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.HashSet;
import java.util.Set;
import java.util.stream.IntStream;
import lightning.render.engine.Engine;
import lightning.sample.EngineMix;
import net.jqwik.api.Example;
import org.junit.jupiter.api.Test;

class EnginesTest {
    private static Set<Engine> asked() {
        Set<Engine> asked = new HashSet<>();
        IntStream.range(0, 100).forEach(tile -> asked.add(Engines.OF_PROCESS.forTile(tile)));
        return asked;
    }

    @Test
    void tests_runOnBothEngines() {
        assertThat(asked()).containsExactlyInAnyOrder(Engines.SCALAR, Engines.LANES);
    }

    @Example
    void properties_runOnBothEngines() {
        assertThat(asked()).containsExactlyInAnyOrder(Engines.SCALAR, Engines.LANES);
    }

    @Test
    void choiceOfTheProcess_holdsForAllWhoWereGivenItBefore() {
        try {
            Engines.use(_ -> Engines.LANES);
            assertThat(asked()).containsExactly(Engines.LANES);
        } finally {
            Engines.use(new EngineMix(2));
        }
    }
}
