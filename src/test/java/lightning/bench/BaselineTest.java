package lightning.bench;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;

class BaselineTest {
    private static Results results(SceneResult... scenes) {
        return new Results(Sample.RUN, List.of(scenes), List.of(), List.of(), List.of(), List.of(), List.of());
    }

    private static Baseline compare(SceneResult old, SceneResult now) {
        return Baseline.compare(results(old), results(now));
    }

    @Test
    void sameResults_areNotWorse() {
        assertThat(compare(Sample.scene(5), Sample.scene(5))).isEqualTo(new Baseline(2, List.of()));
    }

    @Test
    void quartilesApartAndMuchMore_isSlower() {
        assertThat(compare(Sample.scene(0, 4, 5, 6), Sample.scene(0, 6, 7, 8)).worse())
                .containsExactly("slower: bird at 300x200, color, sun: color 1 1 1 → 1 0 0, on yes → no, exact: 7.00 ms, was 5.00 (+40 %)");
    }

    @Test
    void overlappingQuartiles_areNoise() {
        assertThat(compare(Sample.scene(0, 3, 5, 11), Sample.scene(0, 6, 7, 9)).worse()).isEmpty();
    }

    @Test
    void littleMore_isNoiseHoweverSteady() {
        assertThat(compare(Sample.scene(0, 5, 5, 5), Sample.scene(0, 5.4, 5.4, 5.4)).worse()).isEmpty();
        assertThat(compare(Sample.scene(0, 5, 5, 5), Sample.scene(0, 5.6, 5.6, 5.6)).worse()).hasSize(1);
    }

    @Test
    void machineThatIsSlowerAsAWhole_isToldOnce() {
        SceneResult old = Sample.scene(0, 5, 5, 5);
        assertThat(compare(old, Sample.scene(Sample.samples(40, 40, 40), 0, 10, 10, 10)).worse()).containsExactly(
                "slower: bird at 300x200, color, sun: color 1 1 1 → 1 0 0, on yes → no, full trace: 40.0 ms, was 20.0 (+100 %)");
        assertThat(compare(old, Sample.scene(Sample.samples(40, 40, 40), 0, 20, 20, 20)).worse()).hasSize(2);
        assertThat(compare(old, Sample.scene(Sample.samples(10, 10, 10), 0, 5, 5, 5)).worse()).isEmpty();
    }

    @Test
    void faster_isNotWorse() {
        assertThat(compare(Sample.scene(0, 5, 5, 5), Sample.scene(0, 1, 1, 1)).worse()).isEmpty();
    }

    @Test
    void anyLargerError_isLessAccurate() {
        List<String> worse = compare(Sample.scene(0, 5, 5, 5), Sample.scene(1e-9, 5, 5, 5)).worse();
        assertThat(worse).hasSize(1);
        assertThat(worse.getFirst())
                .startsWith("less accurate: bird at 300x200, color, sun: color 1 1 1 → 1 0 0, on yes → no, exact: values that differ 1")
                .contains("largest difference 1.00000e-09, was 0.00000");
        assertThat(compare(Sample.scene(1e-9, 5, 5, 5), Sample.scene(0, 5, 5, 5)).worse()).isEmpty();
    }

    @Test
    void otherScenes_areNotCompared() {
        SceneResult bird = Sample.scene(5);
        SceneResult other = new SceneResult("house", bird.width(), bird.height(), bird.depth(), bird.shapes(), bird.lights(), null, null,
                bird.edits(), List.of(), null, null);
        SceneResult larger = new SceneResult("bird", 301, bird.height(), bird.depth(), bird.shapes(), bird.lights(), null, null,
                bird.edits(), List.of(), null, null);
        assertThat(Baseline.compare(results(other, larger), results(bird)).compared()).isZero();
        assertThat(Baseline.compare(results(other, bird), results(bird)).compared()).isEqualTo(2);
    }
}
