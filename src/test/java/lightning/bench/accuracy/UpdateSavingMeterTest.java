package lightning.bench.accuracy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Arrays;
import java.util.Map;
import lightning.base.work.Progress;
import lightning.render.RenderOptions;
import lightning.render.gather.GatherRays;
import lightning.render.measure.Timing;
import lightning.render.relight.Renderer;
import lightning.render.relight.UpdateResult;
import lightning.render.relight.paper.Accuracy;
import lightning.render.relight.paper.ReflectionMode;
import lightning.render.relight.plan.UpdatePlan;
import lightning.render.shading.RayCounts;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class UpdateSavingMeterTest {
    private final Scene before = SceneFiles.read("bird", 48);
    private final Light light = before.light("lamp").orElseThrow();
    private final Scene after = before.withLight(light.withPosition(light.position().times(0.5)).withIntensity(2));

    @ParameterizedTest
    @EnumSource(Accuracy.class)
    void update_isVerifiedAndShownByRenderer(Accuracy accuracy) {
        RenderOptions options = RenderOptions.DEFAULT.withThreads(2).withAccuracy(accuracy);
        try (UpdateSavingMeter meter = new UpdateSavingMeter(options, 1); Renderer renderer = new Renderer(options)) {
            UpdateSaving saving = meter.update(before, after, Progress.NONE);
            renderer.render(before, Progress.NONE);
            UpdateResult update = renderer.render(after, Progress.NONE);
            assertThat(saving.update().plan()).isEqualTo(update.plan());
            assertThat(saving.update().rays()).isEqualTo(update.rays());
            assertThat(saving.update().rowsTouched()).isEqualTo(update.rowsTouched());
            assertThat(saving.fullRays().eye()).isEqualTo(48 * 48);
            assertThat(saving.isVerified()).isTrue();
            assertThat(meter.renderer().scene()).isEqualTo(after);
        }
    }

    private static Timing ms(double... samples) {
        return new Timing(Arrays.stream(samples).boxed().toList());
    }

    @Test
    void percent_isRelativeToFullTrace() {
        assertThat(new UpdateSaving(null, ms(5), ms(20), RayCounts.NONE, 1, true, true).percent()).isEqualTo(75);
        assertThat(new FirstPassCost(ms(22), ms(20), 7, 10, 1250, 1, true).bytesPerRow()).isEqualTo(125);
        assertThat(new FirstPassCost(ms(25), ms(20), 7, 10, 1250, 1, true).percentSlower()).isEqualTo(25);
        assertThat(new FirstPassCost(ms(25), ms(20), 7, 10, 1250, 1, true).percentAtMemoryLimit()).isEqualTo(5);
    }

    /** Checks that a quarter of the rays takes at least 5 of 20 ms, and 1600 bytes at 200 per millisecond take 8. */
    @Test
    void maxPercent_isLimitedByRaysOrMemory() {
        RayCounts all = new RayCounts(100, 0, GatherRays.NONE, Map.of("key", 300L));
        assertThat(UpdateSaving.maxPercent(update(RayCounts.ofShadows(Map.of("key", 100L)), 0), 20, all, 200)).isEqualTo(75);
        assertThat(UpdateSaving.maxPercent(update(RayCounts.ofShadows(Map.of("key", 100L)), 1600), 20, all, 200)).isEqualTo(60);
    }

    private static UpdateResult update(RayCounts rays, long bytes) {
        return new UpdateResult(new UpdatePlan.Nothing(), 0, 0, bytes, rays, 0, 0, false);
    }

    @Test
    void firstPass_countsCachedRowsAndBytes() {
        try (UpdateSavingMeter meter = new UpdateSavingMeter(RenderOptions.DEFAULT.withThreads(2), 2);
                Renderer renderer = new Renderer(RenderOptions.DEFAULT)) {
            FirstPassCost cost = meter.firstPass(before, Progress.NONE);
            renderer.render(before, Progress.NONE);
            assertThat(cost.rows()).isEqualTo(renderer.cache().rowCount());
            assertThat(cost.bytes()).isEqualTo(renderer.cache().bytes());
            assertThat(cost.first().median()).isPositive();
            assertThat(cost.full().median()).isPositive();
        }
    }

    @Test
    void reflections_areUpdatedAndVerified() {
        try (UpdateSavingMeter meter =
                new UpdateSavingMeter(RenderOptions.DEFAULT.withReflections(ReflectionMode.STALE).withThreads(2), 1)) {
            UpdateSaving saving = meter.reflections(before, after, Progress.NONE);
            assertThat(saving.update().plan().description()).isEqualTo("reflections");
            assertThat(saving.isVerified()).isTrue();
            assertThat(meter.renderer().cache().hasCurrentReflections()).isTrue();
        }
    }

    @Test
    void rival_runsInterleaved() throws Exception {
        try (UpdateSavingMeter meter = new UpdateSavingMeter(RenderOptions.DEFAULT.withThreads(2), 3)) {
            double[] next = {0};
            RivalTiming times = meter.compareWith(before, () -> next[0]++, Progress.NONE);
            assertThat(times.full().milliseconds()).hasSize(3);
            assertThat(times.rival().milliseconds()).containsExactly(next[0] - 3, next[0] - 2, next[0] - 1);
            assertThat(times.ratio()).isEqualTo((next[0] - 2) / times.full().median());
        }
    }

    @Test
    void zeroRepetitions_areRejected() {
        assertThatThrownBy(() -> new UpdateSavingMeter(RenderOptions.DEFAULT, 0)).isInstanceOf(IllegalArgumentException.class)
                .hasMessage("number of repetitions: expected ≥ 1, found 0");
    }
}
