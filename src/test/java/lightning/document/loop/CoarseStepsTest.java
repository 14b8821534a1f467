package lightning.document.loop;

import static org.assertj.core.api.Assertions.assertThat;

import lightning.document.DeskScene;
import lightning.scene.AntialiasMode;
import lightning.scene.PictureSettings;
import lightning.scene.SamplingSettings;
import org.junit.jupiter.api.Test;

class CoarseStepsTest {
    private static final PictureSettings PICTURE = PictureSettings.DEFAULT.withSize(1280, 720);
    private static final CoarseSteps STEPS = stepsOf(PICTURE);
    /** A slow scene in a process whose code is not compiled: a thousand pixels per second. */
    private static final double SLOW = 1_000;

    private static CoarseSteps stepsOf(PictureSettings picture) {
        return CoarseSteps.of(DeskScene.scene().withPicture(picture));
    }

    @Test
    void firstImage_takesFractionOfSecondEvenIfRaysAreSlow() {
        assertThat(STEPS.first() / SLOW).isLessThan(0.3);
    }

    @Test
    void smallPicture_hasNoCoarseImage() {
        assertThat(stepsOf(PICTURE.withSize(160, 120)).first()).isZero();
    }

    @Test
    void slowRays_leadToFewMorePixelsInEachImage() {
        int second = STEPS.next(STEPS.first(), SLOW);
        assertThat(second).isEqualTo(4 * STEPS.first());
        assertThat(STEPS.next(second, SLOW)).isEqualTo(4 * second);
    }

    @Test
    void fastRays_leadToManyMorePixelsInEachImage() {
        assertThat(STEPS.next(STEPS.first(), 100_000)).isGreaterThan(10_000);
    }

    @Test
    void pictureThatIsReadySoon_hasNoFurtherCoarseImage() {
        assertThat(STEPS.next(STEPS.first(), 10_000_000)).isZero();
    }

    @Test
    void allImages_haveSmallShareOfPicture() {
        int all = 0;
        for (int pixels = STEPS.first(); pixels > 0; pixels = STEPS.next(pixels, SLOW)) {
            all += pixels;
        }
        assertThat(all).isLessThan(1280 * 720 / 20);
    }

    @Test
    void samplesInEveryPixel_allowFinerImages() {
        CoarseSteps every = stepsOf(PICTURE.withSampling(new SamplingSettings(AntialiasMode.EVERY, 8)));
        int last = 0;
        for (int pixels = every.first(); pixels > 0; pixels = every.next(pixels, SLOW)) {
            last = pixels;
        }
        assertThat(last).isGreaterThan(1280 * 720 / 4).isLessThanOrEqualTo(1280 * 720);
    }

    @Test
    void imageThatTakesTooLong_isLeftOut() {
        assertThat(STEPS.nextWithin(STEPS.first(), SLOW, 0.5)).isZero();
        assertThat(STEPS.nextWithin(STEPS.first(), SLOW, 2)).isPositive();
    }

    @Test
    void imageOfDragStep_fitsIntoItsTime() {
        assertThat(STEPS.during(0.1, 40_000)).isEqualTo(4_000);
        assertThat(STEPS.during(0.1, 0)).as("unknown rate").isEqualTo(STEPS.first());
        assertThat(STEPS.during(0.1, 1e9)).as("upper limit").isLessThan(1280 * 720 / 20);
    }
}
