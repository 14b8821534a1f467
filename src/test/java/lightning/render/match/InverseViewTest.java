package lightning.render.match;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import lightning.render.image.DisplayCurve;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class InverseViewTest {
    private static final int COUNT = 4000;

    /** Light of any hue from 2⁻⁷ to 2, shown with the given exposure in 8 bits. */
    @ParameterizedTest
    @CsvSource({"SRGB, 0", "SRGB, -1.5", "LINEAR, 0", "FILMIC, 0.5", "ACES, 0", "ACES2, 0", "ACES2, -1", "AGX, 0", "AGX, 1"})
    void foundLight_isShownAsTheImage(DisplayCurve curve, double exposure) {
        ViewTransform view = new ViewTransform(exposure, curve);
        Random random = new Random(5);
        float[] light = new float[3 * COUNT];
        float[] image = new float[3 * COUNT];
        for (int i = 0; i < light.length; i++) {
            light[i] = (float) Math.exp(Math.log(2) * (8 * random.nextDouble() - 7 - exposure));
        }
        for (int i = 0; i < COUNT; i++) {
            int[] codes = view.displayed(light[3 * i], light[3 * i + 1], light[3 * i + 2]);
            for (int c = 0; c < 3; c++) {
                image[3 * i + c] = ViewTransform.linear(codes[c]);
            }
        }
        ReferenceImage codes = ReferenceImage.of(Film.ofScanlines(COUNT, 1, image)).withoutClipped();
        ReferenceImage found = codes.beforeView(view, COUNT, 1);
        int counted = 0;
        for (int i = 0; i < COUNT; i++) {
            if (found.weights()[i] > 0) {
                counted++;
                int[] shown = view.displayed(found.film().red(i, 0), found.film().green(i, 0), found.film().blue(i, 0));
                int[] wanted = view.displayed(light[3 * i], light[3 * i + 1], light[3 * i + 2]);
                for (int c = 0; c < 3; c++) {
                    assertThat(shown[c]).as("pixel %d", i).isCloseTo(wanted[c], within(1));
                }
            }
        }
        int unclipped = 0;
        for (float weight : codes.weights()) {
            unclipped += weight > 0 ? 1 : 0;
        }
        assertThat(unclipped).isGreaterThan(COUNT / 4);
        assertThat(counted).as("of %d", unclipped).isGreaterThan(unclipped * 9 / 10);
    }
}
