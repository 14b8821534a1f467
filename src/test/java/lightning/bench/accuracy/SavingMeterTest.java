package lightning.bench.accuracy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Arrays;
import lightning.base.work.Progress;
import lightning.render.relight.Renderer;
import lightning.render.relight.Update;
import lightning.render.relight.plan.Accuracy;
import lightning.render.relight.plan.Reflections;
import lightning.render.relight.plan.UpdatePlan;
import lightning.render.relight.tile.Options;
import lightning.render.shading.TraceCounts;
import lightning.scene.Light;
import lightning.scene.Scene;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class SavingMeterTest {
    private final Scene before = SceneFiles.read("bird", 48);
    private final Light light = before.light("lamp").orElseThrow();
    private final Scene after = before.withLight(light.withPosition(light.position().times(0.5)).withIntensity(2));

    @ParameterizedTest
    @EnumSource(Accuracy.class)
    void update_isTheRenderersAndKept(Accuracy accuracy) {
        Options options = Options.DEFAULT.withThreads(2).withAccuracy(accuracy);
        try (SavingMeter meter = new SavingMeter(options, 1); Renderer renderer = new Renderer(options)) {
            Saving saving = meter.update(before, after, Progress.NONE);
            renderer.render(before, Progress.NONE);
            Update update = renderer.render(after, Progress.NONE);
            assertThat(saving.update().plan()).isEqualTo(update.plan());
            assertThat(saving.update().rays()).isEqualTo(update.rays());
            assertThat(saving.update().rowsTouched()).isEqualTo(update.rowsTouched());
            assertThat(saving.fullRays().eye()).isEqualTo(48 * 48);
            assertThat(saving.kept()).isTrue();
            assertThat(meter.renderer().scene()).isEqualTo(after);
        }
    }

    private static Timing ms(double... samples) {
        return new Timing(Arrays.stream(samples).boxed().toList());
    }

    @Test
    void percent_isOfTheFullTrace() {
        assertThat(new Saving(null, ms(5), ms(20), TraceCounts.NONE, 1, true, true).percent()).isEqualTo(75);
        assertThat(new FirstPassCost(ms(22), ms(20), 7, 10, 1250, 1, true).bytesPerRow()).isEqualTo(125);
        assertThat(new FirstPassCost(ms(25), ms(20), 7, 10, 1250, 1, true).percentSlower()).isEqualTo(25);
        assertThat(new FirstPassCost(ms(25), ms(20), 7, 10, 1250, 1, true).percentFloor()).isEqualTo(5);
    }

    /** A quarter of the rays takes 5 of 20 ms at least, 1600 bytes at 200 a millisecond take 8. */
    @Test
    void cap_isSetByRaysOrMemoryWhateverTakesLonger() {
        TraceCounts all = new TraceCounts(100, 0, 300);
        assertThat(Saving.cap(update(new TraceCounts(0, 0, 100), 0), 20, all, 200)).isEqualTo(75);
        assertThat(Saving.cap(update(new TraceCounts(0, 0, 100), 1600), 20, all, 200)).isEqualTo(60);
    }

    private static Update update(TraceCounts rays, long bytes) {
        return new Update(new UpdatePlan.Nothing(), 0, 0, bytes, rays, 0, 0, false);
    }

    @Test
    void firstPass_countsWhatIsKept() {
        try (SavingMeter meter = new SavingMeter(Options.DEFAULT.withThreads(2), 2); Renderer renderer = new Renderer(Options.DEFAULT)) {
            FirstPassCost cost = meter.firstPass(before, Progress.NONE);
            renderer.render(before, Progress.NONE);
            assertThat(cost.rows()).isEqualTo(renderer.cache().rowCount());
            assertThat(cost.bytes()).isEqualTo(renderer.cache().bytes());
            assertThat(cost.first().median()).isPositive();
            assertThat(cost.full().median()).isPositive();
        }
    }

    @Test
    void reflections_areUpdatedAndKept() {
        try (SavingMeter meter = new SavingMeter(Options.DEFAULT.withReflections(Reflections.STALE).withThreads(2), 1)) {
            Saving saving = meter.reflections(before, after, Progress.NONE);
            assertThat(saving.update().plan().text()).isEqualTo("reflections");
            assertThat(saving.kept()).isTrue();
            assertThat(meter.renderer().reflectionsAreCurrent()).isTrue();
        }
    }

    @Test
    void rival_isAskedInTurns() throws Exception {
        try (SavingMeter meter = new SavingMeter(Options.DEFAULT.withThreads(2), 3)) {
            double[] next = {0};
            TurnTimes times = meter.against(before, () -> next[0]++, Progress.NONE);
            assertThat(times.full().milliseconds()).hasSize(3);
            assertThat(times.rival().milliseconds()).containsExactly(next[0] - 3, next[0] - 2, next[0] - 1);
            assertThat(times.ratio()).isEqualTo((next[0] - 2) / times.full().median());
        }
    }

    @Test
    void noRepetitions_areRefused() {
        assertThatThrownBy(() -> new SavingMeter(Options.DEFAULT, 0)).isInstanceOf(IllegalArgumentException.class)
                .hasMessage("the number of repetitions must be ≥ 1, was 0");
    }
}
