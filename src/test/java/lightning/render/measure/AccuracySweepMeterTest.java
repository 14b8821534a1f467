package lightning.render.measure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Arrays;
import java.util.EnumSet;
import java.util.List;
import java.util.concurrent.CancellationException;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.bench.accuracy.SceneFiles;
import lightning.render.RenderOptions;
import lightning.render.image.Film;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.scene.AntialiasMode;
import lightning.scene.PictureSettings;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.paper.PaperCase;
import lightning.scene.paper.PaperCases;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class AccuracySweepMeterTest {
    private final AccuracySweepMeter meter = new AccuracySweepMeter(2, 2, 0);
    private final Scene before = SceneFiles.read("bird", 41);
    private final Light light = before.light("lamp").orElseThrow();
    private final Scene dimmed = before.withLight(light.withIntensity(0.3 * light.intensity()));
    private final Scene moved = before.withLight(light.withPosition(light.position().plus(new Vec3(0.5, -0.5, 0.25))));

    @AfterEach
    void close() {
        meter.close();
    }

    @Test
    void sweep_hasEverySettingWithSamples() {
        AccuracySweep ladder = meter.measure(before, moved, Progress.NONE);
        assertThat(ladder.points()).extracting(SweepPoint::setting)
                .containsExactlyElementsOf(EnumSet.complementOf(EnumSet.of(AccuracySetting.FEW_SAMPLES, AccuracySetting.NO_ANTIALIASING)));
        assertThat(ladder.points()).allSatisfy(rung -> {
            assertThat(rung.time().milliseconds()).hasSize(2);
            assertThat(rung.film().width()).isEqualTo(41);
            assertThat(rung.film().height()).isEqualTo(41);
            assertThat(rung.error().of()).isEqualTo(3 * 41 * 41);
        });
        assertThat(ladder.fullRays().eye()).isEqualTo(41 * 41);
        assertThat(ladder.saving(AccuracySetting.FULL_TRACE)).isZero();
    }

    @Test
    void softLights_addFewSamplesSettingWithError() {
        Light large = moved.lights().getFirst();
        Scene soft = moved.withLight(large.withType(LightType.DISC).withArea(large.area().withRadius(1)));
        AccuracySweep ladder = meter.measure(soft, soft.withLight(soft.lights().getFirst().withIntensity(0.7)), Progress.NONE);
        assertThat(ladder.points()).extracting(SweepPoint::setting)
                .containsExactlyElementsOf(EnumSet.complementOf(EnumSet.of(AccuracySetting.NO_ANTIALIASING)));
        assertThat(ladder.point(AccuracySetting.FEW_SAMPLES).error().values()).isPositive();
    }

    @Test
    void exactSettings_matchReference() {
        AccuracySweep ladder = meter.measure(before, moved, Progress.NONE);
        Film reference = new ReferenceTracer(moved).trace();
        for (AccuracySetting grade : new AccuracySetting[] {AccuracySetting.EXACT_UPDATED, AccuracySetting.EXACT_CURRENT,
            AccuracySetting.FULL_TRACE}) {
            assertThat(ladder.point(grade).film().hasSameBits(reference)).as(grade.label()).isTrue();
            assertThat(ladder.point(grade).error().values()).as(grade.label()).isZero();
        }
        assertThat(ladder.original().hasSameBits(new ReferenceTracer(before).trace())).isTrue();
    }

    @Test
    void roughSettings_haveErrors() {
        AccuracySweep ladder = meter.measure(before, moved, Progress.NONE);
        for (AccuracySetting grade : new AccuracySetting[] {AccuracySetting.HALF_RESOLUTION, AccuracySetting.FAST_SHADING,
            AccuracySetting.RATIO, AccuracySetting.EXACT}) {
            assertThat(ladder.point(grade).error().values()).as(grade.label()).isPositive();
        }
        assertThat(ladder.point(AccuracySetting.FAST_SHADING).error().maxAbsolute()).isGreaterThan(0.01);
        assertThat(ladder.point(AccuracySetting.EXACT).error().maxAbsolute())
                .isLessThan(ladder.point(AccuracySetting.FAST_SHADING).error().maxAbsolute());
    }

    @Test
    void noMirrors_onlyExactMatchesReference() {
        Scene flat = before.withPicture(before.picture().withDepth(0));
        AccuracySweep ladder = meter.measure(flat, dimmed.withPicture(flat.picture()), Progress.NONE);
        assertThat(ladder.point(AccuracySetting.EXACT).error().values()).isZero();
        assertThat(ladder.point(AccuracySetting.RATIO).error().values()).isPositive();
        assertThat(ladder.point(AccuracySetting.RATIO).error().maxAbsolute()).isBetween(0.0,
                ladder.point(AccuracySetting.RATIO).update().errorBound());
    }

    @ParameterizedTest
    @EnumSource(AntialiasMode.class)
    void antialiasedPicture_hasSweep(AntialiasMode antialias) {
        PictureSettings smooth = before.picture().withSampling(new SamplingSettings(antialias, 2));
        AccuracySweep ladder = meter.measure(before.withPicture(smooth), moved.withPicture(smooth), Progress.NONE);
        Film reference = new ReferenceTracer(moved.withPicture(smooth)).trace();
        assertThat(ladder.point(AccuracySetting.FULL_TRACE).film().hasSameBits(reference)).isTrue();
        assertThat(ladder.point(AccuracySetting.EXACT_CURRENT).film().hasSameBits(reference)).isTrue();
        assertThat(ladder.point(AccuracySetting.EXACT_UPDATED).film().hasSameBits(reference)).isTrue();
        if (antialias == AntialiasMode.OFF) {
            assertThat(ladder.points()).extracting(SweepPoint::setting).doesNotContain(AccuracySetting.NO_ANTIALIASING);
        } else {
            Film plain = new ReferenceTracer(moved.withPicture(smooth.withSampling(new SamplingSettings(AntialiasMode.OFF, 2)))).trace();
            assertThat(ladder.point(AccuracySetting.NO_ANTIALIASING).film().hasSameBits(plain)).isTrue();
            assertThat(ladder.point(AccuracySetting.NO_ANTIALIASING).error().values()).isPositive();
        }
    }

    @Test
    void defaultSetting_matchesDefaultOptions() {
        assertThat(AccuracySetting.DEFAULT.options().accuracy()).isEqualTo(RenderOptions.DEFAULT.accuracy());
        assertThat(AccuracySetting.DEFAULT.options().reflections()).isEqualTo(RenderOptions.DEFAULT.reflections());
        assertThat(AccuracySetting.DEFAULT.options().storage()).isEqualTo(RenderOptions.DEFAULT.storage());
        assertThat(AccuracySetting.DEFAULT.options().view()).isEqualTo(RenderOptions.DEFAULT.view());
    }

    @Test
    void materialEdit_hasSweep() {
        for (PaperCase edit : PaperCases.of(before).stream().filter(c -> c.name().matches("mirror-.*|texture-.*|material.*")).toList()) {
            List<Scene> scenes = edit.scenes();
            AccuracySweep ladder = meter.measure(scenes.get(scenes.size() - 2), edit.after(), Progress.NONE);
            assertThat(ladder.point(AccuracySetting.EXACT_CURRENT).error().values()).as(edit.name()).isZero();
            assertThat(ladder.point(AccuracySetting.EXACT_UPDATED).error().values()).as(edit.name()).isZero();
        }
    }

    @Test
    void updates_matchSettings() {
        AccuracySweep ladder = meter.measure(before, dimmed, Progress.NONE);
        assertThat(ladder.point(AccuracySetting.EXACT).update().plan().description()).isEqualTo("lamp: weight");
        assertThat(ladder.point(AccuracySetting.EXACT_UPDATED).update().plan().description()).isEqualTo("reflections");
        assertThat(ladder.point(AccuracySetting.EXACT_CURRENT).update().plan().description()).isEqualTo("lamp: weight, reflections");
        assertThat(ladder.point(AccuracySetting.FULL_TRACE).update()).isNull();
    }

    @Test
    void nextEdit_startsFromSameScene() {
        meter.measure(before, moved, Progress.NONE);
        AccuracySweep second = meter.measure(before, dimmed, Progress.NONE);
        assertThat(second.point(AccuracySetting.EXACT).update().plan().description()).isEqualTo("lamp: weight");
        assertThat(meter.startCache().scene()).isEqualTo(before);
    }

    @Test
    void canceledMeasurement_canRestart() {
        int[] asked = {0};
        Progress stop = new Progress() {
            @Override
            public void report(int done, int total) {}

            @Override
            public boolean isCanceled() {
                return asked[0]++ > 20;
            }
        };
        assertThatThrownBy(() -> meter.measure(before, moved, stop)).isInstanceOf(CancellationException.class);
        assertThat(meter.measure(before, moved, Progress.NONE).point(AccuracySetting.EXACT_CURRENT).error().values()).isZero();
    }

    @Test
    void everySetting_hasDescription() {
        assertThat(Arrays.stream(AccuracySetting.values()).map(AccuracySetting::label)).doesNotHaveDuplicates();
        assertThat(AccuracySetting.values()).allSatisfy(grade -> assertThat(grade.description()).isNotBlank());
    }
}
