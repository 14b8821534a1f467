package lightning.render.shading;

import static lightning.render.shading.SurfaceMapsTest.SIZE;
import static lightning.render.shading.SurfaceMapsTest.assertPixel;
import static lightning.render.shading.SurfaceMapsTest.floor;
import static lightning.render.shading.SurfaceMapsTest.gray;
import static lightning.render.shading.SurfaceMapsTest.map;
import static lightning.render.shading.SurfaceMapsTest.scene;
import static lightning.render.shading.SurfaceMapsTest.trace;
import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import lightning.base.math.Rgb;
import lightning.render.image.Film;
import lightning.render.image.FilmAssert;
import lightning.scene.IndirectSettings;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.asset.Texture;
import lightning.scene.asset.TextureChannel;
import lightning.scene.asset.TextureMap;
import lightning.scene.asset.TextureWrap;
import lightning.scene.material.Coat;
import lightning.scene.material.LayerMaps;
import lightning.scene.material.Material;
import lightning.scene.material.ShadingModel;
import lightning.scene.material.Sheen;
import lightning.scene.material.SurfaceMaps;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.FieldSource;

/** Tests that maps of a nonmetal's reflectance, of a coat and of a sheen act as the values of their products with the factors. */
class LayerMapsTest {
    /** All factors and texels are dyadic numbers, so their products are not rounded. */
    private static final Material BASE = Material.of("m").withModel(ShadingModel.PRINCIPLED).withBase(new Rgb(0.875, 0.5, 0.25))
            .withF0(0.125).withSpecularTint(new Rgb(0.25, 1, 0.5)).withCoat(new Coat(0.5, 0.375, 1.5)).withMetalness(0.25)
            .withRoughness(0.5);
    private static final Material SHEEN = BASE.withSheen(new Sheen(new Rgb(0.75, 0.5, 0.25), 0.75));

    /**
     * Material with maps of one color, and that with their products.
     *
     * @param name names the case
     */
    record Uniform(String name, Material mapped, Material plain) {
        @Override
        public String toString() {
            return name;
        }
    }

    static final List<Uniform> UNIFORM = List.of(
            new Uniform("f0", BASE.withSurfaceMaps(SurfaceMaps.NONE.withF0(gray(0.5f))), BASE.withF0(0.0625)),
            new Uniform("tint", BASE.withSurfaceMaps(SurfaceMaps.NONE.withSpecularTint(map(1, 0.5f, 0.25f))),
                    BASE.withSpecularTint(new Rgb(0.25, 0.5, 0.125))),
            new Uniform("f0 and tint below a sheen",
                    SHEEN.withSurfaceMaps(SurfaceMaps.NONE.withF0(gray(0.5f)).withSpecularTint(map(1, 0.5f, 0.25f))),
                    SHEEN.withF0(0.0625).withSpecularTint(new Rgb(0.25, 0.5, 0.125))),
            new Uniform("coat", BASE.withLayerMaps(LayerMaps.NONE.withCoat(gray(0.25f))), BASE.withCoat(new Coat(0.125, 0.375, 1.5))),
            new Uniform("coat roughness", BASE.withLayerMaps(LayerMaps.NONE.withCoatRoughness(gray(0.5f))),
                    BASE.withCoat(new Coat(0.5, 0.1875, 1.5))),
            new Uniform("packed coat below a sheen",
                    SHEEN.withLayerMaps(LayerMaps.NONE.withCoat(map(0.5f, 0.25f, 0)).withCoatRoughness(map(0, 0.5f, 0))),
                    SHEEN.withCoat(new Coat(0.25, 0.1875, 1.5))),
            new Uniform("sheen", SHEEN.withLayerMaps(LayerMaps.NONE.withSheen(map(0.5f, 0.25f, 1))),
                    SHEEN.withSheen(new Sheen(new Rgb(0.375, 0.125, 0.25), 0.75))),
            new Uniform("sheen roughness",
                    SHEEN.withLayerMaps(LayerMaps.NONE.withSheenRoughness(map(1, 0, 0.5f)).withSheenRoughnessChannel(TextureChannel.BLUE)),
                    SHEEN.withSheen(new Sheen(new Rgb(0.75, 0.5, 0.25), 0.375))));

    @ParameterizedTest
    @FieldSource("UNIFORM")
    void uniformMap_equalsItsProduct(Uniform uniform) {
        FilmAssert.assertSameBits(trace(scene(uniform.mapped)), trace(scene(uniform.plain)), uniform.name);
    }

    @Test
    void uniformMaps_equalTheirProductsInIndirectLight() {
        Material mapped = SHEEN.withSurfaceMaps(SurfaceMaps.NONE.withF0(gray(0.5f)).withSpecularTint(map(1, 0.5f, 0.25f)))
                .withLayerMaps(LayerMaps.NONE.withSheen(map(0.5f, 0.25f, 1)).withSheenRoughness(gray(0.5f)));
        Material plain = SHEEN.withF0(0.0625).withSpecularTint(new Rgb(0.25, 0.5, 0.125))
                .withSheen(new Sheen(new Rgb(0.375, 0.125, 0.25), 0.375));
        Scene scene = scene(mapped);
        PictureSettings indirect = scene.picture().withIndirect(Optional.of(IndirectSettings.DEFAULT));
        FilmAssert.assertSameBits(trace(scene.withPicture(indirect)), trace(scene(plain).withPicture(indirect)), "indirect");
    }

    /** Left and right of the seam, the floor shows one of two materials in the lights; reflections show nothing here. */
    @Test
    void imageOfTwoValues_equalsTwoMaterials() {
        float[] rgb = new float[3 * 16];
        Arrays.fill(rgb, 0, 24, 0.25f);
        Arrays.fill(rgb, 24, 48, 1);
        Optional<TextureMap> image = Optional.of(new TextureMap("map.png", 1, 1, new Texture(16, 1, rgb), TextureWrap.CLAMP));
        Film mapped = trace(floor(BASE.withLayerMaps(LayerMaps.NONE.withCoat(image).withCoatRoughness(image))
                .withSurfaceMaps(SurfaceMaps.NONE.withF0(image).withSpecularTint(image))));
        Film one = trace(floor(BASE.withCoat(new Coat(0.125, 0.09375, 1.5)).withF0(0.03125)
                .withSpecularTint(BASE.specularTint().times(0.25))));
        Film other = trace(floor(BASE));
        boolean isMirrored = mapped.red(0, SIZE / 2) == other.red(0, SIZE / 2);
        for (int y = 0; y < SIZE; y++) {
            for (int x = 0; x < SIZE / 4; x++) {
                assertPixel(mapped, isMirrored ? other : one, x, y);
                assertPixel(mapped, isMirrored ? one : other, SIZE - 1 - x, y);
            }
        }
        assertThat(one.hasSameBits(other)).isFalse();
    }

    @Test
    void coatRoughnessMap_neverMakesMirrors() {
        Material mapped = BASE.withLayerMaps(LayerMaps.NONE.withCoatRoughness(gray(0)));
        assertThat(mapped.hasSmoothCoat()).isFalse();
        assertThat(mapped.maxTerm()).isEqualTo(BASE.withCoat(new Coat(0.5, 0, 1.5)).maxTerm()).isGreaterThan(BASE.maxTerm());
    }

    @Test
    void otherModels_haveNoMaps() {
        Material mapped = SHEEN.withLayerMaps(
                new LayerMaps(gray(0), TextureChannel.GREEN, gray(0), TextureChannel.RED, gray(0), 0.5, gray(0), gray(0),
                        TextureChannel.BLUE));
        assertThat(mapped.withModel(ShadingModel.METALLIC).layerMaps()).isEqualTo(LayerMaps.NONE);
    }
}
