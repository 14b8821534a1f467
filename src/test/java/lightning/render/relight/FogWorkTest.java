package lightning.render.relight;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.function.UnaryOperator;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.base.work.WorkerPool;
import lightning.render.RenderOptions;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.render.relight.paper.MirrorStorage;
import lightning.render.relight.paper.ReflectionMode;
import lightning.render.shading.fog.PictureFog;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.sample.ProgressRecorder;
import lightning.sample.StudioScene;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.light.LightType;
import lightning.scene.node.SceneNode;
import lightning.scene.value.Attenuation;
import lightning.scene.value.Fog;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Tests that edits of fog and of lights in it cast no ray unless a light or an object moves. */
class FogWorkTest {
    private static final Fog FOG = Fog.NONE.withDensity(0.1).withAnisotropy(0.4);

    private static StudioRenderer studio(LightType type) {
        return new StudioRenderer(ReflectionMode.CURRENT, MirrorStorage.FULL_ROWS, withFog(StudioScene.of(type), _ -> FOG));
    }

    private static Scene withFog(Scene scene, UnaryOperator<Fog> change) {
        return scene.withWorld(scene.world().withFog(change.apply(scene.world().fog())));
    }

    private static void assertNoRay(StudioRenderer studio, UpdateResult update) {
        assertThat(update.rays().total()).as(update.plan().description()).isZero();
        assertExact(studio);
    }

    private static void assertExact(StudioRenderer studio) {
        assertThat(studio.renderer().film().hasSameBits(new ReferenceTracer(studio.scene()).trace())).isTrue();
    }

    /** A picture of one tile reports nothing but fog before its end. */
    @Test
    void fog_reportsItsProgress() {
        Scene scene = withFog(StudioScene.of(LightType.POINT).withPicture(new PictureSettings(16, 16, 0)), _ -> FOG);
        ProgressRecorder first = new ProgressRecorder();
        ProgressRecorder full = new ProgressRecorder();
        try (WorkerPool workers = new WorkerPool(1); Renderer renderer = new Renderer(RenderOptions.DEFAULT.withThreads(1))) {
            renderer.render(scene, first);
            new TraditionalTracer(scene).trace(workers, full);
        }
        for (ProgressRecorder progress : List.of(first, full)) {
            List<Double> shares = progress.shares();
            assertThat(shares).isSorted().hasSizeGreaterThan(1).endsWith(1.0);
            assertThat(shares.getFirst()).isLessThan(0.3);
        }
    }

    @ParameterizedTest
    @EnumSource(LightType.class)
    void edits_ofFog_castNoRay(LightType type) {
        try (StudioRenderer studio = studio(type)) {
            assertNoRay(studio, studio.render(withFog(studio.scene(), fog -> fog.withDensity(0.3))));
            assertNoRay(studio, studio.render(withFog(studio.scene(), fog -> fog.withColor(new Rgb(1, 0.5, 0.2)))));
            assertNoRay(studio, studio.render(withFog(studio.scene(), fog -> fog.withAmbient(Rgb.gray(0.2)))));
            assertNoRay(studio, studio.render(withFog(studio.scene(), fog -> fog.withAnisotropy(-0.5))));
            assertNoRay(studio, studio.render(withFog(studio.scene(), fog -> fog.withFalloff(0.5).withHeight(1))));
            assertNoRay(studio, studio.render(withFog(studio.scene(), fog -> fog.withSize(new Vec3(5, 5, 5)))));
            assertNoRay(studio, studio.render(withFog(studio.scene(), _ -> Fog.NONE)));
        }
    }

    @ParameterizedTest
    @EnumSource(LightType.class)
    void edits_ofWeight_touchNoRow(LightType type) {
        try (StudioRenderer studio = studio(type)) {
            for (UpdateResult update : new UpdateResult[] {studio.edit(light -> light.withIntensity(3)),
                studio.edit(light -> light.withColor(new Rgb(1, 0.2, 0.1))),
                studio.edit(light -> light.withInfluence(light.influence().withFog(0.3))),
                studio.edit(light -> light.withOn(false)), studio.edit(light -> light.withOn(true))}) {
                assertThat(update.rowsTouched()).isZero();
                assertNoRay(studio, update);
            }
        }
    }

    @ParameterizedTest
    @EnumSource(value = LightType.class, names = {"POINT", "SPOT", "RECT", "DISC"})
    void attenuation_castsNoRay(LightType type) {
        try (StudioRenderer studio = studio(type)) {
            assertNoRay(studio, studio.edit(light -> light.withAttenuation(new Attenuation(0.3, 0.1, 0.2))));
        }
    }

    @Test
    void narrowerCone_castsNoRay() {
        try (StudioRenderer studio = studio(LightType.SPOT)) {
            assertNoRay(studio, studio.edit(light -> light.withAngle(0.5 * light.angle())));
        }
    }

    /** The studio's floor is a mirror: rays bounce from half of the picture. */
    @Test
    void lightInMirrors_isInThePicture() {
        try (StudioRenderer studio = studio(LightType.SPOT)) {
            PictureFog fog = studio.renderer().cache().mirrored().fog();
            assertThat(fog.rays().count()).isGreaterThan(100);
            assertThat(fog.lights()[0].visible()).contains(-1);
        }
    }

    @Test
    void sceneWithoutMirrors_hasNoFogAlongBouncedRays() {
        Scene scene = withFog(StudioScene.of(LightType.SPOT), _ -> FOG);
        Scene matte = scene.withMaterials(scene.materials().stream().map(m -> m.withReflective(Rgb.BLACK)).toList());
        try (var studio = new StudioRenderer(ReflectionMode.CURRENT, MirrorStorage.FULL_ROWS, matte)) {
            assertThat(studio.renderer().cache().mirrored().fog()).isNull();
        }
    }

    @Test
    void outdatedReflections_keepLightInFog() {
        Scene scene = withFog(StudioScene.of(LightType.SPOT), _ -> FOG);
        try (var studio = new StudioRenderer(ReflectionMode.STALE, MirrorStorage.FULL_ROWS, scene)) {
            PictureFog before = studio.renderer().cache().mirrored().fog();
            studio.edit(light -> light.withPosition(light.position().plus(new Vec3(0.5, 0, 0))));
            assertThat(studio.renderer().cache().mirrored().fog()).isSameAs(before);
            assertThat(studio.renderer().film().hasSameBits(new ReferenceTracer(studio.scene(), scene).trace())).isTrue();
        }
    }

    /** Rays that bounce from a ball that moves are tested again; all others keep their samples unless the ball is between. */
    @Test
    void movedMirror_testsFewSamplesAgain() {
        try (StudioRenderer studio = studio(LightType.POINT)) {
            long all = studio.edit(light -> light.withPosition(light.position().plus(new Vec3(0.1, 0, 0)))).rays().shadow();
            SceneNode ball = studio.scene().stage().node("mirror").orElseThrow();
            Vec3 to = ball.placement().position().plus(new Vec3(-0.1, 0, 0));
            Scene moved = studio.scene().withNode("mirror", ball.withPlacement(ball.placement().withPosition(to)));
            assertThat(studio.render(moved).rays().shadow()).isLessThan(all * 2 / 3);
            assertExact(studio);
        }
    }

    @ParameterizedTest
    @EnumSource(value = LightType.class, mode = EnumSource.Mode.EXCLUDE, names = "OBJECT")
    void movedLight_testsItsSamplesAgain(LightType type) {
        try (StudioRenderer studio = studio(type)) {
            UpdateResult update = studio.edit(light -> light.withPosition(light.position().plus(new Vec3(0.5, 0.2, 0)))
                    .withDirection(light.direction().plus(new Vec3(0.1, 0, 0.1))));
            assertThat(update.rays().shadow()).isPositive();
            assertExact(studio);
        }
    }

    @ParameterizedTest
    @EnumSource(LightType.class)
    void light_thatWasOff_isInFogOnceItShines(LightType type) {
        Scene scene = withFog(StudioScene.of(type), _ -> FOG);
        Scene off = scene.withLight(scene.light(StudioScene.KEY).orElseThrow().withOn(false));
        try (var studio = new StudioRenderer(ReflectionMode.CURRENT, MirrorStorage.FULL_ROWS, off)) {
            assertExact(studio);
            studio.render(withFog(off, fog -> fog.withDensity(0.4)));
            studio.render(withFog(scene, fog -> fog.withDensity(0.4)));
            assertExact(studio);
        }
    }
}
