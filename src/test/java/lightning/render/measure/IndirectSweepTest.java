package lightning.render.measure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.concurrent.CancellationException;
import lightning.base.work.Progress;
import lightning.render.relight.tile.RenderOptions;
import lightning.sample.IndirectScenes;
import lightning.sample.ProgressRecorder;
import lightning.scene.Scene;
import org.junit.jupiter.api.Test;

class IndirectSweepTest {
    private static final RenderOptions OPTIONS = RenderOptions.DEFAULT.withThreads(1);

    private final Scene scene = IndirectScenes.all().get("room");

    @Test
    void settings_areComparedWithTheDensest() {
        var progress = new ProgressRecorder();
        IndirectSweep sweep = IndirectSweep.measure(scene, OPTIONS, progress);
        assertThat(sweep.points()).hasSize(9).allMatch(IndirectSweep.Point::fits).allMatch(p -> p.milliseconds() > 0);
        assertThat(sweep.points()).allMatch(p -> p.settings().bounces() == scene.picture().indirect().orElseThrow().bounces());
        assertThat(sweep.points().getLast().meanDifference()).isZero();
        assertThat(sweep.points().getFirst().meanDifference()).isPositive();
        assertThat(progress.shares()).isSorted().endsWith(1.0);
    }

    @Test
    void settingsThatDoNotFit_areMarked() {
        IndirectSweep sweep = IndirectSweep.measure(scene.withPicture(scene.picture().withSize(200, 150)), OPTIONS.withMemory(6_000_000),
                Progress.NONE);
        assertThat(sweep.points()).anyMatch(IndirectSweep.Point::fits).anyMatch(p -> !p.fits());
    }

    @Test
    void cancellation_endsIt() {
        assertThatThrownBy(() -> IndirectSweep.measure(scene, OPTIONS, Progress.cancellation(() -> true)))
                .isInstanceOf(CancellationException.class);
    }
}
