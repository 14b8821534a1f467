package lightning.render.relight.paper;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.render.engine.choice.Engines;
import lightning.render.shading.LightSource;
import lightning.render.shading.WeightedLight;
import lightning.render.shading.layer.LightRows;
import lightning.render.trace.HitRows;
import lightning.render.trace.TexelColumns;
import lightning.scene.Camera;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.value.Attenuation;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the two ratios of the paper's updates, over rows straight under the light, and the cases without a ratio. */
class RatioTermsTest {
    private static final byte LIT = LightRows.LIT | LightRows.UNBLOCKED;
    private static final byte SHADOWED = LightRows.SHADOWED | LightRows.BLOCKED;

    private static WeightedLight luminaire(Light light) {
        Camera atOrigin = new Camera(Vec3.ZERO, new Vec3(0, 0, -1), Vec3.Y, 40);
        return WeightedLight.of(light, new Scene(PictureSettings.DEFAULT, atOrigin, World.DEFAULT, List.of(), List.of(), List.of(light)));
    }

    private static LightSource lamp(Light light) {
        return luminaire(light).source();
    }

    private static WeightedLight weighted(double r, double g, double b) {
        return luminaire(Light.of("l", LightType.POINT).withColor(new Rgb(r, g, b)));
    }

    @Test
    void intensityRatio_isNewOverOldPerChannel() {
        IntensityRatio ratio = IntensityRatio.between(weighted(1, 0.5, 4), weighted(2, 2, 1));
        assertThat(ratio).isEqualTo(new IntensityRatio(2, 4, 0.25f));
        assertThat(ratio.isUsable()).isTrue();
        assertThat(new float[] {ratio.channel(0), ratio.channel(1), ratio.channel(2)}).containsExactly(2, 4, 0.25f);
    }

    @Test
    void unchangedChannel_hasRatioOneEvenAtZero() {
        assertThat(IntensityRatio.between(weighted(0, 2, 3), weighted(0, 2, 3))).isEqualTo(IntensityRatio.NONE);
    }

    /** Its contributions have lost digits and would lose more with each change of falloff. */
    @Test
    void subnormalChannel_hasNoRatio() {
        assertThat(IntensityRatio.between(weighted(1, 1e-40, 3), weighted(1, 1e-40, 3)).isUsable()).isFalse();
    }

    /** From 0 there is no ratio, from a subnormal float only one that has lost digits, and to 0 it is 0. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 1e-45, 1e-40, 0x1.fffffcp-127})
    void nearZeroChannel_hasNoRatio(double before) {
        assertThat(IntensityRatio.between(weighted(before, 1, 1), weighted(1, 1, 1)).isUsable()).isFalse();
        assertThat(IntensityRatio.between(weighted(1, before, 1), weighted(1, 1, 1)).isUsable()).isFalse();
        assertThat(IntensityRatio.between(weighted(1, 1, before), weighted(1, 1, 1)).isUsable()).isFalse();
        assertThat(IntensityRatio.between(weighted(1, 1, 1), weighted(before, before, before)).isUsable()).isTrue();
        assertThat(IntensityRatio.between(weighted(Float.MIN_NORMAL, 1, 1), weighted(1, 1, 1)).red()).isEqualTo(0x1p126f);
    }

    @Test
    void overflowingRatio_isUnusable() {
        Light dim = Light.of("l", LightType.POINT).withIntensity(1e-35);
        assertThat(IntensityRatio.between(luminaire(dim), luminaire(dim.withIntensity(1e3))).isUsable()).isTrue();
        assertThat(IntensityRatio.between(luminaire(dim), luminaire(dim.withIntensity(1e4))).isUsable()).isFalse();
    }

    /** Creates rows at the given distances under a light in the origin that shines down. */
    private static HitRows rows(double... distances) {
        HitRows rows = new HitRows(distances.length, TexelColumns.NONE);
        rows.count = distances.length;
        for (int i = 0; i < distances.length; i++) {
            rows.py[i] = (float) -distances[i];
            rows.ny[i] = 1;
        }
        return rows;
    }

    private static Light light(LightType type) {
        return Light.of("l", type).withDirection(new Vec3(0, -1, 0)).withAngle(90).withDropoff(0);
    }

    @ParameterizedTest
    @EnumSource(names = {"POINT", "SPOT"})
    void attenuationRatio_isNewOverOldFalloffOfLitRows(LightType type) {
        Light plain = light(type);
        Light square = plain.withAttenuation(new Attenuation(0, 0, 1));
        AttenuationRatio ratio = new AttenuationRatio(Engines.LANES.terms());
        byte[] states = {LIT, LIT, SHADOWED};
        assertThat(ratio.compute(rows(2, 4, 8), lamp(plain), lamp(square), states)).isTrue();
        assertThat(ratio.ratio).startsWith(0.25f, 0.0625f, 1);
        assertThat(ratio.minFalloff()).isEqualTo(0.0625);
        assertThat(ratio.compute(rows(2, 4, 8), lamp(square), lamp(plain), states)).isTrue();
        assertThat(ratio.ratio).startsWith(4, 16, 1);
        assertThat(ratio.minFalloff()).isEqualTo(0.0625);
    }

    @Test
    void attenuationRatio_ofDirectionalLight_isOne() {
        Light sun = light(LightType.DIRECTIONAL);
        AttenuationRatio ratio = new AttenuationRatio(Engines.LANES.terms());
        assertThat(ratio.compute(rows(2), lamp(sun), lamp(sun.withAttenuation(new Attenuation(9, 9, 9))), new byte[] {LIT})).isTrue();
        assertThat(ratio.ratio[0]).isEqualTo(1);
        assertThat(ratio.minFalloff()).isEqualTo(1);
    }

    /** The row is 60° off the axis. */
    @Test
    void attenuationRatio_includesSpotCoefficient() {
        Light slanted = light(LightType.SPOT).withDirection(new Vec3(Math.sqrt(3), -1, 0));
        AttenuationRatio ratio = new AttenuationRatio(Engines.LANES.terms());
        assertThat(ratio.compute(rows(2), lamp(slanted.withDropoff(1)), lamp(slanted.withDropoff(3)), new byte[] {LIT})).isTrue();
        assertThat((double) ratio.ratio[0]).isCloseTo(0.25, within(1e-7));
        assertThat(ratio.minFalloff()).isCloseTo(0.125, within(1e-7));
    }

    /** 1/(2⁶⁶·2⁶⁰) is the smallest normal float; with slightly more attenuation, the old value is too small to divide by. */
    @Test
    void subnormalFalloffOfLitRow_hasNoRatio() {
        Light edge = light(LightType.POINT).withAttenuation(new Attenuation(0, 0, 0x1p66));
        Light below = light(LightType.POINT).withAttenuation(new Attenuation(0, 0, Math.nextUp(0x1p66)));
        Light plain = light(LightType.POINT);
        HitRows rows = rows(0x1p30);
        AttenuationRatio ratio = new AttenuationRatio(Engines.LANES.terms());
        assertThat(ratio.compute(rows, lamp(edge), lamp(plain), new byte[] {LIT})).isTrue();
        assertThat(ratio.ratio[0]).isEqualTo(0x1p126f);
        assertThat(ratio.compute(rows, lamp(below), lamp(plain), new byte[] {LIT})).isFalse();
        assertThat(ratio.compute(rows, lamp(below), lamp(plain), new byte[] {SHADOWED})).isTrue();
        assertThat(ratio.compute(rows, lamp(plain), lamp(plain.withAttenuation(new Attenuation(0, 0, 1e30))), new byte[] {LIT})).isTrue();
        assertThat(ratio.minFalloff()).isEqualTo(Float.MIN_NORMAL);
        assertThat(ratio.compute(rows(2, 0x1p30), lamp(below), lamp(plain), new byte[] {LIT, LIT})).as("one of two").isFalse();
        assertThat(ratio.compute(rows(0x1p30, 2), lamp(below), lamp(plain), new byte[] {LIT, LIT})).as("one of two").isFalse();
    }

    @Test
    void falloffWithoutAttenuationAndDropoff_isOne() {
        Attenuation falloffOrNull = new Attenuation(1, 1, 1);
        assertThat(lamp(light(LightType.DIRECTIONAL).withAttenuation(falloffOrNull).withDropoff(3)).needsFalloffColumn()).isFalse();
        assertThat(lamp(light(LightType.POINT).withAttenuation(Attenuation.NONE).withDropoff(3)).needsFalloffColumn()).isFalse();
        assertThat(lamp(light(LightType.POINT).withAttenuation(falloffOrNull)).needsFalloffColumn()).isTrue();
        assertThat(lamp(light(LightType.SPOT).withAttenuation(Attenuation.NONE)).needsFalloffColumn()).isFalse();
        assertThat(lamp(light(LightType.SPOT).withAttenuation(Attenuation.NONE).withDropoff(3)).needsFalloffColumn()).isTrue();
        assertThat(lamp(light(LightType.SPOT).withAttenuation(falloffOrNull)).needsFalloffColumn()).isTrue();
    }

    @Test
    void lightTreatedAsOn_hasFullWeight() {
        Light off = light(LightType.POINT).withOn(false).withIntensity(3);
        Scene scene = new Scene(PictureSettings.DEFAULT, Camera.DEFAULT, World.DEFAULT, List.of(), List.of(), List.of(off));
        assertThat(WeightedLight.of(off, scene).isDark()).isTrue();
        assertThat(WeightedLight.ofSwitchedOn(off, scene).diffuse().red()).isEqualTo(3);
    }
}
