package lightning.render.relight;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.format.jen.JenReader;
import lightning.render.image.FilmAssert;
import lightning.render.relight.paper.Accuracy;
import lightning.render.relight.paper.MirrorStorage;
import lightning.render.relight.paper.ReflectionMode;
import lightning.render.shading.layer.LightRows;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.node.SceneNode;
import lightning.scene.node.Shape;
import lightning.scene.value.Attenuation;
import lightning.scene.value.BarnDoors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Tests that a layer which several edits made up equals that of a full trace: with terms that are known for some of its rows, with rows of
 * shapes that came later, and with shadow rays that were cast before.
 */
class LayerUpdateTest {
    /** Floor and ball in one tile. The spot lights the ball only. */
    private static final String STUDIO = """
            jen 1
            picture { size 32 24  depth 0 }
            camera { from 0 2 8  to 0 0 0 }
            material matt { diffuse 0.7 0.7 0.7 }
            material shiny { diffuse 0.5 0.5 0.5  specular 0.4 0.4 0.4  shininess 2 }
            material metal { model metallic  base 0.8 0.6 0.3  metalness 0.5  roughness 0.4 }
            plane floor { material matt  at 0 -1 0  scale 9 1 9 }
            sphere ball { material matt }
            sphere more { material matt  at 2.2 0 0  scale 0.7 0.7 0.7  visible no }
            light key spot { at 0.5 4 1.5  direction -0.5 -4 -1.5  angle 12  dropoff 1  attenuation 0.2 0.1 0.05 }
            """;

    private static Scene read(String text) {
        try {
            return JenReader.read(text, "layers.jen", Path.of("")).scene();
        } catch (Exception e) {
            throw new IllegalStateException(e);
        }
    }

    private static StudioRenderer studio(Scene scene) {
        return new StudioRenderer(ReflectionMode.CURRENT, MirrorStorage.FULL_ROWS, scene);
    }

    private static UpdateResult render(StudioRenderer studio, Scene scene) {
        UpdateResult update = studio.render(scene);
        FilmAssert.assertSameBits(studio.renderer().film(), new ReferenceTracer(scene).trace(), "layer-update");
        return update;
    }

    private static UpdateResult light(StudioRenderer studio, UnaryOperator<Light> edit) {
        return render(studio, studio.scene().withLights(studio.scene().lights().stream().map(edit).toList()));
    }

    private static UpdateResult node(StudioRenderer studio, String name, UnaryOperator<SceneNode> edit) {
        return render(studio, studio.scene().withNode(name, edit.apply(studio.scene().stage().node(name).orElseThrow())));
    }

    private static Scene withMaterialOf(Scene scene, String shape, String material) {
        return scene.withNode(shape, ((Shape) scene.stage().node(shape).orElseThrow()).withMaterial(material));
    }

    private static void assertMemoryOfFirstPass(StudioRenderer studio) {
        try (StudioRenderer fresh = studio(studio.scene())) {
            assertThat(studio.renderer().cache().bytes()).isEqualTo(fresh.renderer().cache().bytes());
        }
    }

    /** The rows have no falloff of their own as long as the light does not reach them. */
    @Test
    void shapeShownOutsideCone_hasFalloffWhenConeReachesIt() {
        try (StudioRenderer studio = studio(read(STUDIO))) {
            node(studio, "more", shape -> shape.withVisible(true));
            light(studio, l -> l.withAngle(60));
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"shiny", "metal"})
    void shownShapeOfOtherMaterial_bringsItsTerms(String material) {
        Scene scene = withMaterialOf(read(STUDIO.replace("angle 12", "angle 70")), "more", material);
        try (StudioRenderer studio = studio(scene)) {
            node(studio, "more", shape -> shape.withVisible(true));
            assertMemoryOfFirstPass(studio);
            node(studio, "more", shape -> shape.withVisible(false));
        }
    }

    @ParameterizedTest
    @EnumSource(LightType.class)
    void shownShape_takesMemoryOfFirstPass(LightType type) {
        Scene scene = read(STUDIO.replace("angle 12", "angle 70"));
        try (StudioRenderer studio = studio(scene.withLight(scene.lights().getFirst().withType(type)))) {
            node(studio, "more", shape -> shape.withVisible(true));
            assertMemoryOfFirstPass(studio);
        }
    }

    /** Shadow rays of rows outside the cone are forgotten if a shape in their path changes. */
    @Test
    void shapeHiddenWhileItsShadowIsOutsideCone_leavesNoShadow() {
        try (StudioRenderer studio = studio(read(STUDIO.replace("angle 12", "angle 60")))) {
            light(studio, l -> l.withAngle(2));
            node(studio, "ball", shape -> shape.withVisible(false));
            light(studio, l -> l.withAngle(60));
            light(studio, l -> l.withAngle(2));
            node(studio, "ball", shape -> shape.withVisible(true));
            light(studio, l -> l.withAngle(60));
        }
    }

    /** Eight lights without highlights store cosine times falloff. The shape is outside the picture, so that no row is traced again. */
    @Test
    void movedShadowUnderManyLights_keepsFalloffs() {
        String lights = IntStream.range(0, 8)
                .mapToObj(i -> "light l" + i + " point { at " + (i - 4) + " 9 2  attenuation 0.2 0.1 0.05 }\n")
                .collect(Collectors.joining());
        Scene scene = read(STUDIO.replaceFirst("(?s)light key.*", "sphere above { material matt  at 0 6 1 }\n" + lights));
        try (StudioRenderer studio = studio(scene)) {
            LightRows layer = (LightRows) studio.renderer().cache().tile(0).levels()[0].layers()[0];
            assertThat(layer.kind()).isEqualTo(LightRows.Kind.PREMULTIPLIED);
            UpdateResult update =
                    node(studio, "above", shape -> shape.withPlacement(shape.placement().withPosition(new Vec3(0.6, 6, 1))));
            assertThat(update.rays().eye()).isZero();
            assertThat(update.rays().shadow()).isPositive();
        }
    }

    /**
     * Four tiles side by side, with two balls each in the left and the right half. The material of one half changes while the cone grows
     * over all.
     */
    @ParameterizedTest
    @ValueSource(strings = {"left", "right"})
    void shininessInOneHalfAndLargerCone_keepHighlightsOfOther(String side) {
        Scene scene = read("""
                jen 1
                picture { size 128 32  depth 0 }
                camera { from 0 14 0  to 0 0 0  up 0 0 -1  fov 25 }
                material floor { diffuse 0.5 0.5 0.5  specular 0.4 0.4 0.4  shininess 1 }
                material left { diffuse 0.5 0.5 0.5  specular 0.4 0.4 0.4  shininess 2 }
                material right { diffuse 0.5 0.5 0.5  specular 0.4 0.4 0.4  shininess 2 }
                plane floor { material floor  scale 20 1 20 }
                sphere left { material left  at -2.5 0 0 }
                sphere left2 { material left  at -9 0 0 }
                sphere right { material right  at 2.5 0 0 }
                sphere right2 { material right  at 9 0 0 }
                light key spot { at 0 12 0  direction 0 -1 0  angle 34 }
                """);
        try (StudioRenderer studio = studio(scene)) {
            Scene shinier = scene.withMaterial(scene.material(side).orElseThrow().withShininess(5));
            render(studio, shinier.withLight(scene.lights().getFirst().withAngle(60)));
        }
    }

    /** All rows are lit then, so that they share one state. */
    @Test
    void coneGrownOverAllRows_takesMemoryOfFirstPass() {
        try (StudioRenderer studio = studio(read(STUDIO.replace("sphere ball { material matt }", "")))) {
            light(studio, l -> l.withAngle(80));
            assertMemoryOfFirstPass(studio);
        }
    }

    @Test
    void doorsOverFullTile_equalFullTrace() {
        Scene scene = read("""
                jen 1
                picture { size 32 32  depth 0 }
                camera { from 0 10 0  to 0 0 0  up 0 0 -1 }
                plane floor { scale 20 1 20 }
                light key spot { at 0 8 0  direction 0 -1 0  angle 60 }
                """);
        try (StudioRenderer studio = studio(scene)) {
            light(studio, l -> l.withDoors(new BarnDoors(5, 20, 90, 8)));
        }
    }

    @Test
    void scaledAngleAndAttenuation_takeMemoryOfFirstPass() {
        try (StudioRenderer studio = studio(read(STUDIO))) {
            light(studio, l -> l.withAngle(70).withAttenuation(Attenuation.NONE));
            assertMemoryOfFirstPass(studio);
        }
    }

    @Test
    void accuracySwitchedToExact_updatesTerms() {
        Scene scene = read(STUDIO);
        try (StudioRenderer studio = studio(scene)) {
            Renderer renderer = studio.renderer();
            renderer.setOptions(renderer.options().withAccuracy(Accuracy.RATIO));
            renderer.render(scene, Progress.NONE);
            renderer.setOptions(renderer.options().withAccuracy(Accuracy.EXACT));
            UpdateResult switched = renderer.render(scene, Progress.NONE);
            long lit = studio.referenceRows().count(0, studio.referenceRows().isLit(scene.lights().getFirst()));
            assertThat(switched.rowsTouched()).isEqualTo(lit);
            assertThat(((LightRows) renderer.cache().tile(0).levels()[0].layers()[0]).kind()).isEqualTo(LightRows.Kind.SEPARATE);
            light(studio, l -> l.withAngle(60));
        }
    }
}
