package lightning.cli.output;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import lightning.bench.accuracy.FirstPassCost;
import lightning.render.measure.Timing;
import org.junit.jupiter.api.Test;

class TourTableTest {
    private final ByteArrayOutputStream out = new ByteArrayOutputStream();
    private final TourTable table;

    TourTableTest() {
        var print = new PrintStream(out, true, StandardCharsets.UTF_8);
        table = new TourTable(new Console(print, print, false));
    }

    private String first(boolean warm) {
        out.reset();
        table.printFirstPass(new FirstPassCost(ms(30), ms(20), 7, 100, 5000, 1, warm), 40e6);
        return out.toString(StandardCharsets.UTF_8);
    }

    private static Timing ms(double ms) {
        return new Timing(List.of(ms));
    }

    @Test
    void coldTime_isMarked() {
        assertThat(first(false)).contains("caching costs 50.0 % (not warm)");
        assertThat(first(true)).contains("caching costs 50.0 % (the paper").doesNotContain("warm");
    }
}
