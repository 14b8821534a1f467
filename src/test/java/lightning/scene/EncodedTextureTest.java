package lightning.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Random;
import lightning.scene.asset.Texture;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;

/** Checks that a texture of codes equals the texture of their values. */
class EncodedTextureTest {
    @Property
    void codes_interpolateLikeValues(@ForAll @IntRange(min = 1, max = 5) int width, @ForAll @IntRange(min = 1, max = 4) int height,
            @ForAll long seed, @ForAll @DoubleRange(min = 0, max = 1) double across, @ForAll @DoubleRange(min = 0, max = 1) double along) {
        var random = new Random(seed);
        float[] values = new float[256];
        for (int code = 0; code < values.length; code++) {
            values[code] = random.nextFloat();
        }
        byte[] codes = new byte[3 * width * height];
        random.nextBytes(codes);
        float[] rgb = new float[codes.length];
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] = values[codes[i] < 0 ? codes[i] + 256 : codes[i]];
        }
        var ofCodes = new Texture(width, height, codes, values);
        var ofValues = new Texture(width, height, rgb);
        int x = random.nextInt(width);
        int y = random.nextInt(height);
        float[] encoded = new float[3];
        float[] linear = new float[3];
        ofCodes.interpolate(x, y, width - 1, height - 1, across, along, encoded);
        ofValues.interpolate(x, y, width - 1, height - 1, across, along, linear);
        assertThat(encoded).isEqualTo(linear);
        assertThat(ofCodes.luminance(x, y, 0, 0, across, along)).isEqualTo(ofValues.luminance(x, y, 0, 0, across, along));
        assertThat(ofCodes.channel(x, y, 2)).isEqualTo(ofValues.channel(x, y, 2));
    }

    @Test
    void incompleteValueTable_isRejected() {
        assertThatThrownBy(() -> new Texture(1, 1, new byte[3], new float[255])).isInstanceOf(IllegalArgumentException.class);
    }
}
