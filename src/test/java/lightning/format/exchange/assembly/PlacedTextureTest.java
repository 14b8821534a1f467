package lightning.format.exchange.assembly;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import lightning.base.math.Affine2;
import lightning.scene.asset.Texture;
import lightning.scene.asset.TextureMap;
import lightning.scene.asset.TexturePlacement;
import lightning.scene.asset.TextureWrap;
import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;

/** Maps of texture coordinates as repetition, rotation and offset. */
class PlacedTextureTest {
    private static final TextureMap REPEATED = map(TextureWrap.REPEAT);

    private static TextureMap map(TextureWrap wrap) {
        return new TextureMap("a.png", 1, 1, new Texture(1, 1, new float[3]), wrap);
    }

    /** Returns the map of coordinates that glTF, USD and Blender describe by scale, then rotation, then translation. */
    private static Affine2 described(double scaleU, double scaleV, double degrees, double u, double v) {
        double c = Math.cos(Math.toRadians(degrees));
        double s = Math.sin(Math.toRadians(degrees));
        return new Affine2(c * scaleU, -s * scaleV, u, s * scaleU, c * scaleV, v);
    }

    private static void assertShows(TextureMap texture, Affine2 map, double u, double v, double period) {
        TexturePlacement placement = texture.placement();
        boolean isFixed = period == 0;
        double x = u * texture.repeatU() + (isFixed && texture.repeatU() < 0 ? 1 : 0);
        double y = v * texture.repeatV() + (isFixed && texture.repeatV() < 0 ? 1 : 0);
        double errorU = placement.cosine() * x - placement.sine() * y + placement.offsetU() - map.u(u, v);
        double errorV = placement.sine() * x + placement.cosine() * y + placement.offsetV() - map.v(u, v);
        assertThat(isFixed ? errorU : Math.IEEEremainder(errorU, period)).isCloseTo(0, within(1e-6));
        assertThat(isFixed ? errorV : Math.IEEEremainder(errorV, period)).isCloseTo(0, within(1e-6));
    }

    @Property
    void everyDescribedMap_isShown(@ForAll @DoubleRange(min = -9, max = 9) double scaleU,
            @ForAll @DoubleRange(min = 0.1, max = 9) double scaleV,
            @ForAll @DoubleRange(min = -180, max = 180) double degrees, @ForAll @DoubleRange(min = -5, max = 5) double u,
            @ForAll @DoubleRange(min = -5, max = 5) double v) {
        Affine2 map = described(Math.abs(scaleU) < 0.1 ? 1 : scaleU, scaleV, degrees, u, v);
        assertShows(PlacedTexture.of(REPEATED, map).orElseThrow(), map, 0.3, 0.7, 1);
        assertShows(PlacedTexture.of(map(TextureWrap.CLAMP), map).orElseThrow(), map, 0.3, 0.7, 0);
    }

    @Example
    void scaleAlone_isTheRepetition() {
        assertThat(PlacedTexture.of(REPEATED, described(2, -0.5, 0, 0, 0))).contains(REPEATED.withRepeatU(2).withRepeatV(-0.5));
    }

    @Example
    void wholeOffsets_vanishInRepeatedImages() {
        assertThat(PlacedTexture.of(REPEATED, described(1, 1, 0, 3, -2)).orElseThrow().placement()).isEqualTo(TexturePlacement.NONE);
        assertThat(PlacedTexture.of(map(TextureWrap.CLAMP), described(1, 1, 0, 3, -2)).orElseThrow().placement())
                .isEqualTo(new TexturePlacement(3, -2, 0));
    }

    @Example
    void shear_isRefused() {
        assertThat(PlacedTexture.of(REPEATED, new Affine2(1, 0.5, 0, 0, 1, 0))).isEmpty();
        assertThat(PlacedTexture.of(REPEATED, new Affine2(0, 0, 0, 0, 1, 0))).isEmpty();
    }

    @Property
    void inverse_leadsBack(@ForAll @DoubleRange(min = -180, max = 180) double degrees, @ForAll @DoubleRange(min = -5, max = 5) double u) {
        Affine2 map = described(2, 0.5, degrees, u, 1);
        Affine2 both = map.inverse().orElseThrow().times(map);
        assertThat(both.u(0.3, 0.7)).isCloseTo(0.3, within(1e-9));
        assertThat(both.v(0.3, 0.7)).isCloseTo(0.7, within(1e-9));
    }
}
