package lightning.scene.paper;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.params.provider.Arguments.arguments;

import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.bench.accuracy.SceneFiles;
import lightning.render.RenderOptions;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.render.relight.Renderer;
import lightning.render.relight.UpdateResult;
import lightning.render.relight.paper.ReflectionMode;
import lightning.render.relight.plan.LayerPlan;
import lightning.render.relight.plan.LightUpdate;
import lightning.render.relight.plan.UpdatePlan;
import lightning.render.shading.RayCounts;
import lightning.render.shading.layer.ConeChange;
import lightning.render.trace.Geometry;
import lightning.sample.Nightly;
import lightning.sample.Slow;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.Attenuation;
import lightning.scene.value.Placement;
import lightning.scene.value.SceneLimits;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

class PaperCasesTest {
    private static final LightUpdate MOVED = new LightUpdate.FullRecompute(false);
    private static final LightUpdate FALLOFF = new LightUpdate.Partial(ConeChange.NONE, true, false);
    private static final LightUpdate TURNED = new LightUpdate.Partial(ConeChange.TURN, true, false);

    @Test
    void bird_hasEveryCaseInPaperOrder() {
        assertThat(PaperCases.of(SceneFiles.read("bird"))).extracting(PaperCase::name).containsExactly("color",
                "intensity", "attenuation", "angle-smaller", "angle-larger", "dropoff", "position", "direction", "type",
                "delete", "add", "ambience", "position-feet", "composite-1", "composite-2", "off", "on", "solo", "rename",
                "undo", "depth-less", "depth-more", "spot-turned", "point-to-spot", "material-color", "shininess", "reflectivity",
                "mirror-off", "mirror-on", "texture-off", "texture-on", "shape-moved", "shape-turned", "shape-scaled", "shape-hidden",
                "shape-shown");
    }

    @Test
    void sceneWithMaxLights_hasNoAddCase() {
        Scene bird = SceneFiles.read("bird");
        List<Light> lights = IntStream.range(0, SceneLimits.MAX_LIGHTS).mapToObj(i -> Light.of("l" + i, LightType.POINT)).toList();
        assertThat(PaperCases.of(bird.withLights(lights))).extracting(PaperCase::name).contains("position").doesNotContain("add");
    }

    @Test
    void bird_usesPrintedValues() {
        assertThat(edited("color", LightType.DIRECTIONAL).color()).isEqualTo(new Rgb(1, 0, 0));
        assertThat(edited("attenuation", LightType.POINT).attenuation()).isEqualTo(new Attenuation(0, 1, 1));
        assertThat(bird("ambience").before().world().ambience()).isEqualTo(1);
        assertThat(bird("ambience").after().world().ambience()).isEqualTo(0.1);
    }

    private static Light edited(String name, LightType type) {
        return bird(name).after().lights().stream().filter(l -> l.type() == type).findFirst().orElseThrow();
    }

    static Stream<Arguments> layerUpdates() {
        return Stream.of(
                arguments("color", "sun", new LightUpdate.Reweight()),
                arguments("intensity", "sun", new LightUpdate.Reweight()),
                arguments("undo", "lamp", new LightUpdate.Reweight()),
                arguments("attenuation", "lamp", FALLOFF),
                arguments("dropoff", "stage", FALLOFF),
                arguments("angle-smaller", "stage", new LightUpdate.Partial(ConeChange.ANGLE_REMOVE, false, false)),
                arguments("angle-larger", "stage", new LightUpdate.Partial(ConeChange.ANGLE_ADD, false, false)),
                arguments("position", "lamp", MOVED),
                arguments("position-feet", "lamp", MOVED),
                arguments("direction", "sun", MOVED),
                arguments("type", "sun", MOVED),
                arguments("add", "light_new", new LightUpdate.FullRecompute(true)),
                arguments("composite-1", "lamp", new LightUpdate.Partial(ConeChange.NONE, true, true)),
                arguments("composite-2", "stage", new LightUpdate.Partial(ConeChange.TURN, true, true)),
                arguments("spot-turned", "stage", TURNED),
                arguments("point-to-spot", "lamp", TURNED));
    }

    @ParameterizedTest
    @MethodSource("layerUpdates")
    void edit_updatesOnlyItsLightsLayer(String name, String light, LightUpdate expected) {
        List<LayerPlan> layers = lastPlan(bird(name)).top().layers();

        assertThat(layers).filteredOn(l -> l.light().name().equals(light)).extracting(LayerPlan::update)
                .containsExactly(expected);
        assertThat(layers).filteredOn(l -> !l.light().name().equals(light)).extracting(LayerPlan::update)
                .containsOnly(new LightUpdate.Keep());
    }

    @ParameterizedTest
    @ValueSource(strings = {"ambience", "delete", "off", "on", "solo", "rename"})
    void composingEdit_updatesNoLayer(String name) {
        assertThat(lastPlan(bird(name)).top().layers()).extracting(LayerPlan::update).containsOnly(new LightUpdate.Keep());
    }

    @Test
    void delete_dropsTheDirectionalLight() {
        assertThat(lastPlan(bird("delete")).top().droppedLights()).containsExactly("sun");
    }

    @ParameterizedTest
    @ValueSource(strings = {"color", "intensity", "attenuation", "ambience", "angle-smaller", "dropoff", "delete",
        "composite-1", "off", "on", "solo", "rename", "undo"})
    void editWithoutMovement_castsNoRay(String name) {
        assertThat(lastUpdate(bird(name)).rays()).isEqualTo(RayCounts.NONE);
    }

    @ParameterizedTest
    @ValueSource(strings = {"position", "position-feet", "direction", "type", "add"})
    void movement_castsShadowRaysOnly(String name) {
        RayCounts rays = lastUpdate(bird(name)).rays();

        assertThat(rays.shadow()).isPositive();
        assertThat(rays.eye() + rays.mirrored()).isZero();
    }

    @Test
    void rename_touchesNoRow() {
        UpdateResult update = lastUpdate(bird("rename"));

        assertThat(update.rowsTouched()).isZero();
        assertThat(update.rowsComposed()).isZero();
    }

    static List<String> sceneNames() {
        return SceneFiles.names();
    }

    @Test
    void scenes_includeThePapersTestScene() {
        assertThat(sceneNames()).contains("bird", "balls", "spaceship");
    }

    @ParameterizedTest
    @ValueSource(strings = {"bird", "spaceship"})
    @Slow
    void everyCaseOfThePapersScenes_equalsTheTraditionalTrace(String name) {
        assertEveryCaseEqualsTheTraditionalTrace(name);
    }

    @ParameterizedTest
    @MethodSource("sceneNames")
    @Nightly
    void everyCaseOfEveryScene_equalsTheTraditionalTrace(String name) {
        assertEveryCaseEqualsTheTraditionalTrace(name);
    }

    private static void assertEveryCaseEqualsTheTraditionalTrace(String name) {
        Scene scene = SceneFiles.read(name, 24);
        Geometry geometry = Geometry.of(scene);
        RenderOptions options = RenderOptions.DEFAULT.withReflections(ReflectionMode.CURRENT).withThreads(2);
        try (Renderer renderer = new Renderer(options); WorkerPool workers = new WorkerPool(2)) {
            for (PaperCase edit : PaperCases.of(scene)) {
                for (Scene step : edit.scenes()) {
                    UpdateResult update = renderer.render(step, Progress.NONE);
                    assertThat(renderer.film().hasSameBits(
                            new TraditionalTracer(step, geometry.canServe(step) ? geometry : Geometry.of(step))
                                    .trace(workers, Progress.NONE)
                                    .film()))
                            .as(edit.name() + ": " + update.plan().description()).isTrue();
                }
            }
        }
    }

    @ParameterizedTest
    @MethodSource("sceneNames")
    void everyPrintedCase_changesTheScene(String name) {
        assertThat(PaperCases.of(SceneFiles.read(name))).filteredOn(PaperCase::isPrinted).isNotEmpty()
                .allMatch(c -> !c.after().equals(c.before()) && c.paperSaving() > 0);
    }

    @ParameterizedTest
    @MethodSource("sceneNames")
    void everyPrintedCase_hasThreeDifferentValues(String name) {
        Scene scene = SceneFiles.read(name);
        Map<String, Set<String>> values = new HashMap<>();
        for (int value = 0; value < PaperCases.VALUES; value++) {
            for (PaperCase edit : PaperCases.of(scene, value)) {
                values.computeIfAbsent(edit.name(), _ -> new HashSet<>()).add(edit.value());
            }
        }
        assertThat(values.values()).allSatisfy(texts -> assertThat(texts).doesNotContain(""));
        assertThat(PaperCases.of(scene)).filteredOn(PaperCase::isPrinted)
                .allSatisfy(edit -> assertThat(values.get(edit.name())).as(edit.name()).hasSize(PaperCases.VALUES));
    }

    @Test
    void missingLightTypes_omitTheirCases() {
        Scene bird = SceneFiles.read("bird");
        Scene pointOnly = bird.withLights(bird.lights().stream().filter(l -> l.type() == LightType.POINT).toList());

        assertThat(PaperCases.of(pointOnly)).extracting(PaperCase::name).containsExactlyInAnyOrder("attenuation", "position",
                "add", "ambience", "position-feet", "composite-1", "off", "on", "solo", "rename", "undo", "depth-less", "depth-more",
                "point-to-spot", "material-color", "shininess", "reflectivity", "mirror-off", "mirror-on", "texture-off", "texture-on",
                "shape-moved", "shape-turned", "shape-scaled", "shape-hidden", "shape-shown");
        assertThat(PaperCases.of(bird.withLights(List.of()))).extracting(PaperCase::name).containsExactlyInAnyOrder("add", "ambience",
                "depth-less", "depth-more", "material-color", "shininess", "reflectivity", "mirror-off", "mirror-on", "texture-off",
                "texture-on", "shape-moved", "shape-turned", "shape-scaled", "shape-hidden", "shape-shown");
    }

    @Test
    void noPointLight_movesLightOfOtherType() {
        Scene scene = scene(Light.of("key", LightType.RECT), Light.of("rim", LightType.SPOT));
        Scene after = PaperCases.moveCase(scene).orElseThrow().after();
        assertThat(after.light("key").orElseThrow().position()).isNotEqualTo(scene.light("key").orElseThrow().position());
        assertThat(after.light("rim")).isEqualTo(scene.light("rim"));
    }

    @Test
    void noPositionedLight_turnsDirectionalLight() {
        assertThat(PaperCases.moveCase(scene(Light.of("sun", LightType.DIRECTIONAL))).orElseThrow().name()).isEqualTo("direction");
    }

    private static Scene scene(Light... lights) {
        return SceneFiles.read("bird").withLights(List.of(lights));
    }

    @Test
    void shapeEdit_tracesLessThanWholePicture() {
        Scene bird = SceneFiles.read("bird");
        long all = (long) bird.picture().width() * bird.picture().height();
        for (String name : List.of("shape-moved", "shape-turned", "shape-scaled", "shape-hidden", "shape-shown")) {
            assertThat(lastUpdate(bird(name)).rays().eye()).as(name).isPositive().isLessThan(all);
        }
    }

    @Test
    void floorsAndWalls_areNotMoved() {
        Scene bird = SceneFiles.read("bird");
        Scene walls = bird.withNodes(List.of(new Shape(Solid.PLANE, "wall", bird.materials().getFirst().name(), Placement.IDENTITY)));
        assertThat(PaperCases.of(walls)).extracting(PaperCase::name).contains("color").doesNotContain("shape-moved", "shape-hidden");
    }

    @ParameterizedTest
    @ValueSource(strings = {"material-color", "shininess", "reflectivity", "mirror-off", "texture-off", "texture-on"})
    void materialEdit_castsNoRay(String name) {
        assertThat(lastUpdate(bird(name)).rays()).isEqualTo(RayCounts.NONE);
    }

    @Test
    void addedMirror_castsNoEyeRay() {
        RayCounts rays = lastUpdate(bird("mirror-on")).rays();

        assertThat(rays.mirrored()).isPositive();
        assertThat(rays.eye()).isZero();
    }

    @Test
    void scenesWithoutMirrorsAndTextures_omitTheirCases() {
        Scene plain = SceneFiles.read("bird");
        plain = plain.withMaterials(plain.materials().stream().map(m -> m.withReflective(Rgb.BLACK).withTexture(Optional.empty())
                .withSpecular(Rgb.BLACK)).toList());

        assertThat(PaperCases.of(plain)).extracting(PaperCase::name).contains("material-color").doesNotContain("shininess",
                "reflectivity", "mirror-off", "mirror-on", "texture-off", "texture-on");
    }

    @Test
    void addedLight_hasFreeName() {
        Scene bird = SceneFiles.read("bird");
        Scene taken = bird.withLights(List.of(Light.of("light_new", LightType.DIRECTIONAL)));

        Scene added = PaperCases.of(taken).stream().filter(c -> c.name().equals("add")).findFirst().orElseThrow().after();
        assertThat(added.lights()).extracting(Light::name).containsExactly("light_new", "light_new_2");
    }

    @Test
    void surfaceFeatures_areEditedIfPresent() throws Exception {
        assertThat(names("arbor")).contains("relief-off", "relief-on", "cutout-off", "cutout-on").doesNotContain("roughness", "tint");
        assertThat(names("product")).contains("roughness", "tint", "clear-off", "clear-on").doesNotContain("relief-off", "cutout-off");
        assertThat(names("bird")).doesNotContain("roughness", "tint", "clear-off", "relief-off", "cutout-off");
    }

    private static List<String> names(String scene) {
        return PaperCases.of(SceneFiles.read(scene)).stream().map(PaperCase::name).toList();
    }

    @Test
    void directionalLightWithoutPosition_becomesPointLightAlongItsDirection() {
        Scene bird = SceneFiles.read("bird");
        Scene plain = bird.withLights(List.of(Light.of("key", LightType.DIRECTIONAL)));
        Scene after = PaperCases.of(plain).stream().filter(c -> c.name().equals("type")).findFirst().orElseThrow().after();
        Vec3 above = after.lights().getFirst().position().minus(bird.camera().to());

        assertThat(after.lights().getFirst().type()).isEqualTo(LightType.POINT);
        assertThat(above.y()).isPositive();
        assertThat(above.x()).isZero();
        assertThat(above.z()).isZero();
    }

    private static PaperCase bird(String name) {
        return PaperCases.of(SceneFiles.read("bird", 40)).stream().filter(c -> c.name().equals(name)).findFirst().orElseThrow();
    }

    /** Returns the plan of the case's last step. */
    private static UpdatePlan.Relight lastPlan(PaperCase edit) {
        return (UpdatePlan.Relight) lastUpdate(edit).plan();
    }

    /** Returns the update of the last step with stale reflections, as in the paper. */
    private static UpdateResult lastUpdate(PaperCase edit) {
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT.withReflections(ReflectionMode.STALE).withThreads(1))) {
            UpdateResult update = null;
            for (Scene step : edit.scenes()) {
                update = renderer.render(step, Progress.NONE);
            }
            return update;
        }
    }
}
