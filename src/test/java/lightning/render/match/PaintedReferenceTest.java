package lightning.render.match;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import lightning.render.image.Film;
import org.junit.jupiter.api.Test;

class PaintedReferenceTest {
    private static final Film PICTURE = Film.ofScanlines(3, 1, new float[] {1, 1, 1, 2, 2, 2, 4, 4, 4});

    @Test
    void brighterPaint_asksForOneStopMore() {
        ReferenceImage reference = PaintedReference.of(PICTURE, List.of(new BrushDab(BrushDab.Wish.BRIGHTER, 1.5, 0.5, 0.6)));
        assertThat(reference.film().toScanlines()).containsExactly(1, 1, 1, 4, 4, 4, 4, 4, 4);
    }

    /** Differences count relative to the picture, not to what is asked for, and what shall stay weighs as much as all paint. */
    @Test
    void paintAndTheRest_weighTheSame() {
        ReferenceImage reference = PaintedReference.of(PICTURE, List.of(new BrushDab(BrushDab.Wish.BRIGHTER, 1.5, 0.5, 0.6)));
        assertThat(reference.weights()).containsExactly(0, 4, 0);
        assertThat(reference.stays()).containsExactly(0.5f, 0, 0.5f);
    }

    @Test
    void lastDab_counts() {
        List<BrushDab> dabs = List.of(new BrushDab(BrushDab.Wish.BRIGHTER, 1.5, 0.5, 9), new BrushDab(BrushDab.Wish.KEEP, 0.5, 0.5, 0.6));
        assertThat(PaintedReference.of(PICTURE, dabs).film().red(0, 0)).isEqualTo(1);
        assertThat(PaintedReference.of(PICTURE, dabs).film().red(2, 0)).isEqualTo(8);
    }

    @Test
    void dabOutsideThePicture_changesNothing() {
        ReferenceImage reference = PaintedReference.of(PICTURE, List.of(new BrushDab(BrushDab.Wish.DARKER, -50, 70, 5)));
        assertThat(reference.film().hasSameBits(PICTURE)).isTrue();
    }

    @Test
    void warmPaint_keepsTheOrderOfChannels() {
        ReferenceImage reference = PaintedReference.of(PICTURE, List.of(new BrushDab(BrushDab.Wish.WARMER, 0.5, 0.5, 0.6)));
        assertThat(reference.film().red(0, 0)).isGreaterThan(1);
        assertThat(reference.film().blue(0, 0)).isLessThan(1);
    }
}
