package lightning.editor.window.preview;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import lightning.base.math.Vec3;
import lightning.base.work.Await;
import lightning.base.work.Progress;
import lightning.document.DeskScene;
import lightning.document.manipulation.PreviewCamera;
import lightning.format.jen.JenException;
import lightning.format.jen.JenReader;
import lightning.render.RenderOptions;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.render.relight.Renderer;
import lightning.scene.Scene;
import lightning.scene.asset.Texture;
import lightning.scene.asset.TextureMap;
import lightning.scene.effects.ViewEffects;
import lightning.scene.light.FaceVisibility;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

class PreviewLoopTest {
    private static final int WIDTH = 60;
    private static final int HEIGHT = 50;
    private static final Scene SCENE = scene();

    private final BlockingQueue<PreviewLoop.Picture> pictures = new LinkedBlockingQueue<>();
    private final BlockingQueue<Throwable> problems = new LinkedBlockingQueue<>();
    private final PreviewLoop loop = new PreviewLoop(pictures::add, problems::add);

    private static Scene scene() {
        try {
            return JenReader.read("""
                    jen 1
                    picture { size 40 30  depth 2 }
                    camera { from 0 2 9  to 0 1 0  fov 40 }
                    material mirror { diffuse 0.5 0.5 0.5  reflective 0.4 0.4 0.4 }
                    plane ground { material mirror  scale 20 1 20 }
                    sphere ball { at 0 1 0 }
                    light key spot { intensity 1  at 3 5 2  direction -3 -4 -2  angle 25  dropoff 4 }
                    """, "preview.jen", Path.of("")).scene();
        } catch (JenException e) {
            throw new AssertionError(e);
        }
    }

    @AfterEach
    void close() {
        loop.close();
        assertThat(problems).isEmpty();
    }

    private static PreviewLoop.Request request(Scene scene, PreviewCamera camera, boolean moving) {
        return request(scene, camera, ViewEffects.PREVIEW, moving);
    }

    private static PreviewLoop.Request request(Scene scene, PreviewCamera camera, ViewEffects effects, boolean moving) {
        return new PreviewLoop.Request(scene, camera, WIDTH, HEIGHT, ViewTransform.DEFAULT, effects, moving, null, null);
    }

    private PreviewLoop.Picture next() throws InterruptedException {
        PreviewLoop.Picture picture = pictures.poll(Await.TIMEOUT_SECONDS, TimeUnit.SECONDS);
        assertThat(picture).as("a picture").isNotNull();
        return picture;
    }

    /** Returns the pixels that the preview must show. */
    private static int[] expected(Scene scene, PreviewCamera camera) {
        return expected(scene, camera, ViewEffects.PREVIEW);
    }

    private static int[] expected(Scene scene, PreviewCamera camera, ViewEffects effects) {
        Scene seen = scene.withCamera(camera.camera()).withPicture(scene.picture().withSize(WIDTH, HEIGHT));
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT.withView(effects).withThreads(1))) {
            renderer.render(seen, Progress.NONE);
            return ViewTransform.DEFAULT.toPixels(renderer.film());
        }
    }

    @Test
    void stillView_isSharp() throws InterruptedException {
        PreviewCamera camera = PreviewCamera.of(SCENE);
        loop.draw(request(SCENE, camera, false));
        PreviewLoop.Picture picture = next();
        assertThat(picture.isSharp()).isTrue();
        assertThat(picture.pixels()).isEqualTo(expected(SCENE, camera));
    }

    @Test
    void lightEdit_equalsFreshRender() throws InterruptedException {
        PreviewCamera camera = PreviewCamera.alongX(SCENE);
        loop.draw(request(SCENE, camera, false));
        next();
        Scene edited = DeskScene.parameter("angle").set(SCENE, "key", 40).sceneOr(SCENE);
        loop.draw(request(edited, camera, false));
        assertThat(next().pixels()).isEqualTo(expected(edited, camera));
    }

    @Test
    void preview_hasTheMeanBrightnessOfTheTracedPicture() throws InterruptedException {
        Scene bright = DeskScene.parameter("intensity").set(SCENE, "key", 0.9).sceneOr(SCENE);
        Scene dark = DeskScene.parameter("intensity").set(SCENE, "key", 0.3).sceneOr(SCENE);
        PreviewCamera camera = PreviewCamera.of(SCENE);
        Film traced = film(dark, camera, ViewEffects.ALL);
        loop.draw(new PreviewLoop.Request(bright, camera, WIDTH, HEIGHT, ViewTransform.DEFAULT, ViewEffects.PREVIEW, false, null, traced));
        double target = mean(ViewTransform.DEFAULT.toPixels(traced));
        assertThat(mean(next().pixels())).isCloseTo(target, Offset.offset(0.03 * target));
        assertThat(mean(expected(bright, camera))).isGreaterThan(1.3 * target);
        // Until the next traced picture, an edit changes the preview from there.
        loop.draw(request(dark, camera, false));
        assertThat(mean(next().pixels())).isLessThan(0.8 * target);
    }

    private static Film film(Scene scene, PreviewCamera camera, ViewEffects effects) {
        Scene seen = scene.withCamera(camera.camera()).withPicture(scene.picture().withSize(WIDTH, HEIGHT));
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT.withView(effects).withThreads(1))) {
            renderer.render(seen, Progress.NONE);
            return renderer.film().copy();
        }
    }

    /** Returns the mean linear green of display pixels. */
    private static double mean(int[] pixels) {
        return Arrays.stream(pixels).mapToDouble(pixel -> ViewTransform.linear(pixel >> 8 & 0xFF)).average().orElseThrow();
    }

    @Test
    void visibleLight_glowsAsInThePicture() throws InterruptedException {
        Light key = SCENE.light("key").orElseThrow();
        Light softbox = key.withType(LightType.RECT).withPosition(new Vec3(0, 2, -1)).withDirection(new Vec3(0, 0, 1))
                .withIntensity(0.4).withArea(key.area().withWidth(2).withHeight(2).withVisibility(FaceVisibility.GLOWING));
        Scene scene = SCENE.withLight(softbox);
        PreviewCamera camera = PreviewCamera.of(scene);
        loop.draw(request(scene, camera, false));
        int[] shown = next().pixels();
        int face = 14 * WIDTH + WIDTH / 2;
        assertThat(shown[face]).isEqualTo(expected(scene, camera, ViewEffects.ALL)[face])
                .isNotEqualTo(expected(SCENE, camera, ViewEffects.ALL)[face]);
    }

    /** A floor of one color under a spot: with lighting it shows the spot's pool of light, without lighting it is uniform. */
    @Test
    void texture_isLitBySpotUnlessGlowing() throws InterruptedException {
        var texture = new TextureMap("one.png", 1, 1, new Texture(1, 1, new float[] {0.5f, 0.5f, 0.5f}));
        Scene floor = SCENE.withMaterials(SCENE.materials().stream().map(m -> m.withTexture(Optional.of(texture))).toList());
        PreviewCamera camera = PreviewCamera.of(floor);
        loop.draw(request(floor, camera, false));
        int[] lit = next().pixels();
        assertThat(lit).isEqualTo(expected(floor, camera));
        loop.draw(request(floor, camera, ViewEffects.PREVIEW_1998, false));
        int[] glowing = next().pixels();
        assertThat(glowing).isEqualTo(expected(floor, camera, ViewEffects.PREVIEW_1998));
        int bottom = (HEIGHT - 1) * WIDTH;
        assertThat(Arrays.stream(glowing, bottom, bottom + WIDTH).distinct()).hasSize(1);
        assertThat(lit).isNotEqualTo(glowing);
    }

    @Test
    void movingCamera_isCoarseThenSharp() throws InterruptedException {
        PreviewCamera camera = PreviewCamera.alongX(SCENE);
        loop.draw(request(SCENE, camera, true));
        PreviewLoop.Picture moving = next();
        assertThat(moving.isSharp()).isFalse();
        assertThat(moving.pixels()).hasSize(moving.width() * moving.height());
        loop.draw(request(SCENE, camera, false));
        assertThat(next().pixels()).isEqualTo(expected(SCENE, camera));
    }

    @Test
    void manyRequests_endWithLatest() throws InterruptedException {
        PreviewCamera camera = PreviewCamera.of(SCENE);
        Scene last = SCENE;
        for (int i = 0; i < 50; i++) {
            last = DeskScene.parameter("intensity").set(SCENE, "key", i / 10.0).sceneOr(SCENE);
            loop.draw(request(last, camera, false));
        }
        PreviewLoop.Picture picture = next();
        while (picture.request().scene() != last) {
            picture = next();
        }
        assertThat(picture.pixels()).isEqualTo(expected(last, camera));
        assertThat(pictures).isEmpty();
    }
}
