package lightning.render.relight.plan;

import static org.assertj.core.api.Assertions.assertThat;

import lightning.render.image.DisplayCurve;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import org.junit.jupiter.api.Test;

class ExactMethodTest {
    private static final ExactMethod METHOD = new ExactMethod();

    /** One byte of state, and cosine, specular term and falloff as floats; then a grazing term, and three channels of tint. */
    @Test
    void bytesPerRow_countsColumnsOfLight() {
        Light light = Light.of("lamp", LightType.POINT);
        assertThat(METHOD.bytesPerRow(light, false, false)).isEqualTo(1 + 3 * 4);
        assertThat(METHOD.bytesPerRow(light, true, false)).isEqualTo(1 + 4 * 4);
        assertThat(METHOD.bytesPerRow(light, true, true)).isEqualTo(1 + 4 * 4 + 3 * 4);
    }

    @Test
    void exactLayers_needNoRefresh() {
        assertThat(METHOD.errorBound(null)).isZero();
        assertThat(METHOD.refresh(null, 20, DisplayCurve.SRGB)).isEqualTo(new UpdatePlan.Nothing());
    }
}
