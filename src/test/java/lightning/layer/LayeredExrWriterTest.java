package lightning.layer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIOException;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import lightning.base.math.Ray;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.format.exr.ExrPrimaries;
import lightning.format.exr.ExrType;
import lightning.render.RenderOptions;
import lightning.render.image.Film;
import lightning.render.relight.ContributionScene;
import lightning.render.relight.Renderer;
import lightning.render.relight.paper.Accuracy;
import lightning.render.relight.paper.MirrorStorage;
import lightning.render.relight.paper.ReflectionMode;
import lightning.render.shading.FilmParts;
import lightning.render.shading.LightWeight;
import lightning.render.shading.WeightedLight;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.render.trace.BruteForce;
import lightning.render.trace.Geometry;
import lightning.render.trace.PixelRays;
import lightning.render.trace.SurfacePoint;
import lightning.sample.EditSession;
import lightning.sample.IndirectScenes;
import lightning.sample.JenScenes;
import lightning.sample.Slow;
import lightning.sample.StudioScene;
import lightning.sample.TryFolder;
import lightning.scene.GatherSettings;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;
import lightning.scene.SceneElement;
import lightning.scene.light.FaceVisibility;
import lightning.scene.light.Light;
import lightning.scene.light.LightGroup;
import lightning.scene.light.LightRig;
import lightning.scene.light.LightType;
import lightning.scene.material.Bulb;
import lightning.scene.material.Material;
import lightning.scene.material.ShadingModel;
import lightning.scene.value.Fog;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Layers of a written image: they add up to the image exactly, and each matches its definition. */
@Slow
class LayeredExrWriterTest {
    private static final List<String> COLORS = List.of("R", "G", "B");

    @TempDir
    private Path folder;

    @Provide
    Arbitrary<EditSession> sessions() {
        return EditSession.sessions();
    }

    @Property(edgeCases = EdgeCasesMode.NONE)
    void layers_sumToTheImageBitForBit(@ForAll("sessions") EditSession session, @ForAll Accuracy accuracy,
            @ForAll ReflectionMode reflections, @ForAll MirrorStorage storage, @ForAll boolean indirect) throws IOException {
        try (Renderer renderer = new Renderer(new RenderOptions(accuracy, reflections, storage, 2))) {
            for (Scene scene : session.timedScenes()) {
                renderer.render(indirect ? IndirectScenes.withBackground(scene) : scene, Progress.NONE);
            }
            ExrValues file = writeFile(renderer, ExrType.FLOAT);
            Film film = renderer.film();
            List<String> layers = file.list("lightning/sum");
            assertThat(layers.contains("indirect")).isEqualTo(indirect);
            for (int c = 0; c < 3; c++) {
                float[] beauty = file.channel(COLORS.get(c));
                float[] rounding = file.channel("rounding." + COLORS.get(c));
                for (int i = 0; i < beauty.length; i++) {
                    float sum = 0;
                    for (String layer : layers) {
                        sum += file.channel(layer + "." + COLORS.get(c))[i];
                    }
                    assertThat(Float.floatToRawIntBits(sum)).as("sum of pixel %d", i).isEqualTo(Float.floatToRawIntBits(beauty[i]));
                    assertThat(beauty[i]).isEqualTo(List.of(film.red(i % film.width(), i / film.width()),
                            film.green(i % film.width(), i / film.width()), film.blue(i % film.width(), i / film.width())).get(c));
                    assertThat(Math.abs(rounding[i]))
                            .isLessThanOrEqualTo((layers.size() + steps(renderer.scene())) * 0x1p-23f * beauty[i] + 0x1p-140f);
                }
            }
        }
    }

    /**
     * Returns the largest number of additions and multiplications one after the other between stored terms and a color, each of which loses at
     * most half a unit of the result, since all values are at least 0: at most 16 for each bounce off a mirror, and for each bounce of diffuse
     * light the sum over rays and twice one over fewer than 256 neighbors.
     */
    private static int steps(Scene scene) {
        return 16 * (scene.picture().depth() + 1) + GatherSettings.of(scene)
                .map(settings -> (settings.pathBounces() + 1) * (settings.rays() + settings.reflectionRays() + 512)).orElse(0);
    }

    /** Mirrors, indirect light and fog included; bulbs and faces are in another layer. */
    @Property(edgeCases = EdgeCasesMode.NONE)
    void layersOfALight_sumToItsContribution(@ForAll("sessions") EditSession session, @ForAll ReflectionMode reflections,
            @ForAll boolean indirect) throws IOException {
        try (Renderer renderer = new Renderer(new RenderOptions(Accuracy.EXACT, reflections, MirrorStorage.FULL_ROWS, 2))) {
            for (Scene scene : session.timedScenes()) {
                Scene dark = withoutEmission(scene);
                renderer.render(indirect ? IndirectScenes.withBackground(dark) : dark, Progress.NONE);
            }
            Scene scene = renderer.scene();
            ExrValues file = writeFile(renderer, ExrType.FLOAT);
            Map<String, String> lights = file.map("lightning/lights");
            for (Light light : scene.lights()) {
                List<String> layers = lights.keySet().stream().filter(layer -> lights.get(layer).equals(light.name())).toList();
                if (layers.isEmpty()) {
                    continue;
                }
                Film contribution = renderer.contribution(new SceneElement.OfLight(light.name()), Progress.NONE);
                float[] sum = file.sum(layers);
                for (int i = 0; i < sum.length / 3; i++) {
                    int x = i % contribution.width();
                    int y = i / contribution.width();
                    float[] expected = {contribution.red(x, y), contribution.green(x, y), contribution.blue(x, y)};
                    for (int c = 0; c < 3; c++) {
                        assertThat(sum[3 * i + c]).as("%s, pixel %d", light.name(), i).isCloseTo(expected[c],
                                within((layers.size() + steps(scene)) * 0x1p-23f * expected[c] + 0x1p-140f));
                    }
                }
            }
        }
    }

    @Test
    void lightsOfAGroup_shareLayers() throws IOException {
        Scene studio = StudioScene.withFourLights(30, 24);
        LightRig rig = studio.rig().addLightGroup(LightGroup.of("soft"));
        Scene scene = studio.withRig(rig.withLights(studio.lights().stream()
                .map(light -> light.name().equals("sun") ? light : light.withLightGroup("soft")).toList()));
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT.withThreads(1)); TryFolder files = new TryFolder();
                WorkerPool workers = new WorkerPool(1)) {
            renderer.render(scene, Progress.NONE);
            Path path = files.file("groups.exr");
            new LayeredExrWriter(renderer.cache(), renderer.options().engines(),
                    new ExrContent(ExrType.FLOAT, ExrContent.Layers.LIT, true, 0), ExrLayout.DEFAULT, Optional.empty())
                    .write(path, Long.MAX_VALUE, workers, Progress.NONE);
            ExrValues grouped = new ExrValues(path);
            assertThat(grouped.list("lightning/sum")).containsExactly("background", "ambient", "sun_diffuse", "sun_specular",
                    "sun_reflections", "soft_diffuse", "soft_specular", "soft_reflections", "reflections", "rounding");
            ExrValues single = writeFile(renderer, ExrType.FLOAT);
            float[] sum = single.sum(List.of("key_diffuse", "fill_diffuse", "back_diffuse"));
            float[] group = grouped.sum(List.of("soft_diffuse"));
            for (int i = 0; i < sum.length; i++) {
                assertThat(group[i]).isCloseTo(sum[i], within(20 * 0x1p-23f * sum[i]));
            }
        }
    }

    @Test
    void acescgLayers_sumToTheAcescgImage() throws IOException {
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT.withThreads(1)); TryFolder files = new TryFolder();
                WorkerPool workers = new WorkerPool(1)) {
            renderer.render(StudioScene.withFourLights(30, 24), Progress.NONE);
            Path path = files.file("acescg.exr");
            new LayeredExrWriter(renderer.cache(), renderer.options().engines(),
                    new ExrContent(ExrType.FLOAT, ExrContent.Layers.LIT, false, 0, ExrPrimaries.ACESCG), ExrLayout.DEFAULT,
                    Optional.empty())
                    .write(path, Long.MAX_VALUE, workers, Progress.NONE);
            ExrValues acescg = new ExrValues(path);
            float[] sum = acescg.sum(acescg.list("lightning/sum"));
            float[] rec709 = renderer.film().toScanlines();
            for (int i = 0; i < sum.length; i += 3) {
                float[][] expected =
                        ExrPrimaries.ACESCG.convert(new float[][] {{rec709[i]}, {rec709[i + 1]}, {rec709[i + 2]}});
                assertThat(new float[] {sum[i], sum[i + 1], sum[i + 2]}).containsExactly(expected[0][0], expected[1][0], expected[2][0]);
            }
        }
    }

    /** For a light of weight 1, bit for bit. */
    @Property(edgeCases = EdgeCasesMode.NONE)
    void lightLayers_sumToItsContribution(@ForAll("sessions") EditSession session, @ForAll boolean isUnit) throws IOException {
        Scene scene = session.scenes().getFirst();
        // Light that is gathered, reflected or in fog is in layers of its own.
        Scene drawn = direct(scene);
        Scene directScene = !isUnit ? drawn
                : drawn.withLights(drawn.lights().stream().map(light -> light.withIntensity(1).withColor(Rgb.WHITE)).toList());
        assertThat(GatherSettings.of(directScene)).isEmpty();
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT.withThreads(1))) {
            renderer.render(directScene, Progress.NONE);
            ExrValues file = writeFile(renderer, ExrType.FLOAT);
            Map<String, String> lights = file.map("lightning/lights");
            for (Light light : directScene.lights()) {
                List<String> layers = lights.keySet().stream().filter(layer -> lights.get(layer).equals(light.name())).toList();
                assertThat(layers).hasSize(WeightedLight.of(light, directScene).isDark() ? 0 : 2);
                if (!layers.isEmpty()) {
                    assertSame(file.sum(layers),
                            new ReferenceTracer(withoutEmission(ContributionScene.of(directScene, light.name()))).trace(),
                            FilmParts.of(directScene).get(directScene.rig().indexOf(light.name())).weight());
                }
            }
        }
    }

    /** Returns a scene with dark bulbs and faces of lights, whose light is in a layer of its own. */
    private static Scene withoutEmission(Scene scene) {
        List<Light> lights = scene.lights().stream().map(light -> light.area().visibility() == FaceVisibility.HIDDEN ? light
                : light.withArea(light.area().withVisibility(FaceVisibility.BLACK))).toList();
        return new Scene(scene.picture(), scene.camera(), scene.world(),
                scene.stage().withMaterials(scene.materials().stream().map(m -> m.withBulb(Bulb.NONE)).toList()),
                scene.rig().withLights(lights));
    }

    /** Returns a scene without mirrors, gathered light, blurred reflections, fog and finer samples. */
    private static Scene direct(Scene scene) {
        Scene direct = scene
                .withPicture(scene.picture().withDepth(0).withSampling(SamplingSettings.DEFAULT).withIndirect(Optional.empty()))
                .withWorld(scene.world().withFog(Fog.NONE).withoutEnvironments());
        for (Material material : scene.materials()) {
            direct = material.reflectsRoughly() ? direct.withMaterial(material.withModel(ShadingModel.METALLIC)) : direct;
        }
        return direct;
    }

    /** For a light's diffuse part a, specular part b and weight w, the image contains w·(a + b) and the layers w·a and w·b, each rounded. */
    private static void assertSame(float[] sum, Film contribution, LightWeight weight) {
        float[] image = contribution.toScanlines();
        for (int i = 0; i < image.length; i++) {
            // Two roundings of at most u = 2⁻²⁴ on either side: (1 + u)²/(1 − u)² − 1 < 5u. A product below the smallest
            // normal float loses at most 2⁻¹⁵⁰ more, and there are three.
            float room = weight.channel(i % 3) == 1 ? 0 : 5 * 0x1p-24f * image[i] + 0x1p-148f;
            assertThat(sum[i]).as("pixel %d", i / 3).isBetween(image[i] - room, image[i] + room);
        }
    }

    @Property(edgeCases = EdgeCasesMode.NONE)
    void surfaceChannels_matchThePixelCenterRay(@ForAll("sessions") EditSession session) throws IOException {
        Scene scene = session.scenes().getLast();
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT.withThreads(1))) {
            renderer.render(scene, Progress.NONE);
            ExrValues file = writeFile(renderer, ExrType.HALF);
            Geometry geometry = Geometry.of(scene);
            List<String> shapes = file.list("lightning/shapes");
            List<String> materials = file.list("lightning/materials");
            Vec3 viewDirection = scene.camera().to().minus(scene.camera().from()).normalized();
            for (int i = 0; i < file.width * file.height; i++) {
                Ray ray = new PixelRays(scene).ray(i % file.width, i / file.width);
                int primitive = BruteForce.nearest(geometry, ray);
                float shape = file.channel("shape.id")[i];
                if (primitive < 0) {
                    assertThat(shape).isZero();
                    assertThat(file.channel("material.id")[i]).isZero();
                    assertThat(file.channel("Z")[i]).isEqualTo(1e10f);
                } else {
                    SurfacePoint at = BruteForce.surface(geometry, primitive, ray);
                    if (geometry.isLightFace(primitive)) {
                        assertThat(shape).isZero();
                        assertThat(file.channel("material.id")[i]).isZero();
                    } else {
                        assertThat(shapes.get((int) shape - 1)).isEqualTo(geometry.shape(primitive).name());
                        assertThat(materials.get((int) file.channel("material.id")[i] - 1)).isEqualTo(geometry.material(primitive).name());
                    }
                    Vec3 point = new Vec3(at.px(), at.py(), at.pz());
                    assertThat(file.channel("Z")[i]).isEqualTo((float) point.dot(viewDirection));
                    assertThat(file.channel("P.Y")[i]).isEqualTo((float) (point.y() + scene.camera().from().y()));
                    assertThat(file.channel("N.X")[i]).isEqualTo(Float.float16ToFloat(Float.floatToFloat16(at.nx())));
                    float albedo = geometry.isLightFace(primitive) ? 0 : Math.min(1, at.diffuse()[1] + at.specular()[1]);
                    assertThat(file.channel("albedo.G")[i]).isEqualTo(Float.float16ToFloat(Float.floatToFloat16(albedo)));
                }
            }
        }
    }

    /** The floor and a ball mirror half of the light, so they show half of their glow; the other ball does not glow. */
    @Test
    void emission_isALayerOfItsOwn() throws IOException {
        Scene studio = StudioScene.of(LightType.SPOT);
        Scene scene = studio.withMaterial(studio.material("glass").orElseThrow().withGlow(new Rgb(3, 0.5, 0.25)));
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT.withThreads(1))) {
            renderer.render(scene, Progress.NONE);
            ExrValues file = writeFile(renderer, ExrType.FLOAT);
            assertThat(file.list("lightning/sum")).containsExactly("background", "ambient", "emission", "key_diffuse", "key_specular",
                    "key_reflections", "reflections", "rounding");
            List<String> materials = file.list("lightning/materials");
            for (int i = 0; i < file.width * file.height; i++) {
                int id = (int) file.channel("material.id")[i];
                boolean glows = id > 0 && materials.get(id - 1).equals("glass");
                assertThat(file.channel("emission.R")[i]).isEqualTo(glows ? 1.5f : 0);
                assertThat(file.channel("emission.G")[i]).isEqualTo(glows ? 0.25f : 0);
                assertThat(file.channel("emission.B")[i]).isEqualTo(glows ? 0.125f : 0);
                assertThat(file.channel("ambient.R")[i]).isEqualTo(id == 0 ? 0 : glows ? 0.1f * 0.5f : 0.1f);
            }
        }
    }

    /** The visible face of a light glows without any glowing material in the scene. */
    @Test
    void faceOfVisibleLight_isInTheEmission() throws IOException {
        Light key = StudioScene.key(LightType.POINT);
        Light ball = key.withName("lamp").withPosition(new Vec3(0, 0, 0)).withIntensity(2)
                .withArea(key.area().withRadius(0.9).withVisibility(FaceVisibility.GLOWING));
        Scene scene = StudioScene.of(LightType.POINT).withLights(List.of(ball)).withNodes(List.of());
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT.withThreads(1))) {
            renderer.render(scene, Progress.NONE);
            ExrValues file = writeFile(renderer, ExrType.FLOAT);
            int center = file.height / 2 * file.width + file.width / 2;
            assertThat(file.channel("R")[center]).isPositive();
            assertThat(file.channel("emission.R")[center]).isEqualTo(file.channel("R")[center]);
        }
    }

    /** The other layers are those of the picture without indirect light. */
    @Test
    void indirectLayer_isTheDifferenceFromDirectLight() throws IOException {
        Scene direct = StudioScene.of(LightType.SPOT);
        Scene scene = IndirectScenes.with(direct.withPicture(direct.picture().withDepth(0)));
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT.withThreads(1))) {
            renderer.render(direct.withPicture(direct.picture().withDepth(0)), Progress.NONE);
            ExrValues before = writeFile(renderer, ExrType.FLOAT);
            renderer.render(scene, Progress.NONE);
            ExrValues after = writeFile(renderer, ExrType.FLOAT);
            List<String> layers = new ArrayList<>(after.list("lightning/sum"));
            assertThat(layers.indexOf("indirect")).isEqualTo(layers.indexOf("reflections") - 1);
            layers.removeAll(List.of("indirect", "key_indirect"));
            assertThat(layers).isEqualTo(before.list("lightning/sum"));
            float lightest = 0;
            for (String color : COLORS) {
                for (String layer : layers.subList(0, layers.size() - 1)) {
                    assertThat(after.channel(layer + "." + color)).isEqualTo(before.channel(layer + "." + color));
                }
                for (int i = 0; i < after.width * after.height; i++) {
                    float indirect = after.channel("key_indirect." + color)[i] + after.channel("indirect." + color)[i];
                    assertThat(indirect).isNotNegative();
                    // Both pictures are sums of few terms of at least 0, each rounded to 2⁻²⁴ of it.
                    assertThat((double) after.channel(color)[i] - before.channel(color)[i]).isCloseTo(indirect,
                            within(16 * 0x1p-24 * after.channel(color)[i]));
                    lightest = Math.max(lightest, indirect);
                }
            }
            assertThat(lightest).isGreaterThan(0.01f);
        }
    }

    @Test
    void layerNames_areUnambiguous() throws IOException {
        Scene scene = StudioScene.of(LightType.SPOT);
        Light key = scene.light(StudioScene.KEY).orElseThrow();
        Scene odd = scene.withLights(List.of(key, key.withName("2nd rim.light"), key.withName("2nd rim light"), key.withName("Key")));
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT.withThreads(1))) {
            renderer.render(odd, Progress.NONE);
            ExrValues file = writeFile(renderer, ExrType.HALF);
            assertThat(file.list("lightning/sum")).containsExactly("background", "ambient", "key_diffuse", "key_specular",
                    "key_reflections", "_2nd_rim_light_diffuse", "_2nd_rim_light_specular", "_2nd_rim_light_reflections",
                    "_2nd_rim_light_2_diffuse", "_2nd_rim_light_2_specular", "_2nd_rim_light_2_reflections", "Key_2_diffuse",
                    "Key_2_specular", "Key_2_reflections", "reflections");
            assertThat(file.map("lightning/lights")).containsEntry("_2nd_rim_light_diffuse", "2nd rim.light");
            assertThat(List.copyOf(file.values.keySet())).contains("R", "key_diffuse.R", "N.X", "P.Z", "Z").isSorted();
        }
    }

    @Test
    void lightNamedEnvironment_isNotTheSky() throws IOException {
        Scene scene = JenScenes.withSky(StudioScene.of(LightType.SPOT)).renameLight(StudioScene.KEY, "environment");
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT.withThreads(1))) {
            renderer.render(scene, Progress.NONE);
            assertThat(writeFile(renderer, ExrType.HALF).map("lightning/lights")).containsEntry("environment_diffuse", "environment")
                    .containsEntry("environment_2_gathered", "environment 2");
        }
    }

    @Test
    void canceledExport_leavesNoFile() {
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT.withThreads(1)); WorkerPool workers = new WorkerPool(1)) {
            renderer.render(StudioScene.of(LightType.POINT), Progress.NONE);
            LayeredExrWriter file = new LayeredExrWriter(renderer.cache(), renderer.options().engines(), ExrType.HALF);
            assertThatThrownBy(() -> file.write(folder.resolve("a.exr"), Long.MAX_VALUE, workers, new Progress() {
                @Override
                public void report(int done, int total) {}

                @Override
                public boolean isCanceled() {
                    return true;
                }
            })).isInstanceOf(CancellationException.class);
            assertThat(folder).isEmptyDirectory();
        }
    }

    @Test
    void exportBeyondMemoryLimit_isRejected() {
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT.withThreads(1)); WorkerPool workers = new WorkerPool(1)) {
            renderer.render(StudioScene.of(LightType.POINT), Progress.NONE);
            LayeredExrWriter file = new LayeredExrWriter(renderer.cache(), renderer.options().engines(), ExrType.HALF);
            assertThatIOException()
                    .isThrownBy(() -> file.write(folder.resolve("a.exr"), file.bytesToWrite(1) - 1, workers, Progress.NONE))
                    .withMessageContaining("GB of memory to write");
            assertThat(folder).isEmptyDirectory();
        }
    }

    private static ExrValues writeFile(Renderer renderer, ExrType type) throws IOException {
        try (TryFolder files = new TryFolder(); WorkerPool workers = new WorkerPool(2)) {
            Path file = files.file("layers.exr");
            new LayeredExrWriter(renderer.cache(), renderer.options().engines(), type).write(file, Long.MAX_VALUE, workers, Progress.NONE);
            return new ExrValues(file);
        }
    }
}
