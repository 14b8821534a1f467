package lightning.bench.accuracy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.concurrent.atomic.AtomicInteger;
import lightning.base.work.Progress;
import lightning.base.work.Workers;
import lightning.render.cache.PixelCache;
import lightning.render.relight.Renderer;
import lightning.render.relight.Update;
import lightning.render.relight.plan.UpdatePlan;
import lightning.render.relight.tile.Options;
import lightning.scene.Light;
import lightning.scene.Scene;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

class WarmSavingTest {
    private static final Options OPTIONS = Options.DEFAULT.withThreads(1);
    private static final double PATIENCE_MS = 60_000;

    private final Scene before = SceneFiles.read("bird", 64);
    private final Light lamp = before.light("lamp").orElseThrow();
    private final Scene after = before.withLight(lamp.withIntensity(0.3 * lamp.intensity()));
    private final Renderer renderer = new Renderer(OPTIONS);
    private final Workers workers = new Workers(1);

    @AfterEach
    void close() {
        renderer.close();
        workers.close();
    }

    private Optional<WarmSaving.Edit> edit(Scene wanted, WarmSaving.Step step) {
        PixelCache start = renderer.hasPicture() ? renderer.cache() : null;
        return WarmSaving.Edit.of(renderer.render(wanted, Progress.NONE), start, OPTIONS, step);
    }

    private Optional<WarmSaving.Edit> edit(Scene wanted) {
        return edit(wanted, (r, progress) -> r.render(wanted, progress));
    }

    @Test
    void updateIsMadeAgainFromWhatWasKnownBeforeIt() {
        edit(before);
        AtomicInteger times = new AtomicInteger();
        WarmSaving.Edit edit = edit(after, (r, progress) -> {
            times.incrementAndGet();
            Update again = r.render(after, progress);
            assertThat(again.plan().text()).isEqualTo("lamp: weight, reflections");
            return again;
        }).orElseThrow();
        WarmSaving saving = WarmSaving.measure(edit, workers, PATIENCE_MS, Progress.NONE).orElseThrow();
        assertThat(times.get()).isGreaterThan(saving.update().milliseconds().size());
        assertThat(saving.full().milliseconds()).hasSameSizeAs(saving.update().milliseconds());
        assertThat(saving.percent()).isEqualTo(saving.update().savingOf(saving.full().median()));
    }

    @Test
    void saving_isOfItsUpdateAloneAndNoOtherThatDidTheSame() {
        edit(before);
        WarmSaving.Edit edit = edit(after).orElseThrow();
        WarmSaving saving = WarmSaving.measure(edit, workers, PATIENCE_MS, Progress.NONE).orElseThrow();
        Update made = edit.made();
        assertThat(saving.isOf(made)).isTrue();
        assertThat(saving.isOf(new Update(made.plan(), made.rowsTouched(), made.rowsComposed(), made.bytesMoved(), made.rays(),
                made.nanoseconds(), made.errorBound(), made.refreshed()))).isFalse();
    }

    @Test
    void firstPassAndNothing_saveNothing() {
        assertThat(edit(before)).isEmpty();
        assertThat(edit(before)).isEmpty();
        Scene larger = before.withPicture(before.picture().withSize(70, 70));
        assertThat(edit(larger)).as("another picture").isEmpty();
        assertThat(renderer.plan(larger).update()).isInstanceOf(UpdatePlan.Nothing.class);
    }

    @Test
    void timesThatDoNotComeToRest_areNoSaving() {
        edit(before);
        assertThat(WarmSaving.measure(edit(after).orElseThrow(), workers, 0, Progress.NONE)).isEmpty();
    }

    @Test
    void cancelledMeasuring_stops() {
        edit(before);
        WarmSaving.Edit edit = edit(after).orElseThrow();
        Progress stop = new Progress() {
            @Override
            public void tiles(int done, int total) {}

            @Override
            public boolean isCancelled() {
                return true;
            }
        };
        assertThatThrownBy(() -> WarmSaving.measure(edit, workers, PATIENCE_MS, stop)).isInstanceOf(CancellationException.class);
    }
}
