package lightning.bench;

import static org.assertj.core.api.Assertions.assertThat;

import lightning.base.work.Progress;
import lightning.bench.result.DriftCurve;
import lightning.bench.result.DriftPoint;
import lightning.render.relight.paper.Accuracy;
import org.junit.jupiter.api.Test;

class DriftBenchTest {
    private static DriftCurve drift(long seed, int editCount) {
        NamedScene scene = new NamedScene("generated", GeneratedScenes.of(1, new PictureSize(300, 200), 10, 3, 2), null);
        return new DriftBench(scene, new PictureSize(24, 20), 1, seed).measure(editCount, Progress.NONE);
    }

    @Test
    void points_arePowersOfTen() {
        DriftCurve drift = drift(7, 150);
        assertThat(drift.points()).extracting(DriftPoint::edits).containsExactly(1, 1, 10, 10, 100, 100);
        assertThat(drift.points()).extracting(DriftPoint::accuracy).containsExactly(Accuracy.RATIO, Accuracy.EXACT, Accuracy.RATIO,
                Accuracy.EXACT, Accuracy.RATIO, Accuracy.EXACT);
        assertThat(drift.width()).isEqualTo(24);
    }

    @Test
    void exactHasNoError_ratioStaysWithinBound() {
        DriftCurve drift = drift(7, 100);
        assertThat(drift.points()).filteredOn(p -> p.accuracy() == Accuracy.EXACT).allSatisfy(p -> assertThat(p.error().values()).isZero());
        assertThat(drift.points()).filteredOn(p -> p.accuracy() == Accuracy.RATIO).allSatisfy(
                p -> assertThat(p.error().maxAbsolute()).isLessThanOrEqualTo(p.bound()));
        assertThat(drift.points().get(4).error().values()).isPositive();
    }

    @Test
    void sameSeed_givesSameDrift() {
        assertThat(drift(2, 10)).isEqualTo(drift(2, 10));
    }
}
