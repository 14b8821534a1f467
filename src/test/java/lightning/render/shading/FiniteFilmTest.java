package lightning.render.shading;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.withinPercentage;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.format.jen.JenException;
import lightning.format.jen.JenReader;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.render.image.Film;
import lightning.render.image.FilmAssert;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.sample.EdgeCaseScenes;
import lightning.sample.EditSession;
import lightning.sample.FailedSceneRecorder;
import lightning.sample.IndirectArbitraries;
import lightning.sample.Slow;
import lightning.scene.AntialiasMode;
import lightning.scene.Camera;
import lightning.scene.PictureSettings;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.material.Material;
import lightning.scene.material.ShadingModel;
import lightning.scene.node.SceneNode;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.Placement;
import lightning.scene.value.SceneLimits;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests that every valid scene gives finite pixels: no NaN, no infinity, no negative value. */
@Slow
class FiniteFilmTest {

    @Provide
    Arbitrary<Scene> corners() {
        return EdgeCaseScenes.scenes();
    }

    @Provide
    Arbitrary<Scene> scenes() {
        return IndirectArbitraries.mixedScenes();
    }

    @Provide
    Arbitrary<EditSession> extremes() {
        return EditSession.extremeSessions();
    }

    @Property(edgeCases = EdgeCasesMode.NONE)
    void sceneAtParameterLimits_hasFiniteFilm(@ForAll("corners") Scene scene) {
        assertFinite(scene);
    }

    @Property(edgeCases = EdgeCasesMode.NONE)
    void ordinaryScene_hasFiniteFilm(@ForAll("scenes") Scene scene) {
        assertFinite(scene);
    }

    @Property(edgeCases = EdgeCasesMode.NONE)
    void sceneAfterExtremeEdits_hasFiniteFilm(@ForAll("extremes") EditSession session) {
        assertFinite(session.scenes().getLast());
    }

    static Stream<Path> kept() throws IOException {
        return FailedSceneRecorder.storedScenes();
    }

    @ParameterizedTest
    @MethodSource("kept")
    void regressionScene_hasFiniteFilm(Path file) throws IOException, JenException {
        assertFinite(JenReader.read(file).scene());
    }

    /** Diffuse ½·1, specular 1: normal, camera and light are collinear, and there is no mirror. */
    @Test
    void shapeBelowDoublePrecision_facesCamera() throws IOException, JenException {
        assertThat(new ReferenceTracer(read("lost-dot")).pixel(0, 0)).containsExactly(1.5f, 1.5f, 1.5f);
    }

    /**
     * Maximum light of a scene: a thousand of the brightest lights at one point between two mirrors, seen eleven times, each time
     * with a highlight of 1: 11·10³·10³³, in each of 64 samples.
     */
    @ParameterizedTest
    @ValueSource(doubles = {0, 0.5, 1})
    void brightestValidScene_doesNotOverflow(double reflective) {
        Material mirror = Material.of("m").withAmbient(Rgb.gray(SceneLimits.MAX_EMISSION)).withGlow(Rgb.gray(SceneLimits.MAX_EMISSION))
                .withDiffuse(Rgb.WHITE).withSpecular(Rgb.WHITE)
                .withShininess(0).withReflective(Rgb.gray(reflective));
        Scene scene = betweenMirrors(mirror, SceneLimits.MAX_INTENSITY, new Vec3(0.01, 0.02, -1));
        assertFinite(scene);
        float value = new ReferenceTracer(scene).pixel(0, 0)[0];
        assertThat((double) value).isLessThan(Float.MAX_VALUE / 10);
        if (reflective == 1) {
            assertThat((double) value).isCloseTo(11e36, withinPercentage(0.001));
        }
        assertFinite(scene.withPicture(scene.picture().withSampling(new SamplingSettings(AntialiasMode.EVERY, SceneLimits.MAX_SAMPLES))));
    }

    /** Metallic mirrors multiply each light, so the accepted maximum is lower. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 0.1, 0.3, 1})
    void brightestMetallicScene_doesNotOverflow(double roughness) {
        Material metal = metal(roughness);
        Scene scene = betweenMirrors(metal, maxTermSum(metal), new Vec3(0, 0, -1));
        assertFinite(scene);
        assertFinite(scene.withPicture(scene.picture().withSampling(new SamplingSettings(AntialiasMode.EVERY, 4))));
    }

    /** The limit is not too strict: at grazing angles of light and camera, a light is a third as bright as the limit assumes. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 0.1, 0.3})
    void brightestGrazingLightOnMetal_isCloseToBound(double roughness) {
        Material metal = metal(roughness);
        double height = metal.alpha();
        List<Light> lights = brightLights(maxTermSum(metal), new Vec3(0, height, -1));
        Scene scene = new Scene(new PictureSettings(1, 1, 0), new Camera(new Vec3(0, height, 1), Vec3.ZERO, Vec3.Y, SceneLimits.MIN_FOV),
                World.DEFAULT, List.of(metal), List.of(new Shape(Solid.PLANE, "floor", "m", Placement.IDENTITY)), lights);
        assertFinite(scene);
        assertThat((double) new ReferenceTracer(scene).pixel(0, 0)[0]).isBetween(SceneLimits.MAX_TOTAL_LIGHT / 10,
                SceneLimits.MAX_TOTAL_LIGHT);
    }

    private static Material metal(double roughness) {
        return Material.of("m").withModel(ShadingModel.METALLIC).withBase(Rgb.WHITE).withMetalness(1).withRoughness(roughness)
                .withReflective(Rgb.WHITE);
    }

    /** Returns the intensity of a thousand lights of the brightest color that is accepted with a metal. */
    private static double maxTermSum(Material metal) {
        return SceneLimits.MAX_TOTAL_LIGHT / metal.maxTerm() / (SceneLimits.MAX_LIGHTS * SceneLimits.MAX_LIGHT_COLOR) * (1 - 1e-12);
    }

    private static List<Light> brightLights(double intensity, Vec3 at) {
        return IntStream.range(0, SceneLimits.MAX_LIGHTS).mapToObj(l -> Light.of("l" + l, LightType.POINT)
                .withColor(Rgb.gray(SceneLimits.MAX_LIGHT_COLOR)).withIntensity(intensity).withPosition(at)).toList();
    }

    /** A thousand of the brightest lights at the camera, between two mirroring walls. */
    private static Scene betweenMirrors(Material material, double intensity, Vec3 to) {
        Camera camera = new Camera(Vec3.ZERO, to, Vec3.Y, SceneLimits.MIN_FOV);
        return new Scene(new PictureSettings(2, 2, SceneLimits.MAX_DEPTH), camera,
                new World(SceneLimits.MAX_AMBIENCE, Rgb.gray(SceneLimits.MAX_EMISSION)),
                List.of(material), List.of(wall("front", -1), wall("back", 1)), brightLights(intensity, Vec3.ZERO));
    }

    private static SceneNode wall(String name, double z) {
        return new Shape(Solid.PLANE, name, "m", new Placement(new Vec3(0, 0, z), new Vec3(90, 0, 0), new Vec3(1e3, 1, 1e3)));
    }

    private static Scene read(String name) throws IOException, JenException {
        return JenReader.read(FailedSceneRecorder.FOLDER.resolve(name + ".jen")).scene();
    }

    private static void assertFinite(Scene scene) {
        FailedSceneRecorder.check("finite-film", scene, FiniteFilmTest::assertTracersAgree);
    }

    private static void assertTracersAgree(Scene scene) {
        Film film = new ReferenceTracer(scene).trace();
        for (float value : film.toScanlines()) {
            assertThat(value >= 0 && value <= Float.MAX_VALUE).as("film value " + value).isTrue();
        }
        try (WorkerPool workers = new WorkerPool(1)) {
            FilmAssert.assertSameBits(new TraditionalTracer(scene).trace(workers, Progress.NONE).film(), film, "corner");
        }
    }
}
