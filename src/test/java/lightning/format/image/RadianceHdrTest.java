package lightning.format.image;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Random;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.sample.TryFolder;
import lightning.scene.value.SceneLimits;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;

/** Round trip of written Radiance images through the reader. */
class RadianceHdrTest {
    /** Mantissas have 8 bits, and the largest of the three uses all of them, so that at most half a unit of it is lost. */
    @Property(tries = 60)
    void values_areWithinHalfAUnitOfTheLargestChannel(@ForAll @IntRange(min = 1, max = 300) int width, @ForAll long seed,
            @ForAll boolean isFlat) throws IOException {
        Random random = new Random(seed);
        float[] rgb = new float[3 * width * 2];
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] = isFlat && random.nextInt(20) > 0 && i > 3 ? rgb[i - 3]
                    : (float) Math.min(random.nextFloat() * Math.scalb(1.0, random.nextInt(30) - 15), SceneLimits.MAX_EMISSION);
        }
        try (TryFolder files = new TryFolder()) {
            Path file = files.file("a.hdr");
            ImageFile.write(file, Film.ofScanlines(width, 2, rgb), ViewTransform.DEFAULT);
            float[] result = ImageFile.read(file).toScanlines();
            for (int i = 0; i < rgb.length; i++) {
                int pixel = i / 3 * 3;
                double max = Math.max(rgb[pixel], Math.max(rgb[pixel + 1], rgb[pixel + 2]));
                double unit = max == 0 ? 0 : Math.scalb(1.0, Math.getExponent(max) + 1 - 7);
                assertThat(Math.abs(result[i] - rgb[i])).isLessThanOrEqualTo((float) (unit / 2));
            }
        }
    }
}
