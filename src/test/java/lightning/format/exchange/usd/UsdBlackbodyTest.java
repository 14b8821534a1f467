package lightning.format.exchange.usd;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import lightning.base.math.Rgb;
import lightning.scene.value.ColorTemperature;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests that a light with a color temperature has the same color in USD. */
class UsdBlackbodyTest {
    /** Values that {@code UsdLux.BlackbodyTemperatureAsRgb} of usd-core 26.11 returns, rounded to five digits. */
    @ParameterizedTest
    @CsvSource({"500,4.30550,0.11836,0", "1000,4.30550,0.11836,0", "1667,2.89192,0.53850,0.00058", "2000,2.52057,0.64689,0.02040",
        "3000,1.77103,0.84429,0.27203", "6500,1.04333,0.98362,1.03461", "6600,1.03553,0.98445,1.04945", "10000,0.87184,0.99469,1.43",
        "12000,0.87184,0.99469,1.43"})
    void tint_isThatOfUsdLux(double kelvin, double r, double g, double b) {
        Rgb tint = UsdBlackbody.tint(kelvin);
        assertThat(tint.r()).isCloseTo(r, within(6e-6));
        assertThat(tint.g()).isCloseTo(g, within(6e-6));
        assertThat(tint.b()).isCloseTo(b, within(6e-6));
    }

    @Property
    void correctedColor_givesTheTintOfUsd(@ForAll @DoubleRange(min = 500, max = 30000) double usdKelvin,
            @ForAll @DoubleRange(min = ColorTemperature.MIN, max = ColorTemperature.MAX) double kelvin) {
        Rgb color = UsdBlackbody.correction(usdKelvin, kelvin).times(ColorTemperature.tint(kelvin));
        Rgb usd = UsdBlackbody.tint(usdKelvin);
        assertThat(color.r()).isCloseTo(usd.r(), within(1e-12));
        assertThat(color.g()).isCloseTo(usd.g(), within(1e-12));
        assertThat(color.b()).isCloseTo(ColorTemperature.tint(kelvin).b() == 0 ? 0 : usd.b(), within(1e-12));
    }
}
