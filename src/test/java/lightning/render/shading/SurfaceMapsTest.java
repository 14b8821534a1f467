package lightning.render.shading;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.RenderOptions;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.render.image.Film;
import lightning.render.image.FilmAssert;
import lightning.render.relight.Renderer;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.scene.Camera;
import lightning.scene.IndirectSettings;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.asset.Texture;
import lightning.scene.asset.TextureChannel;
import lightning.scene.asset.TextureMap;
import lightning.scene.asset.TextureWrap;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.material.Coat;
import lightning.scene.material.Material;
import lightning.scene.material.ShadingModel;
import lightning.scene.material.SurfaceMaps;
import lightning.scene.material.Transmission;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.Placement;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests that maps of roughness and metalness act as the values of their products with the factors. */
class SurfaceMapsTest {
    static final int SIZE = 16;
    private static final Material BASE = Material.of("m").withModel(ShadingModel.PRINCIPLED).withBase(new Rgb(0.9, 0.5, 0.2))
            .withSpecularTint(new Rgb(0.3, 1, 0.6)).withCoat(new Coat(0.5, 0.3, 1.5)).withMetalness(0.75).withRoughness(0.5)
            .withTexture(map(1, 0.5f, 0.25f));

    /** A floor that fills the picture, below a ball, in the light of a spot and a panel. */
    static Scene scene(Material material) {
        return new Scene(new PictureSettings(SIZE, SIZE, 1), new Camera(new Vec3(0, 9, 0), Vec3.ZERO, new Vec3(0, 0, 1), 40), World.DEFAULT,
                List.of(material),
                List.of(new Shape(Solid.PLANE, "floor", "m", new Placement(Vec3.ZERO, Vec3.ZERO, new Vec3(20, 1, 20))),
                        new Shape(Solid.SPHERE, "ball", "m", new Placement(new Vec3(0, 1, -1.5), Vec3.ZERO, Vec3.ONE))),
                List.of(Light.of("spot", LightType.SPOT).withPosition(new Vec3(2, 8, 1)).withDirection(new Vec3(-2, -8, -1)).withAngle(60),
                        Light.of("panel", LightType.RECT).withPosition(new Vec3(-2, 6, 2)).withDirection(new Vec3(2, -6, -2))));
    }

    /** Returns an image of one color. */
    static Optional<TextureMap> map(float... rgb) {
        return Optional.of(new TextureMap("map.png", 1, 1, new Texture(1, 1, rgb)));
    }

    static Optional<TextureMap> gray(float value) {
        return map(value, value, value);
    }

    /** Returns the picture, which is the same in all renderers. */
    static Film trace(Scene scene) {
        Film film = new ReferenceTracer(scene).trace();
        try (WorkerPool workers = new WorkerPool(1); Renderer renderer = new Renderer(RenderOptions.DEFAULT.withThreads(1))) {
            FilmAssert.assertSameBits(new TraditionalTracer(scene).trace(workers, Progress.NONE).film(), film, "traditional");
            renderer.render(scene, Progress.NONE);
            FilmAssert.assertSameBits(renderer.film(), film, "cached");
        }
        return film;
    }

    /**
     * Products of these factors and values are doubles without rounding, and the colors of a row follow from them by the operations that give
     * the colors of a material: bits are equal.
     */
    @ParameterizedTest
    @CsvSource({"0.5, 1, 1", "0.5, 0.5, 1", "0.75, 1, 0.25", "1, 0.125, 0", "0.25, 0.5, 0.75"})
    void uniformMaps_equalTheirProducts(double factor, float rough, float metal) {
        Material mapped = BASE.withRoughness(factor).withMetalness(factor)
                .withSurfaceMaps(SurfaceMaps.NONE.withRoughness(gray(rough)).withMetalness(gray(metal)));
        Material plain = BASE.withRoughness(factor * rough).withMetalness(factor * metal);
        FilmAssert.assertSameBits(trace(scene(mapped)), trace(scene(plain)), "uniform");
    }

    @Test
    void uniformMetalness_equalsItsProductInIndirectLight() {
        Scene mapped = scene(BASE.withSurfaceMaps(SurfaceMaps.NONE.withMetalness(gray(0.5f))));
        PictureSettings indirect = mapped.picture().withIndirect(Optional.of(IndirectSettings.DEFAULT));
        FilmAssert.assertSameBits(trace(mapped.withPicture(indirect)), trace(scene(BASE.withMetalness(0.375)).withPicture(indirect)),
                "indirect");
    }

    /** The channels of one packed image, as in glTF: green is roughness, blue is metalness. */
    @Test
    void packedChannels_areRead() {
        Optional<TextureMap> packed = map(0.25f, 0.5f, 0.75f);
        SurfaceMaps maps = SurfaceMaps.NONE.withRoughness(packed).withMetalness(packed);
        FilmAssert.assertSameBits(trace(scene(BASE.withSurfaceMaps(maps))), trace(scene(BASE.withRoughness(0.25).withMetalness(0.5625))),
                "channels of glTF");
        double[] values = {0.25, 0.5, 0.75};
        for (TextureChannel rough : TextureChannel.values()) {
            TextureChannel metal = TextureChannel.values()[2 - rough.ordinal()];
            Material mapped = BASE.withSurfaceMaps(maps.withRoughnessChannel(rough).withMetalnessChannel(metal));
            Material plain = BASE.withRoughness(0.5 * values[rough.ordinal()]).withMetalness(0.75 * values[metal.ordinal()]);
            FilmAssert.assertSameBits(trace(scene(mapped)), trace(scene(plain)), rough + ", " + metal);
        }
    }

    /** Left and right of the seam, the floor shows one of two materials. */
    @Test
    void imageOfTwoValues_equalsTwoMaterials() {
        float[] rgb = new float[3 * 16];
        Arrays.fill(rgb, 0, 24, 0.25f);
        Arrays.fill(rgb, 24, 48, 1);
        Optional<TextureMap> image = Optional.of(new TextureMap("map.png", 1, 1, new Texture(16, 1, rgb), TextureWrap.CLAMP));
        Film mapped = trace(floor(BASE.withSurfaceMaps(SurfaceMaps.NONE.withRoughness(image).withMetalness(image))));
        Film one = trace(floor(BASE.withRoughness(0.125).withMetalness(0.1875)));
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

    static Scene floor(Material material) {
        Scene scene = scene(material);
        return scene.withNodes(List.of(scene.nodes().getFirst()));
    }

    static void assertPixel(Film actual, Film expected, int x, int y) {
        assertThat(List.of(actual.red(x, y), actual.green(x, y), actual.blue(x, y))).as(x + " " + y)
                .containsExactly(expected.red(x, y), expected.green(x, y), expected.blue(x, y));
    }

    @Test
    void clearMaterial_ignoresMaps() {
        Material glass = BASE.withRoughness(0.05).withTransmission(Transmission.NONE.withColor(Rgb.gray(0.5)));
        FilmAssert.assertSameBits(trace(scene(glass.withSurfaceMaps(SurfaceMaps.NONE.withRoughness(gray(0)).withMetalness(gray(0))))),
                trace(scene(glass)), "clear");
    }

    @Test
    void roughnessMap_neverMakesMirrors() {
        Material mapped = BASE.withSurfaceMaps(SurfaceMaps.NONE.withRoughness(gray(0)));
        assertThat(mapped.isSmooth()).isFalse();
        assertThat(mapped.withRoughness(0.05).isSmooth()).isTrue();
    }

    @Test
    void maxTerm_boundsTheSmoothestTexel() {
        Material mapped = BASE.withSurfaceMaps(SurfaceMaps.NONE.withRoughness(gray(1)));
        assertThat(mapped.maxTerm()).isEqualTo(BASE.withRoughness(0).maxTerm()).isGreaterThan(BASE.maxTerm());
    }

    @Test
    void otherModels_haveNoMaps() {
        SurfaceMaps maps = new SurfaceMaps(gray(0), TextureChannel.RED, gray(0), TextureChannel.RED, gray(0), TextureChannel.BLUE, gray(0));
        assertThat(BASE.withModel(ShadingModel.METALLIC).withSurfaceMaps(maps).surfaceMaps()).isEqualTo(SurfaceMaps.NONE);
        assertThat(BASE.withSurfaceMaps(maps).withModel(ShadingModel.PHONG).surfaceMaps()).isEqualTo(SurfaceMaps.NONE);
    }
}
