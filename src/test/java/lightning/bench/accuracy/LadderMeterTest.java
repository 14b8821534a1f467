package lightning.bench.accuracy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Arrays;
import java.util.EnumSet;
import java.util.List;
import java.util.concurrent.CancellationException;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.render.image.Film;
import lightning.render.relight.tile.Options;
import lightning.render.shading.ReferenceTracer;
import lightning.scene.Antialias;
import lightning.scene.Light;
import lightning.scene.LightType;
import lightning.scene.Picture;
import lightning.scene.Sampling;
import lightning.scene.Scene;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class LadderMeterTest {
    private final LadderMeter meter = new LadderMeter(2, 2, 0);
    private final Scene before = SceneFiles.read("bird", 41);
    private final Light lamp = before.light("lamp").orElseThrow();
    private final Scene faded = before.withLight(lamp.withIntensity(0.3 * lamp.intensity()));
    private final Scene moved = before.withLight(lamp.withPosition(lamp.position().plus(new Vec3(0.5, -0.5, 0.25))));

    @AfterEach
    void close() {
        meter.close();
    }

    @Test
    void ladder_hasEveryLevelWithItsSamples() {
        Ladder ladder = meter.measure(before, moved, Progress.NONE);
        assertThat(ladder.rungs()).extracting(Rung::grade)
                .containsExactlyElementsOf(EnumSet.complementOf(EnumSet.of(Grade.FEW_SAMPLES, Grade.NO_ANTIALIASING)));
        assertThat(ladder.rungs()).allSatisfy(rung -> {
            assertThat(rung.time().milliseconds()).hasSize(2);
            assertThat(rung.film().width()).isEqualTo(41);
            assertThat(rung.film().height()).isEqualTo(41);
            assertThat(rung.error().of()).isEqualTo(3 * 41 * 41);
        });
        assertThat(ladder.fullRays().eye()).isEqualTo(41 * 41);
        assertThat(ladder.saving(Grade.FULL_TRACE)).isZero();
    }

    @Test
    void softLights_getALevelOfFewSamplesThatIsOff() {
        Light large = moved.lights().getFirst();
        Scene soft = moved.withLight(large.withType(LightType.DISC).withArea(large.area().withRadius(1)));
        Ladder ladder = meter.measure(soft, soft.withLight(soft.lights().getFirst().withIntensity(0.7)), Progress.NONE);
        assertThat(ladder.rungs()).extracting(Rung::grade)
                .containsExactlyElementsOf(EnumSet.complementOf(EnumSet.of(Grade.NO_ANTIALIASING)));
        assertThat(ladder.rung(Grade.FEW_SAMPLES).error().values()).isPositive();
    }

    @Test
    void accurateLevels_showTheReference() {
        Ladder ladder = meter.measure(before, moved, Progress.NONE);
        Film reference = new ReferenceTracer(moved).trace();
        for (Grade grade : new Grade[] {Grade.EXACT_UPDATED, Grade.EXACT_CURRENT, Grade.FULL_TRACE}) {
            assertThat(ladder.rung(grade).film().sameBits(reference)).as(grade.label()).isTrue();
            assertThat(ladder.rung(grade).error().values()).as(grade.label()).isZero();
        }
        assertThat(ladder.original().sameBits(new ReferenceTracer(before).trace())).isTrue();
    }

    @Test
    void roughLevels_areOff() {
        Ladder ladder = meter.measure(before, moved, Progress.NONE);
        for (Grade grade : new Grade[] {Grade.HALF_RESOLUTION, Grade.FAST_SHADING, Grade.RATIO, Grade.EXACT}) {
            assertThat(ladder.rung(grade).error().values()).as(grade.label()).isPositive();
        }
        assertThat(ladder.rung(Grade.FAST_SHADING).error().maxAbsolute()).isGreaterThan(0.01);
        assertThat(ladder.rung(Grade.EXACT).error().maxAbsolute()).isLessThan(ladder.rung(Grade.FAST_SHADING).error().maxAbsolute());
    }

    @Test
    void withoutMirrors_exactIsTheReferenceAndRatioIsNot() {
        Scene flat = before.withPicture(before.picture().withDepth(0));
        Ladder ladder = meter.measure(flat, faded.withPicture(flat.picture()), Progress.NONE);
        assertThat(ladder.rung(Grade.EXACT).error().values()).isZero();
        assertThat(ladder.rung(Grade.RATIO).error().values()).isPositive();
        assertThat(ladder.rung(Grade.RATIO).error().maxAbsolute()).isBetween(0.0, ladder.rung(Grade.RATIO).update().errorBound());
    }

    @ParameterizedTest
    @EnumSource(Antialias.class)
    void smoothedPicture_hasItsLadderToo(Antialias antialias) {
        Picture smooth = before.picture().withSampling(new Sampling(antialias, 2));
        Ladder ladder = meter.measure(before.withPicture(smooth), moved.withPicture(smooth), Progress.NONE);
        Film reference = new ReferenceTracer(moved.withPicture(smooth)).trace();
        assertThat(ladder.rung(Grade.FULL_TRACE).film().sameBits(reference)).isTrue();
        assertThat(ladder.rung(Grade.EXACT_CURRENT).film().sameBits(reference)).isTrue();
        assertThat(ladder.rung(Grade.EXACT_UPDATED).film().sameBits(reference)).isTrue();
        if (antialias == Antialias.OFF) {
            assertThat(ladder.rungs()).extracting(Rung::grade).doesNotContain(Grade.NO_ANTIALIASING);
        } else {
            Film plain = new ReferenceTracer(moved.withPicture(smooth.withSampling(new Sampling(Antialias.OFF, 2)))).trace();
            assertThat(ladder.rung(Grade.NO_ANTIALIASING).film().sameBits(plain)).isTrue();
            assertThat(ladder.rung(Grade.NO_ANTIALIASING).error().values()).isPositive();
        }
    }

    @Test
    void defaultGrade_isWhatTheProgramDoesUnlessItIsToldOtherwise() {
        assertThat(Grade.DEFAULT.options().accuracy()).isEqualTo(Options.DEFAULT.accuracy());
        assertThat(Grade.DEFAULT.options().reflections()).isEqualTo(Options.DEFAULT.reflections());
        assertThat(Grade.DEFAULT.options().storage()).isEqualTo(Options.DEFAULT.storage());
        assertThat(Grade.DEFAULT.options().view()).isEqualTo(Options.DEFAULT.view());
    }

    @Test
    void materials_haveTheirLadderToo() {
        for (PaperCase edit : PaperCases.of(before).stream().filter(c -> c.name().matches("mirror-.*|texture-.*|material.*")).toList()) {
            List<Scene> scenes = edit.scenes();
            Ladder ladder = meter.measure(scenes.get(scenes.size() - 2), edit.after(), Progress.NONE);
            assertThat(ladder.rung(Grade.EXACT_CURRENT).error().values()).as(edit.name()).isZero();
            assertThat(ladder.rung(Grade.EXACT_UPDATED).error().values()).as(edit.name()).isZero();
        }
    }

    @Test
    void updates_areThoseOfTheLevels() {
        Ladder ladder = meter.measure(before, faded, Progress.NONE);
        assertThat(ladder.rung(Grade.EXACT).update().plan().text()).isEqualTo("lamp: weight");
        assertThat(ladder.rung(Grade.EXACT_UPDATED).update().plan().text()).isEqualTo("reflections");
        assertThat(ladder.rung(Grade.EXACT_CURRENT).update().plan().text()).isEqualTo("lamp: weight, reflections");
        assertThat(ladder.rung(Grade.FULL_TRACE).update()).isNull();
    }

    @Test
    void nextEdit_startsFromTheSceneAgain() {
        meter.measure(before, moved, Progress.NONE);
        Ladder second = meter.measure(before, faded, Progress.NONE);
        assertThat(second.rung(Grade.EXACT).update().plan().text()).isEqualTo("lamp: weight");
        assertThat(meter.kept().scene()).isEqualTo(before);
    }

    @Test
    void cancelledMeasuring_canBeginAgain() {
        int[] asked = {0};
        Progress stop = new Progress() {
            @Override
            public void tiles(int done, int total) {}

            @Override
            public boolean isCancelled() {
                return asked[0]++ > 20;
            }
        };
        assertThatThrownBy(() -> meter.measure(before, moved, stop)).isInstanceOf(CancellationException.class);
        assertThat(meter.measure(before, moved, Progress.NONE).rung(Grade.EXACT_CURRENT).error().values()).isZero();
    }

    @Test
    void everyLevel_saysWhatItIs() {
        assertThat(Arrays.stream(Grade.values()).map(Grade::label)).doesNotHaveDuplicates();
        assertThat(Grade.values()).allSatisfy(grade -> assertThat(grade.note()).isNotBlank());
    }
}
