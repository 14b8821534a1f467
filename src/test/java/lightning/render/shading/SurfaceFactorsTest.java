package lightning.render.shading;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import lightning.base.math.Rgb;
import lightning.render.trace.SurfacePoint;
import lightning.scene.material.Material;
import lightning.scene.material.Transmission;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;

/** Tests the factors of the equation at a surface with normal y that a ray hits from above, with numbers that floats represent exactly. */
class SurfaceFactorsTest {
    private static final Material MIRROR = Material.of("m").withReflective(Rgb.gray(0.75));
    /** Index 3: the Fresnel reflectance of a perpendicular ray is ((3 − 1)/(3 + 1))² = 0.25. Half of the light passes, half of which is tinted away. */
    private static final Transmission GLASS =
            Transmission.NONE.withColor(Rgb.gray(0.5)).withIor(3).withTint(Rgb.gray(0.5)).withTintDistance(2);

    private static SurfacePoint hit(SurfacePoint.@Nullable BackSide back) {
        return new SurfacePoint(0, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, new float[] {0.5f, 0.25f, 1}, new float[] {0.5f, 1, 0}, 0,
                new float[] {1, 1, 1}, Map.of(), back);
    }

    private static SurfacePoint hit(Transmission transmission, float insideDistance) {
        return hit(new SurfacePoint.BackSide(transmission, 0, 0, 0, insideDistance, false));
    }

    /** Returns a channel of the color: emitted light 1.5, diffuse sum 3, specular sum 4, grazing sum 0.125, mirrored 8, refracted 16. */
    private static float color(SurfaceFactors factors, int c) {
        return factors.lit(c, 3, 4, 0.125f) + factors.mirrored(c, 8) + factors.refracted(c, 16) + factors.reflected(c, 32, 64)
                + factors.emitted(c, 1.5f);
    }

    /** (1.5 + 0.5·3)·(1 − 0.75) + (0.5·4 + 0.125) + 0.75·8 = 0.75 + 2.125 + 6; the other channels have other kd and ks. */
    @Test
    void opaqueSurface_matchesEquation() {
        SurfaceFactors factors = new SurfaceFactors(hit((SurfacePoint.BackSide) null), MIRROR);
        assertThat(color(factors, 0)).isEqualTo(8.875f);
        assertThat(color(factors, 1)).isEqualTo((1.5f + 0.75f) * 0.25f + (4 + 0.125f) + 6);
        assertThat(color(factors, 2)).isEqualTo((1.5f + 3) * 0.25f + 0.125f + 6);
        assertThat(factors.fresnel()).isZero();
        assertThat(factors.interiorTint(0)).isEqualTo(1);
    }

    /**
     * Mirror share m = 0.75 + 0.25·0.25 = 0.8125, body share b = 0.5: (1.5 + 0.5·3)·((1 − m)·b) + (0.5·4 + 0.125) + m·8 + (1 − m)·0.5·16
     * = 0.28125 + 2.125 + 6.5 + 1.5.
     */
    @Test
    void clearSurface_sharesLightBetweenBodyMirrorAndRefraction() {
        Material glass = MIRROR.withTransmission(GLASS);
        SurfaceFactors factors = new SurfaceFactors(hit(GLASS, -1), glass);
        assertThat(factors.fresnel()).isEqualTo(0.25f);
        assertThat(color(factors, 0)).isEqualTo(10.40625f);
        assertThat(color(factors, 1)).isEqualTo((1.5f + 0.75f) * 0.09375f + (4 + 0.125f) + 6.5f + 1.5f);
    }

    /** Half of the light is left after the tint's distance, of each kind. */
    @Test
    void interiorOfClearSolid_tintsEachKindOfLight() {
        SurfaceFactors factors = new SurfaceFactors(hit(GLASS, 2), MIRROR.withTransmission(GLASS));
        assertThat(factors.interiorTint(0)).isEqualTo(0.5f);
        assertThat(color(factors, 0)).isEqualTo(0.5f * 10.40625f);
        assertThat(factors.lit(0, 0, 0, 1)).isEqualTo(0.5f);
    }

    /** A part of the light that passes no channel belongs to the body. */
    @Test
    void bodyShare_isTheRestOfTheClearestChannel() {
        assertThat(SurfaceFactors.bodyShare(Transmission.NONE.withColor(new Rgb(0.25, 0.75, 0)))).isEqualTo(0.25f);
        Transmission red = GLASS.withColor(new Rgb(0.5, 0, 0));
        SurfaceFactors factors = new SurfaceFactors(hit(red, -1), MIRROR.withTransmission(red));
        assertThat(factors.refracted(0, 16)).isEqualTo(1.5f);
        assertThat(factors.refracted(1, 16)).isZero();
        assertThat(factors.emitted(1, 1)).isEqualTo(0.09375f);
    }
}
