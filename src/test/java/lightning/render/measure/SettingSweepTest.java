package lightning.render.measure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.concurrent.CancellationException;
import lightning.base.work.Progress;
import lightning.render.RenderOptions;
import lightning.sample.IndirectScenes;
import lightning.sample.ProgressRecorder;
import lightning.scene.Scene;
import org.junit.jupiter.api.Test;

class SettingSweepTest {
    private static final RenderOptions OPTIONS = RenderOptions.DEFAULT.withThreads(1);

    private final Scene scene = IndirectScenes.all().get("room");

    @Test
    void settings_areComparedWithTheDensest() {
        var progress = new ProgressRecorder();
        SettingSweep sweep = SettingSweep.measure(SweptEffect.INDIRECT, scene, OPTIONS, progress);
        assertThat(sweep.points()).hasSize(9).allMatch(SettingSweep.Point::fits).allMatch(p -> p.milliseconds() > 0);
        assertThat(sweep.points()).allMatch(p -> p.setting().applyTo(scene).picture().indirect().orElseThrow().bounces() == scene.picture()
                .indirect().orElseThrow().bounces());
        assertThat(sweep.points().getLast().meanDifference()).isZero();
        assertThat(sweep.points().getFirst().meanDifference()).isPositive();
        assertThat(progress.shares()).isSorted().endsWith(1.0);
    }

    @Test
    void samplesOfAreaLights_areComparedWithTheMost() {
        SettingSweep sweep = SettingSweep.measure(SweptEffect.SOFT_SHADOWS, IndirectScenes.all().get("visible lights").withoutIndirect(),
                OPTIONS, Progress.NONE);
        assertThat(sweep.points()).extracting(SettingSweep.Point::setting).containsExactly(new SweptSetting.LightSamples(4),
                new SweptSetting.LightSamples(8), new SweptSetting.LightSamples(16), new SweptSetting.LightSamples(32),
                new SweptSetting.LightSamples(64));
        assertThat(sweep.points()).allMatch(SettingSweep.Point::fits);
        assertThat(sweep.points().getLast().meanDifference()).isZero();
        assertThat(sweep.points().getFirst().meanDifference()).isGreaterThan(sweep.points().get(3).meanDifference()).isPositive();
    }

    @Test
    void raysOfReflections_areComparedWithTheMost() {
        SettingSweep sweep = SettingSweep.measure(SweptEffect.BLURRED_REFLECTIONS, IndirectScenes.all().get("frosted glass"), OPTIONS,
                Progress.NONE);
        assertThat(sweep.points()).extracting(SettingSweep.Point::setting).containsExactly(new SweptSetting.ReflectionRays(4),
                new SweptSetting.ReflectionRays(16), new SweptSetting.ReflectionRays(64), new SweptSetting.ReflectionRays(256));
        assertThat(sweep.points()).allMatch(SettingSweep.Point::fits);
        assertThat(sweep.points().getLast().meanDifference()).isZero();
        assertThat(sweep.points().getFirst().meanDifference()).isGreaterThan(sweep.points().get(2).meanDifference()).isPositive();
    }

    @Test
    void sceneWithoutEffect_hasNothingToCompare() {
        assertThat(SweptEffect.BLURRED_REFLECTIONS.missingReason(scene)).isPresent();
        assertThat(SweptEffect.SOFT_SHADOWS.missingReason(scene)).isPresent();
        assertThat(SweptEffect.INDIRECT.missingReason(scene)).isEmpty();
    }

    @Test
    void settingsThatDoNotFit_areMarked() {
        SettingSweep sweep = SettingSweep.measure(SweptEffect.INDIRECT, scene.withPicture(scene.picture().withSize(200, 150)),
                OPTIONS.withMemory(6_000_000),
                Progress.NONE);
        assertThat(sweep.points()).anyMatch(SettingSweep.Point::fits).anyMatch(p -> !p.fits());
    }

    @Test
    void cancellation_endsIt() {
        assertThatThrownBy(() -> SettingSweep.measure(SweptEffect.INDIRECT, scene, OPTIONS, Progress.cancellation(() -> true)))
                .isInstanceOf(CancellationException.class);
    }
}
