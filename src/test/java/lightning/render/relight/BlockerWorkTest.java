package lightning.render.relight;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.format.jen.JenException;
import lightning.format.jen.JenReader;
import lightning.render.RenderOptions;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.render.image.Film;
import lightning.render.image.FilmAssert;
import lightning.render.relight.paper.MirrorStorage;
import lightning.render.relight.paper.ReflectionMode;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.scene.Camera;
import lightning.scene.IndirectSettings;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.material.Material;
import lightning.scene.material.ShadowCasting;
import lightning.scene.material.Transmission;
import lightning.scene.node.SceneNode;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.Placement;
import lightning.scene.value.ShapeLinks;
import org.junit.jupiter.api.Test;

/** Tests objects that cast shadows only. The picture is a mirroring floor; a card hangs above its left half, below the camera. */
class BlockerWorkTest {
    private static final int SIDE = 64;

    private static Scene scene() {
        return new Scene(new PictureSettings(SIDE, SIDE, 1), new Camera(new Vec3(0, 10, 0), Vec3.ZERO, new Vec3(0, 0, -1), 20),
                World.DEFAULT.withBackground(Rgb.gray(0.25)),
                List.of(Material.of("floor").withDiffuse(Rgb.gray(0.5)).withReflective(Rgb.gray(0.5)),
                        Material.of("card").withTransmission(Transmission.NONE.withShadows(ShadowCasting.ONLY))),
                List.of(square("floor", "floor", Vec3.ZERO, 40), square("blocker", "card", new Vec3(-1, 5, 0), 0.5)),
                List.of(Light.of("sun", LightType.DIRECTIONAL).withDirection(new Vec3(0, -1, 0)),
                        Light.of("other", LightType.DIRECTIONAL).withDirection(new Vec3(0, -1, 0)).withIntensity(0.5)));
    }

    private static Shape square(String name, String material, Vec3 at, double size) {
        return new Shape(Solid.PLANE, name, material, new Placement(at, Vec3.ZERO, new Vec3(size, 1, size)));
    }

    private static StudioRenderer studio() {
        return new StudioRenderer(ReflectionMode.CURRENT, MirrorStorage.FULL_ROWS, scene());
    }

    private static Film traced(Scene scene) {
        try (WorkerPool workers = new WorkerPool(2)) {
            return new TraditionalTracer(scene).trace(workers, Progress.NONE).film();
        }
    }

    private static UpdateResult edit(StudioRenderer studio, UnaryOperator<Scene> edit) {
        UpdateResult update = studio.render(edit.apply(studio.scene()));
        FilmAssert.assertSameBits(studio.renderer().film(), new ReferenceTracer(studio.scene()).trace(), "blocker-work");
        return update;
    }

    private static Scene moved(Scene scene, double x) {
        SceneNode card = scene.stage().node("blocker").orElseThrow();
        return scene.withNode("blocker", card.withPlacement(new Placement(new Vec3(x, 5, 0), Vec3.ZERO, card.placement().scale())));
    }

    /** Looks at the floor from below the card. */
    private static Scene below() {
        return scene().withCamera(new Camera(new Vec3(0, 4, 0), Vec3.ZERO, new Vec3(0, 0, -1), 40));
    }

    /** A picture of the shadow alone, without the card or its reflection, is that of an ordinary card behind the camera, without mirrors. */
    @Test
    void blocker_castsTheShadowOfACard() {
        Scene matte = below().withMaterial(below().material("floor").orElseThrow().withReflective(Rgb.BLACK));
        Scene card = matte.withMaterial(Material.of("card"));
        FilmAssert.assertSameBits(new ReferenceTracer(matte).trace(), new ReferenceTracer(card).trace(), "blocker-shadow");
    }

    @Test
    void cameraAndMirrors_doNotSeeBlocker() {
        Scene unshadowed = scene().withLights(scene().lights().stream().map(l -> l.withShadowedBy(ShapeLinks.NONE)).toList());
        Scene empty = unshadowed.withNodes(List.of(unshadowed.nodes().getFirst()));
        FilmAssert.assertSameBits(new ReferenceTracer(unshadowed).trace(), new ReferenceTracer(empty).trace(), "unseen-blocker");
    }

    @Test
    void fullTrace_equalsReference() {
        FilmAssert.assertSameBits(traced(scene()), new ReferenceTracer(scene()).trace(), "blocker-full");
    }

    @Test
    void sceneOfBlockersAlone_isBackground() {
        Scene alone = scene().withNodes(List.of(scene().nodes().getLast()));
        assertThat(new ReferenceTracer(alone).pixel(5, 5)).isEqualTo(new float[] {0.25f, 0.25f, 0.25f});
        FilmAssert.assertSameBits(traced(alone), new ReferenceTracer(alone).trace(), "only-blockers");
    }

    @Test
    void movedBlocker_castsShadowRaysOnly() {
        try (StudioRenderer studio = studio()) {
            UpdateResult update = edit(studio, s -> moved(s, -0.5));
            assertThat(update.rays().eye() + update.rays().mirrored()).as(update.plan().description()).isZero();
            assertThat(update.rays().shadow()).isPositive().isLessThan(SIDE * SIDE);
        }
    }

    @Test
    void linkedBlocker_shadowsItsLightOnly() {
        try (StudioRenderer studio = studio()) {
            edit(studio, s -> s.withLight(s.light("other").orElseThrow().withShadowedBy(ShapeLinks.NONE)));
            Optional<Light> sun = studio.scene().light("sun");
            float[] shaded = new ReferenceTracer(studio.scene()).pixel(SIDE / 4, SIDE / 2);
            float[] without = new ReferenceTracer(studio.scene().withLight(sun.orElseThrow().withOn(false))).pixel(SIDE / 4, SIDE / 2);
            assertThat(shaded).isEqualTo(without);
            UpdateResult update = edit(studio, s -> moved(s, -0.6));
            assertThat(update.rays().shadow()).isPositive().isLessThan(SIDE * SIDE);
        }
    }

    @Test
    void cardThatBecomesABlocker_isSeenNoMore() {
        try (StudioRenderer studio = studio()) {
            edit(studio, s -> s.withMaterial(Material.of("card").withDiffuse(new Rgb(0.8, 0.1, 0.1))));
            edit(studio, s -> s.withMaterial(Material.of("card").withTransmission(Transmission.NONE.withShadows(ShadowCasting.ONLY))));
            edit(studio, s -> moved(s, 0.25));
        }
    }

    @Test
    void movedBlocker_shadowsFogAndLeavesItsDepths() {
        Scene foggy = scene().withWorld(scene().world().withFog(scene().world().fog().withDensity(0.05)));
        try (StudioRenderer studio = new StudioRenderer(ReflectionMode.CURRENT, MirrorStorage.FULL_ROWS, foggy)) {
            edit(studio, s -> s.withLight(s.light("sun").orElseThrow().withOn(false)));
            edit(studio, s -> moved(s, -0.5));
            edit(studio, s -> s.withLight(s.light("sun").orElseThrow().withOn(true)));
            edit(studio, s -> moved(s, 0.7));
        }
    }

    @Test
    void indirectLight_passesBlocker() {
        Scene lit = scene().withPicture(scene().picture().withIndirect(Optional.of(IndirectSettings.DEFAULT)));
        try (StudioRenderer studio = new StudioRenderer(ReflectionMode.CURRENT, MirrorStorage.FULL_ROWS, lit)) {
            edit(studio, s -> moved(s, -0.5));
            edit(studio, s -> s.withLight(s.light("sun").orElseThrow().withIntensity(2)));
        }
    }

    /** Rays end on the sphere by rounding only, so no row is in its own shadow; a far object changes the rounding. */
    @Test
    void lightOfABlocker_isNotBlockedByIt() throws JenException {
        String text = """
                jen 1
                picture { size 40 30 }
                camera { from 0 3 6  to 0 0 0  fov 40 }
                world { ambience 0 }
                material card { shadows only }
                sphere lamp { material card  at 0 1.5 0 }
                plane floor { scale 8 1 8 }
                light glow object { shape lamp }
                """;
        Scene lit = JenReader.read(text, "lamp", Path.of(".")).scene();
        Scene far = JenReader.read(text + "sphere star { material card  at 1e7 0 0 }\n", "far", Path.of(".")).scene();
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT.withThreads(1))) {
            for (Scene scene : List.of(lit, far, lit)) {
                renderer.render(scene, Progress.NONE);
                FilmAssert.assertSameBits(renderer.film(), new ReferenceTracer(scene).trace(), "light-of-a-blocker");
            }
            assertThat(renderer.film().red(20, 20)).isPositive();
        }
    }
}
