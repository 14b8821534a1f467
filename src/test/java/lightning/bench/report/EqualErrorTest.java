package lightning.bench.report;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import lightning.bench.result.BenchResults;
import lightning.bench.result.ErrorCurve;
import lightning.bench.result.ErrorPoint;
import lightning.bench.result.ModernSampling;
import lightning.bench.result.ModernScene;
import lightning.bench.result.TimeSamples;
import org.junit.jupiter.api.Test;

class EqualErrorTest {
    private static final String OURS = ModernSampling.EDGES.label();
    private static final String THEIRS = ModernSampling.EDGES.povRayLabel();

    private static ErrorPoint point(String setting, double ms, double error) {
        return new ErrorPoint(setting, new TimeSamples(ms, ms, ms, List.of(ms)), error);
    }

    private static ModernScene scene(ErrorCurve... curves) {
        return new ModernScene("hall", List.of(), List.of(curves),
                List.of("light sun: its gobo is left out", "light sky: its gobo is left out"));
    }

    private static ErrorCurve curve(String program, ErrorPoint... points) {
        return new ErrorCurve(program, 256, 160, 90, List.of(points));
    }

    private final ModernScene scene =
            scene(curve("Lightning", point("none", 10, 0.06), point(OURS, 50, 0.01), point("every 4×4", 80, 0.005)),
                    curve("POV-Ray 3.7", point("-A", 60, 0.06), point(THEIRS, 600, 0.02)));

    @Test
    void fastestSettingThatIsAccurateEnough_isCompared() {
        EqualError atTheirs = EqualError.of(scene).getFirst();
        assertThat(atTheirs.target().setting()).isEqualTo(THEIRS);
        assertThat(atTheirs.other()).map(ErrorPoint::setting).hasValue(OURS);
        assertThat(atTheirs.timesAsFast()).isEqualTo(12);
    }

    @Test
    void withoutAccurateSetting_nothingIsClaimed() {
        EqualError atOurs = EqualError.of(scene).get(1);
        assertThat(atOurs.isOurs()).isTrue();
        assertThat(atOurs.other()).isEmpty();
        assertThat(atOurs.timesAsFast()).isNaN();
    }

    @Test
    void slowerProgram_isBelowOne() {
        ModernScene slow = scene(curve("Lightning", point(OURS, 300, 0.01)), curve("POV-Ray 3.7", point(THEIRS, 150, 0.01)));
        assertThat(EqualError.of(slow)).extracting(EqualError::timesAsFast).containsExactly(0.5, 0.5);
    }

    @Test
    void withoutPovRay_thereIsNoComparison() {
        assertThat(EqualError.of(scene(curve("Lightning", point(OURS, 300, 0.01))))).isEmpty();
    }

    @Test
    void tables_showComparisonAndCountRemarks() {
        ModernTables tables = new ModernTables(
                new BenchResults(null, List.of(), List.of(), List.of(), List.of(), List.of(), List.of(scene), List.of()));
        assertThat(tables.of("modern equal errors").lines().skip(2)).containsExactly(
                "| hall | POV-Ray 3.7 | `+A0.1 +AM2 +R3` | 0.0200 | 600 | `edges 4×4` | 0.0100 | 50.0 | 12.0 |",
                "| hall | Lightning | `edges 4×4` | 0.0100 | 50.0 | none | – | – | – |");
        assertThat(tables.of("modern remarks").lines().skip(2)).containsExactly("| hall | light: its gobo is left out | 2 |");
        assertThat(tables.of("modern findings")).contains("Lightning is 12.00 times as fast.",
                "No measured setting of POV-Ray's is as accurate on hall.");
    }
}
