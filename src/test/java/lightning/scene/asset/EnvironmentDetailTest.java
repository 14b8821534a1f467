package lightning.scene.asset;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;

/** Tests the pixels of large environments. */
class EnvironmentDetailTest {
    /** Half a step of 8 bits below the next power of two of the largest channel. */
    @Property
    void encodedColor_isWithinHalfAStep(@ForAll @DoubleRange(min = -37, max = 6) double exponent,
            @ForAll @DoubleRange(min = 0, max = 1) double green, @ForAll @DoubleRange(min = 0, max = 1) double blue) {
        float max = (float) Math.pow(10, exponent);
        float[] color = {max, (float) (green * max), (float) (blue * max)};
        int rgbe = EnvironmentDetail.encode(color[0], color[1], color[2]);
        for (int c = 0; c < 3; c++) {
            assertThat(EnvironmentDetail.decode(rgbe, c)).isEqualTo(color[c], within(max / 256.0 * 1.0000001));
        }
    }

    @Property
    void colorOfRadianceFile_keepsItsValues(@ForAll @IntRange(min = 128, max = 255) int red,
            @ForAll @IntRange(min = 0, max = 255) int green,
            @ForAll @IntRange(min = 20, max = 147) int exponent) {
        float r = (float) Math.scalb((double) red, exponent - 136);
        float g = (float) Math.scalb((double) green, exponent - 136);
        int rgbe = EnvironmentDetail.encode(r, g, 0);
        assertThat(EnvironmentDetail.decode(rgbe, 0)).isEqualTo(r);
        assertThat(EnvironmentDetail.decode(rgbe, 1)).isEqualTo(g);
        assertThat(EnvironmentDetail.decode(rgbe, 2)).isZero();
    }

    @Test
    void black_isBlack() {
        int rgbe = EnvironmentDetail.encode(0, 0, 0);
        assertThat(EnvironmentDetail.decode(rgbe, 0)).isZero();
    }

    @Test
    void levels_areMeans() {
        var detail = new EnvironmentDetail(8, 4, 4);
        for (int i = 0; i < 32; i++) {
            detail.set(i % 8, i / 8, new float[] {i % 2 == 0 ? 1 : 0, 0, 0});
        }
        detail.freeze();
        int coarse = detail.level(2 * Math.PI / 4);
        assertThat(detail.width(coarse)).isEqualTo(4);
        assertThat(detail.height(coarse)).isEqualTo(2);
        assertThat(detail.channel(coarse, 0, 0, 0)).isEqualTo(0.5);
    }

    @Test
    void level_isOneOfPixelsAsLargeAsThoseOfThePicture() {
        var detail = new EnvironmentDetail(64, 32, 100);
        detail.freeze();
        assertThat(detail.width(detail.level(1e-3))).as("finer than the image").isEqualTo(64);
        assertThat(detail.width(detail.level(2 * Math.PI / 32))).isEqualTo(32);
        assertThat(detail.level(2 * Math.PI / 10)).as("as coarse as the map of the light").isEqualTo(-1);
    }
}
