package lightning.bench.result;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;

class BaselineComparisonTest {
    private static BenchResults results(SceneResult... scenes) {
        return new BenchResults(SampleResults.RUN, List.of(scenes), List.of(), List.of(), List.of(), List.of(), List.of(), List.of());
    }

    private static BaselineComparison compare(SceneResult old, SceneResult now) {
        return BaselineComparison.compare(results(old), results(now));
    }

    @Test
    void sameResults_areNotWorse() {
        assertThat(compare(SampleResults.scene(5), SampleResults.scene(5))).isEqualTo(new BaselineComparison(2, List.of()));
    }

    @Test
    void separateQuartilesAndLargeIncrease_isSlower() {
        assertThat(compare(SampleResults.scene(0, 4, 5, 6), SampleResults.scene(0, 6, 7, 8)).worse())
                .containsExactly("slower: bird at 300x200, color, sun: color 1 1 1 → 1 0 0, on yes → no, exact: 7.00 ms, was 5.00 (+40 %)");
    }

    @Test
    void overlappingQuartiles_areNoise() {
        assertThat(compare(SampleResults.scene(0, 3, 5, 11), SampleResults.scene(0, 6, 7, 9)).worse()).isEmpty();
    }

    @Test
    void smallIncrease_isNoise() {
        assertThat(compare(SampleResults.scene(0, 5, 5, 5), SampleResults.scene(0, 5.4, 5.4, 5.4)).worse()).isEmpty();
        assertThat(compare(SampleResults.scene(0, 5, 5, 5), SampleResults.scene(0, 5.6, 5.6, 5.6)).worse()).hasSize(1);
    }

    @Test
    void slowerMachine_isReportedOnce() {
        SceneResult old = SampleResults.scene(0, 5, 5, 5);
        assertThat(compare(old, SampleResults.scene(SampleResults.samples(40, 40, 40), 0, 10, 10, 10)).worse()).containsExactly(
                "slower: bird at 300x200, color, sun: color 1 1 1 → 1 0 0, on yes → no, full trace: 40.0 ms, was 20.0 (+100 %)");
        assertThat(compare(old, SampleResults.scene(SampleResults.samples(40, 40, 40), 0, 20, 20, 20)).worse()).hasSize(2);
        assertThat(compare(old, SampleResults.scene(SampleResults.samples(10, 10, 10), 0, 5, 5, 5)).worse()).isEmpty();
    }

    @Test
    void faster_isNotWorse() {
        assertThat(compare(SampleResults.scene(0, 5, 5, 5), SampleResults.scene(0, 1, 1, 1)).worse()).isEmpty();
    }

    @Test
    void largerError_isLessAccurate() {
        List<String> worse = compare(SampleResults.scene(0, 5, 5, 5), SampleResults.scene(1e-9, 5, 5, 5)).worse();
        assertThat(worse).hasSize(1);
        assertThat(worse.getFirst())
                .startsWith("less accurate: bird at 300x200, color, sun: color 1 1 1 → 1 0 0, on yes → no, exact: differing values 1")
                .contains("maximum difference 1.00000e-09, was 0.00000");
        assertThat(compare(SampleResults.scene(1e-9, 5, 5, 5), SampleResults.scene(0, 5, 5, 5)).worse()).isEmpty();
    }

    @Test
    void otherScenes_areNotCompared() {
        SceneResult bird = SampleResults.scene(5);
        SceneResult other = new SceneResult("house", bird.width(), bird.height(), bird.depth(), bird.shapes(), bird.lights(), null, null,
                bird.edits(), List.of(), null, null);
        SceneResult larger = new SceneResult("bird", 301, bird.height(), bird.depth(), bird.shapes(), bird.lights(), null, null,
                bird.edits(), List.of(), null, null);
        assertThat(BaselineComparison.compare(results(other, larger), results(bird)).compared()).isZero();
        assertThat(BaselineComparison.compare(results(other, bird), results(bird)).compared()).isEqualTo(2);
    }
}
