package lightning.render.shading;

import static org.assertj.core.api.Assertions.assertThat;

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
import lightning.render.relight.UpdateResult;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.scene.Camera;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.asset.Texture;
import lightning.scene.asset.TextureMap;
import lightning.scene.material.Material;
import lightning.scene.material.ShadingModel;
import lightning.scene.material.Transmission;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.Placement;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests that a glowing sphere without lights shows its glow exactly. */
class GlowTest {
    private static final int SIZE = 33;
    private static final Rgb GLOW = new Rgb(0.7, 300, 1e6);
    private static final Material NEON = Material.of("neon").withGlow(GLOW);

    /** A sphere of radius 1 in the middle of a black picture. */
    private static Scene scene(Material material, double ambience) {
        return new Scene(new PictureSettings(SIZE, SIZE, 2), new Camera(new Vec3(0, 0, 6), Vec3.ZERO, Vec3.Y, 30),
                new World(ambience, Rgb.BLACK), List.of(material),
                List.of(new Shape(Solid.SPHERE, "ball", material.name(), Placement.IDENTITY)), List.of());
    }

    /** Asserts that pixels of the sphere have a color, and that all others are black, in all renderers. */
    private static void assertBall(Scene scene, float red, float green, float blue) {
        Film film = new ReferenceTracer(scene).trace();
        assertThat(List.of(film.red(0, 0), film.green(0, 0), film.blue(0, 0))).containsOnly(0f);
        int glowing = 0;
        for (int i = 0; i < SIZE * SIZE; i++) {
            int x = i % SIZE;
            int y = i / SIZE;
            if (film.red(x, y) != 0) {
                assertThat(List.of(film.red(x, y), film.green(x, y), film.blue(x, y))).containsExactly(red, green, blue);
                glowing++;
            }
        }
        // The silhouette's radius is tan(asin(1/6))/tan(15°) of half the picture.
        double radius = Math.tan(Math.asin(1 / 6.0)) / Math.tan(Math.toRadians(15)) * SIZE / 2;
        assertThat((double) glowing).isBetween(Math.PI * (radius - 1) * (radius - 1), Math.PI * (radius + 1) * (radius + 1));
        try (WorkerPool workers = new WorkerPool(1); Renderer renderer = new Renderer(RenderOptions.DEFAULT.withThreads(1))) {
            FilmAssert.assertSameBits(new TraditionalTracer(scene).trace(workers, Progress.NONE).film(), film, "traditional");
            renderer.render(scene, Progress.NONE);
            FilmAssert.assertSameBits(renderer.film(), film, "cached");
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 0.3, 1, 1e6})
    void glowingSphere_showsItsGlowAtAnyAmbience(double ambience) {
        assertBall(scene(NEON, ambience), 0.7f, 300, 1e6f);
        assertBall(scene(NEON.withModel(ShadingModel.METALLIC), ambience), 0.7f, 300, 1e6f);
    }

    @Test
    void ambientLight_isAddedToGlow() {
        assertBall(scene(NEON.withAmbient(Rgb.gray(0.5)), 8), 4 + 0.7f, 304, 1e6f + 4);
    }

    @Test
    void mirror_showsTheUnreflectedShareOfItsGlow() {
        assertBall(scene(NEON.withReflective(Rgb.gray(0.25)), 1), 0.75f * 0.7f, 225, 0.75f * 1e6f);
    }

    /** A thin surface with the index of air reflects nothing; half of its body is visible. */
    @Test
    void halfClearSurface_showsHalfItsGlow() {
        Transmission half = Transmission.NONE.withColor(Rgb.gray(0.5)).withIor(1).withThin(true);
        Scene scene = scene(NEON.withTransmission(half), 1);
        // The front, and half of the back.
        assertBall(scene, 0.75f * 0.7f, 225, 0.75f * 1e6f);
        assertBall(scene.withPicture(scene.picture().withDepth(0)), 0.5f * 0.7f, 150, 0.5f * 1e6f);
    }

    @Test
    void texture_doesNotMultiplyGlow() {
        var black = new TextureMap("black.png", 1, 1, new Texture(1, 1, new float[3]));
        assertBall(scene(NEON.withTexture(Optional.of(black)), 1), 0.7f, 300, 1e6f);
    }

    private static Optional<TextureMap> map(float... rgb) {
        return Optional.of(new TextureMap("map.png", 1, 1, new Texture(rgb.length / 3, 1, rgb)));
    }

    @Test
    void glowMap_multipliesGlowButNotAmbientLight() {
        Material mapped = NEON.withGlowMap(map(0.5f, 0.25f, 1));
        assertBall(scene(mapped, 1), 0.5f * 0.7f, 75, 1e6f);
        assertBall(scene(mapped.withModel(ShadingModel.METALLIC), 1), 0.5f * 0.7f, 75, 1e6f);
        assertBall(scene(mapped.withAmbient(Rgb.gray(0.5)), 8), 4 + 0.5f * 0.7f, 79, 1e6f + 4);
    }

    @Test
    void glowMap_andTextureAreIndependent() {
        Material mapped = NEON.withTexture(map(0, 0, 0)).withGlowMap(map(0.5f, 0.25f, 1));
        assertBall(scene(mapped, 1), 0.5f * 0.7f, 75, 1e6f);
        assertBall(scene(mapped.withReflective(Rgb.gray(0.25)), 1), 0.75f * (0.5f * 0.7f), 56.25f, 0.75f * 1e6f);
    }

    @Test
    void halfClearSurface_showsHalfOfItsMappedGlow() {
        Transmission half = Transmission.NONE.withColor(Rgb.gray(0.5)).withIor(1).withThin(true);
        Scene scene = scene(NEON.withTransmission(half).withGlowMap(map(0.5f, 0.25f, 1)), 1);
        assertBall(scene, 0.75f * (0.5f * 0.7f), 56.25f, 0.75f * 1e6f);
        assertBall(scene.withPicture(scene.picture().withDepth(0)), 0.5f * (0.5f * 0.7f), 37.5f, 0.5f * 1e6f);
    }

    @Test
    void editOfGlowMap_castsNoRay() {
        Scene before = scene(NEON, 1);
        Scene after = scene(NEON.withGlowMap(map(0.5f, 0.25f, 1)), 1);
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT.withThreads(1))) {
            for (Scene scene : List.of(before, after, scene(NEON.withTexture(map(0, 1, 0)).withGlowMap(map(1, 0, 1)), 1), before)) {
                UpdateResult update = renderer.render(scene, Progress.NONE);
                boolean isFirst = update.rays().eye() > 0;
                assertThat(isFirst ? 0 : update.rays().eye() + update.rays().mirrored() + update.rays().shadow()).isZero();
                FilmAssert.assertSameBits(renderer.film(), new ReferenceTracer(scene).trace(), "edited");
            }
        }
    }

    @Test
    void editOfGlow_castsNoRay() {
        Scene before = scene(NEON.withReflective(Rgb.gray(0.25)), 1);
        Scene after = scene(NEON.withReflective(Rgb.gray(0.25)).withGlow(new Rgb(1, 2, 4)), 1);
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT.withThreads(1))) {
            renderer.render(before, Progress.NONE);
            UpdateResult update = renderer.render(after, Progress.NONE);
            assertThat(update.rays().eye() + update.rays().mirrored() + update.rays().shadow()).isZero();
            assertThat(update.rowsTouched()).isZero();
            FilmAssert.assertSameBits(renderer.film(), new ReferenceTracer(after).trace(), "edited");
        }
        assertBall(after, 0.75f, 1.5f, 3);
    }
}
