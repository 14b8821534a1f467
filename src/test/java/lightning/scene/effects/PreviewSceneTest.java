package lightning.scene.effects;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.render.image.Film;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.scene.Camera;
import lightning.scene.GatherSettings;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.Stage;
import lightning.scene.World;
import lightning.scene.asset.Environment;
import lightning.scene.asset.EnvironmentMap;
import lightning.scene.light.Light;
import lightning.scene.light.LightAttribute;
import lightning.scene.light.LightRig;
import lightning.scene.light.LightType;
import lightning.scene.material.Material;
import lightning.scene.material.ShadingModel;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.Placement;
import lightning.scene.value.SceneLimits;
import lightning.scene.value.ShapeLinks;
import org.junit.jupiter.api.Test;

class PreviewSceneTest {
    private static final Camera CAMERA = new Camera(new Vec3(0, 0, 6), Vec3.ZERO, Vec3.Y, 30);

    private static Scene ball(Material material, World world, Light... lights) {
        return new Scene(new PictureSettings(9, 9, 0), CAMERA, world, new Stage(List.of(material),
                List.of(new Shape(Solid.SPHERE, "ball", material.name(), Placement.IDENTITY))), LightRig.of(List.of(lights)));
    }

    private static Rgb middle(Scene scene) {
        ViewEffects effects = ViewEffects.PREVIEW.with(RenderEffect.REFLECTION, PreviewScene.showsReflections(scene));
        Film film = new ReferenceTracer(effects.apply(scene)).trace();
        return new Rgb(film.red(4, 4), film.green(4, 4), film.blue(4, 4));
    }

    private static Light environmentLight() {
        return Light.of("lamp", LightType.POINT).withPosition(new Vec3(3, 3, 6));
    }

    @Test
    void shadows_areThoseOfOneLight() {
        Light key = environmentLight().withName("key");
        Scene scene = ball(Material.of("matt"), World.DEFAULT, environmentLight(), key);
        PreviewScene.Request request = new PreviewScene().request(scene, "key", ViewEffects.PREVIEW, true);
        Scene shown = request.scene();
        assertThat(request.effects().shows(RenderEffect.SHADOWS)).isTrue();
        assertThat(request.effects().shows(RenderEffect.REFLECTION)).as("at depth 0").isFalse();
        Scene deep = scene.withPicture(scene.picture().withDepth(2));
        assertThat(new PreviewScene().request(deep, "key", ViewEffects.PREVIEW, false))
                .isEqualTo(new PreviewScene.Request(deep, ViewEffects.PREVIEW.with(RenderEffect.REFLECTION, true)));
        assertThat(shown.light("key").orElseThrow()).isEqualTo(key);
        assertThat(LightAttribute.SHADOWED_BY.get(shown.light("lamp").orElseThrow())).isEqualTo(ShapeLinks.NONE);
    }

    @Test
    void blurredReflections_gatherNoLightAndLeaveTheirColor() {
        Material brass = Material.of("brass").withModel(ShadingModel.PRINCIPLED).withBase(new Rgb(1, 0.7, 0.3)).withMetalness(1)
                .withRoughness(0.4);
        for (int depth : new int[] {0, 2}) {
            Scene scene = ball(brass, World.DEFAULT, environmentLight());
            Scene shown = new PreviewScene().of(scene.withPicture(scene.picture().withDepth(depth)));
            assertThat(GatherSettings.of(shown)).as("depth %d", depth).isEmpty();
            assertThat(middle(shown).r()).isGreaterThan(0.05);
        }
    }

    @Test
    void metal_hasItsColor() {
        Material gold = Material.of("gold").withModel(ShadingModel.METALLIC).withBase(new Rgb(1, 0.7, 0.3)).withMetalness(1)
                .withRoughness(0.1);
        Scene scene = ball(gold, World.DEFAULT.withAmbience(0), environmentLight());
        assertThat(middle(scene).g()).as("of the scene itself").isLessThan(0.05);
        Rgb shown = middle(new PreviewScene().of(scene));
        assertThat(shown.g()).isBetween(0.2, 0.7);
        assertThat(shown.r()).isGreaterThan(1.2 * shown.g());
        assertThat(shown.b()).isLessThan(0.6 * shown.g());
    }

    @Test
    void mirror_isNotDark() {
        Material mirror = Material.of("mirror").withDiffuse(Rgb.BLACK).withReflective(new Rgb(0.8, 0.8, 0.8));
        Scene scene = ball(mirror, World.DEFAULT.withAmbience(0), environmentLight());
        assertThat(middle(new PreviewScene().of(scene)).g()).isGreaterThan(0.15);
    }

    @Test
    void mirror_showsBackground() {
        Material mirror = Material.of("mirror").withDiffuse(Rgb.BLACK).withReflective(new Rgb(0.8, 0.8, 0.8));
        Scene flat = ball(mirror, World.DEFAULT.withAmbience(0).withBackground(new Rgb(0.1, 0.2, 0.5)));
        Scene scene = flat.withPicture(flat.picture().withDepth(5));
        Rgb shown = middle(new PreviewScene().of(scene));
        assertThat(shown.r()).isCloseTo(0.08, within(1e-6));
        assertThat(shown.b()).isCloseTo(0.4, within(1e-6));
        assertThat(new PreviewScene().of(scene).picture().depth()).isEqualTo(3);
        Scene glass = ball(mirror.withTransmission(mirror.transmission().withColor(Rgb.WHITE)), World.DEFAULT);
        assertThat(new PreviewScene().of(glass.withPicture(scene.picture())).picture().depth()).as("of glass").isEqualTo(5);
        assertThat(new PreviewScene().of(scene.withPicture(flat.picture().withDepth(1))).picture().depth()).isEqualTo(1);
    }

    @Test
    void environment_neverOverexposesWhite() {
        float[] rgb = new float[3 * 8 * 4];
        Arrays.fill(rgb, 40f);
        World bright =
                World.DEFAULT.withAmbience(0).withEnvironment(Optional.of(new Environment("sky.hdr", new EnvironmentMap(8, 4, rgb))));
        Scene scene = ball(Material.of("paper").withAmbient(Rgb.BLACK).withDiffuse(new Rgb(1, 1, 1)), bright);
        assertThat(middle(scene).g()).isGreaterThan(10);
        assertThat(middle(new PreviewScene().of(scene)).g()).isBetween(0.6, 1.0);
        assertThat(new PreviewScene().of(scene).world().own().intensity()).as("image of the environment").isEqualTo(1);
    }

    /** A floor below a ball and a lamp: the point in the ball's shadow gets the environment's light only, which nothing shadows. */
    @Test
    void environment_lightsWithoutShadows_andSelectedLightHasItsOwn() {
        float[] rgb = new float[3 * 8 * 4];
        Arrays.fill(rgb, 0.2f);
        World sky = World.DEFAULT.withAmbience(0).withOwn(own -> own.withLightCount(8))
                .withEnvironment(Optional.of(new Environment("sky.hdr", new EnvironmentMap(8, 4, rgb))));
        Material paper = Material.of("paper").withAmbient(Rgb.BLACK).withDiffuse(new Rgb(1, 1, 1));
        Light lamp = Light.of("environment 3", LightType.POINT).withPosition(new Vec3(0, 4, 0));
        Scene scene = new Scene(new PictureSettings(9, 9, 0), new Camera(new Vec3(0, 1, 9), new Vec3(0, 0, 0), Vec3.Y, 1), sky,
                new Stage(List.of(paper),
                        List.of(new Shape(Solid.PLANE, "floor", "paper", new Placement(Vec3.ZERO, Vec3.ZERO, new Vec3(9, 1, 9))),
                                new Shape(Solid.SPHERE, "ball", "paper", new Placement(new Vec3(0, 2, 0), Vec3.ZERO, Vec3.ONE)))),
                LightRig.of(List.of(lamp)));
        double shadowed = preview(scene, lamp.name());
        double open = preview(scene, "");
        double environmentOnly = preview(scene.withLights(List.of()), "");
        assertThat(shadowed).isPositive().isCloseTo(environmentOnly, within(1e-6));
        assertThat(open).isGreaterThan(1.2 * shadowed);
    }

    private static double preview(Scene scene, String shadowLight) {
        PreviewScene.Request request = new PreviewScene().request(scene, shadowLight, ViewEffects.PREVIEW, true);
        return new ReferenceTracer(request.effects().apply(request.scene())).trace().green(4, 4);
    }

    @Test
    void environmentBesideManyLights_addsNone() {
        Environment sky = new Environment("sky.hdr", new EnvironmentMap(8, 4, new float[3 * 8 * 4]));
        Light[] lights = IntStream.range(0, SceneLimits.MAX_LIGHTS).mapToObj(i -> environmentLight().withName("lamp " + i))
                .toArray(Light[]::new);
        Scene scene = ball(Material.of("paper"), World.DEFAULT, lights);
        Scene lit = scene.withWorld(scene.world().withEnvironment(Optional.of(sky)));
        assertThat(new PreviewScene().of(lit).lights()).hasSize(SceneLimits.MAX_LIGHTS);
    }

    @Test
    void sceneWithoutMirrorsOrEnvironment_isUnchanged() {
        Scene scene = ball(Material.of("matt"), World.DEFAULT, environmentLight());
        assertThat(new PreviewScene().of(scene)).isEqualTo(scene);
        assertThat(new PreviewScene().of(scene).stage()).isSameAs(scene.stage());
    }
}
