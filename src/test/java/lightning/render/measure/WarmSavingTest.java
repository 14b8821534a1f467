package lightning.render.measure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.concurrent.atomic.AtomicInteger;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.bench.accuracy.SceneFiles;
import lightning.render.RenderOptions;
import lightning.render.cache.PixelCache;
import lightning.render.relight.Renderer;
import lightning.render.relight.UpdateResult;
import lightning.render.relight.plan.UpdatePlan;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

class WarmSavingTest {
    private static final RenderOptions OPTIONS = RenderOptions.DEFAULT.withThreads(1);
    private static final double MAX_WARM_UP_MS = 60_000;

    private final Scene before = SceneFiles.read("bird", 64);
    private final Light light = before.light("lamp").orElseThrow();
    private final Scene after = before.withLight(light.withIntensity(0.3 * light.intensity()));
    private final Renderer renderer = new Renderer(OPTIONS);
    private final WorkerPool workers = new WorkerPool(1);

    @AfterEach
    void close() {
        renderer.close();
        workers.close();
    }

    private Optional<WarmSaving.RepeatableEdit> edit(Scene target, WarmSaving.UpdateStep step) {
        PixelCache start = renderer.state().hasPicture() ? renderer.cache() : null;
        return WarmSaving.RepeatableEdit.of(renderer.render(target, Progress.NONE), start, OPTIONS, step);
    }

    private Optional<WarmSaving.RepeatableEdit> edit(Scene target) {
        return edit(target, (r, progress) -> r.render(target, progress));
    }

    @Test
    void update_isRepeatedFromStartCache() {
        edit(before);
        AtomicInteger times = new AtomicInteger();
        WarmSaving.RepeatableEdit edit = edit(after, (r, progress) -> {
            times.incrementAndGet();
            UpdateResult again = r.render(after, progress);
            assertThat(again.plan().description()).isEqualTo("lamp: weight, reflections");
            return again;
        }).orElseThrow();
        WarmSaving saving = WarmSaving.measure(edit, workers, MAX_WARM_UP_MS, Progress.NONE).orElseThrow();
        assertThat(times.get()).isGreaterThan(saving.update().milliseconds().size());
        assertThat(saving.full().milliseconds()).hasSameSizeAs(saving.update().milliseconds());
        assertThat(saving.percent()).isEqualTo(saving.update().percentSavedOf(saving.full().median()));
    }

    @Test
    void saving_belongsOnlyToItsUpdate() {
        edit(before);
        WarmSaving.RepeatableEdit edit = edit(after).orElseThrow();
        WarmSaving saving = WarmSaving.measure(edit, workers, MAX_WARM_UP_MS, Progress.NONE).orElseThrow();
        UpdateResult made = edit.update();
        assertThat(saving.isOf(made)).isTrue();
        assertThat(saving.isOf(new UpdateResult(made.plan(), made.rowsTouched(), made.rowsComposed(), made.bytesMoved(), made.rays(),
                made.nanoseconds(), made.errorBound(), made.wasRefreshed()))).isFalse();
    }

    @Test
    void firstPassAndNoUpdate_haveNoSaving() {
        assertThat(edit(before)).isEmpty();
        assertThat(edit(before)).isEmpty();
        Scene larger = before.withPicture(before.picture().withSize(70, 70));
        assertThat(edit(larger)).as("different image").isEmpty();
        assertThat(renderer.plan(larger).update()).isInstanceOf(UpdatePlan.Nothing.class);
    }

    @Test
    void unsteadyTimes_giveNoSaving() {
        edit(before);
        assertThat(WarmSaving.measure(edit(after).orElseThrow(), workers, 0, Progress.NONE)).isEmpty();
    }

    @Test
    void canceledMeasurement_stops() {
        edit(before);
        WarmSaving.RepeatableEdit edit = edit(after).orElseThrow();
        Progress stop = new Progress() {
            @Override
            public void report(int done, int total) {}

            @Override
            public boolean isCanceled() {
                return true;
            }
        };
        assertThatThrownBy(() -> WarmSaving.measure(edit, workers, MAX_WARM_UP_MS, stop)).isInstanceOf(CancellationException.class);
    }
}
