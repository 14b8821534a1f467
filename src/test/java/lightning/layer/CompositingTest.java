package lightning.layer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import lightning.base.math.Ray;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.format.exr.ExrAttribute;
import lightning.format.exr.ExrChannel;
import lightning.format.exr.ExrReader;
import lightning.format.exr.ExrType;
import lightning.render.RenderOptions;
import lightning.render.relight.Renderer;
import lightning.render.trace.PixelRays;
import lightning.sample.JenScenes;
import lightning.sample.PythonPrograms;
import lightning.sample.StudioScene;
import lightning.scene.AntialiasMode;
import lightning.scene.Camera;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;
import lightning.scene.light.Emission;
import lightning.scene.light.IntensityUnit;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.value.LensShift;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** Files for compositing programs: their headers, and what OpenEXR's library and Blender read in them. */
class CompositingTest {
    private static final Path SCRIPTS = Path.of("src/test/resources/lightning/layer").toAbsolutePath();

    @TempDir
    private Path folder;

    private static void write(Scene scene, ExrContent content, Optional<FrameTime> time, Path file) throws IOException {
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT.withThreads(1)); WorkerPool workers = new WorkerPool(1)) {
            renderer.render(scene, Progress.NONE);
            new LayeredExrWriter(renderer.cache(), renderer.options().engines(), content, ExrLayout.DEFAULT,
                    time.map(t -> new ShotFrame(t, scene, scene))).write(file, Long.MAX_VALUE, workers,
                            Progress.NONE);
        }
    }

    private static List<Float> matrix(Map<String, ExrAttribute> attributes, String name) {
        return ((ExrAttribute.Matrix) attributes.get(name)).values();
    }

    /** Returns the product of a row vector and a matrix. */
    private static double[] transform(Vec3 p, List<Float> matrix) {
        double[] result = new double[4];
        for (int column = 0; column < 4; column++) {
            result[column] = p.x() * matrix.get(column) + p.y() * matrix.get(4 + column) + p.z() * matrix.get(8 + column)
                    + matrix.get(12 + column);
        }
        return result;
    }

    /** Numbers below 20 lose at most 2⁻²⁰ as floats; there are four for each coordinate of points up to 10 units away. */
    private static final double ROUNDING = 4 * 10 * 0x1p-20;

    @ParameterizedTest
    @CsvSource({"0, 0", "0.4, -0.3"})
    void cameraMatrices_mapPointsToTheirPixels(double shiftX, double shiftY) {
        Scene studio = StudioScene.of(LightType.POINT);
        Scene scene = studio.withCamera(Camera.SHIFT.with(studio.camera(), new LensShift(shiftX, shiftY)));
        Map<String, ExrAttribute> attributes = SceneMetadata.of(scene, Optional.empty());
        for (int x = 0; x < 30; x += 7) {
            for (int y = 0; y < 24; y += 5) {
                Ray ray = new PixelRays(scene).ray(x, y);
                Vec3 point = scene.camera().from().plus(ray.direction().times(3));
                double[] ndc = transform(point, matrix(attributes, "worldToNDC"));
                // Divided by a distance of at least 2.
                assertThat(ndc[0] / ndc[3]).isCloseTo((x + 0.5) / 30, within(ROUNDING));
                assertThat(ndc[1] / ndc[3]).isCloseTo((y + 0.5) / 24, within(ROUNDING));
                double[] camera = transform(point, matrix(attributes, "worldToCamera"));
                assertThat(Math.signum(camera[0])).isEqualTo(Math.signum(x + 0.5 - 15 + 30 * shiftX));
                assertThat(Math.signum(camera[1])).isEqualTo(Math.signum(12 - y - 0.5 + 24 * shiftY));
                assertThat(camera[2]).isEqualTo(ndc[3], within(ROUNDING));
                assertThat(camera[0] * camera[0] + camera[1] * camera[1] + camera[2] * camera[2]).isCloseTo(9, within(6 * 3 * ROUNDING));
            }
        }
        // The window is at distance 1, with y up.
        if (shiftX != 0) {
            float width = ((ExrAttribute.Number) attributes.get("screenWindowWidth")).value();
            assertThat(attributes.get("screenWindowCenter"))
                    .isEqualTo(new ExrAttribute.Point((float) (shiftX * width), (float) (shiftY * width * 24 / 30)));
        }
        // Left-handed: x × y = −z of the right-handed scene, whose rows are the columns.
        List<Float> m = matrix(attributes, "worldToCamera");
        Vec3 right = new Vec3(m.get(0), m.get(4), m.get(8));
        Vec3 up = new Vec3(m.get(1), m.get(5), m.get(9));
        assertThat(right.cross(up).dot(new Vec3(m.get(2), m.get(6), m.get(10)))).isCloseTo(-1, within(1e-6));
    }

    @ParameterizedTest
    @CsvSource({"24, 24, 1", "25, 25, 1", "23.976, 24000, 1001", "23.98, 24000, 1001", "29.97, 30000, 1001", "59.94, 60000, 1001",
        "12.5, 25, 2", "0.001, 1, 1000", "23.5, 47, 2"})
    void frameRates_areFractions(double rate, int numerator, int denominator) {
        assertThat(new FrameTime(1, rate).fraction()).isEqualTo(new ExrAttribute.Rational(numerator, denominator));
    }

    @Test
    void unknownValues_areAbsent() {
        Scene scene = StudioScene.of(LightType.POINT);
        assertThat(SceneMetadata.of(scene, Optional.empty())).containsOnlyKeys("software", "chromaticities", "worldToCamera", "worldToNDC",
                "screenWindowWidth");
        Light key = scene.light(StudioScene.KEY).orElseThrow();
        Scene lit = scene.withLights(List.of(key.withEmission(Emission.DEFAULT.withUnit(IntensityUnit.CANDELA))));
        assertThat(SceneMetadata.of(lit, Optional.of(new FrameTime(7, 25))))
                .containsEntry("whiteLuminance", new ExrAttribute.Number(1)).containsEntry("imageCounter", new ExrAttribute.Int(7))
                .containsEntry("framesPerSecond", new ExrAttribute.Rational(25, 1)).containsKey("lightning/metersPerUnit");
    }

    /** Layers of lights that are off are black, and the sum is the same. */
    @Test
    void framesOfAShot_haveLayersOfAllLights() throws IOException {
        Scene scene = StudioScene.withFourLights(20, 16);
        Light key = scene.light(StudioScene.KEY).orElseThrow();
        Scene dark = scene.withLight(key.withOn(false));
        Path lit = folder.resolve("lit.exr");
        Path off = folder.resolve("off.exr");
        ExrContent all = new ExrContent(ExrType.FLOAT, ExrContent.Layers.ALL, false, 0);
        write(scene, all, Optional.empty(), lit);
        write(dark, all, Optional.empty(), off);
        List<String> layers = List.of("background", "ambient", "emission", "key_diffuse", "key_specular", "key_reflections", "fill_diffuse",
                "fill_specular", "fill_reflections", "back_diffuse", "back_specular", "back_reflections", "sun_diffuse", "sun_specular",
                "sun_reflections", "reflections", "rounding");
        try (ExrReader reader = new ExrReader(off); ExrReader other = new ExrReader(lit)) {
            List<String> names = reader.header().channels().stream().map(ExrChannel::name).toList();
            assertThat(names).isEqualTo(other.header().channels().stream().map(ExrChannel::name).toList());
            assertThat(new JsonMapper().readValue(reader.header().texts().get("lightning/sum"), String[].class))
                    .containsExactly(layers.toArray(String[]::new));
            List<String> read = new ArrayList<>(List.of("R"));
            layers.forEach(layer -> read.add(layer + ".R"));
            reader.read(read, (_, _, values) -> {
                float sum = 0;
                for (int i = 1; i < values.length; i++) {
                    sum += values[i];
                }
                assertThat(sum).isEqualTo(values[0]);
                assertThat(values[1 + layers.indexOf("key_diffuse")]).isZero();
                assertThat(values[1 + layers.indexOf("key_specular")]).isZero();
                assertThat(values[1 + layers.indexOf("key_reflections")]).isZero();
            });
        }
    }

    @Test
    void openExr_readsHeaderLayersAndMattes() throws IOException {
        PythonPrograms.require("OpenEXR", "numpy");
        Scene studio = StudioScene.withFourLights(60, 48);
        Light key = studio.light(StudioScene.KEY).orElseThrow();
        Scene scene = studio.withLight(key.withEmission(Emission.DEFAULT.withUnit(IntensityUnit.CANDELA)));
        Path file = folder.resolve("a.exr");
        Optional<FrameTime> time = Optional.of(new FrameTime(17, 29.97));
        write(scene, new ExrContent(ExrType.FLOAT, ExrContent.Layers.LIT, false, 6), time, file);
        JsonNode header = new JsonMapper()
                .readTree(PythonPrograms.script(folder, List.of(SCRIPTS.resolve("read_compositing.py").toString(), file.toString())));
        Map<String, ExrAttribute> written = SceneMetadata.of(scene, time);
        assertThat(header.get("imageCounter").asInt()).isEqualTo(17);
        assertThat(header.get("framesPerSecond").values()).extracting(JsonNode::asInt).containsExactly(30000, 1001);
        assertThat(header.get("whiteLuminance").asInt()).isEqualTo(1);
        assertThat(header.get("lightning/metersPerUnit").asInt()).isEqualTo(1);
        assertThat(floats(header.get("chromaticities"))).isEqualTo(ExrAttribute.Chromaticities.REC_709.values());
        for (String name : List.of("worldToCamera", "worldToNDC")) {
            assertThat(floats(header.get(name))).isEqualTo(matrix(written, name));
        }
        assertThat(new ExrAttribute.Number((float) header.get("screenWindowWidth").asDouble())).isEqualTo(written.get("screenWindowWidth"));
    }

    private static List<Float> floats(JsonNode numbers) {
        return numbers.values().stream().map(n -> (float) n.asDouble()).toList();
    }

    /** Nuke drops leading digits of each part of a name and joins the parts by underscores; Blender reads 63 characters. */
    @Test
    void channelNames_areDistinctInNukeAndBlender() throws IOException {
        Scene studio = StudioScene.of(LightType.POINT);
        Light key = studio.light(StudioScene.KEY).orElseThrow();
        List<Light> lights = new ArrayList<>();
        for (String name : List.of("key", "Key", "key.diffuse", "key_diffuse", "1", "2", "12key", "ä", "ö", "a".repeat(60), "a".repeat(61),
                "environment", "ambient", "N", "CryptoObject00", "rounding", "R")) {
            lights.add(key.withName(name));
        }
        Path file = folder.resolve("a.exr");
        write(studio.withLights(lights), new ExrContent(ExrType.FLOAT, ExrContent.Layers.LIT, false, 64), Optional.empty(), file);
        try (ExrReader reader = new ExrReader(file)) {
            List<String> names = reader.header().channels().stream().map(ExrChannel::name).toList();
            assertThat(names).allMatch(name -> name.length() <= 63);
            assertThat(names).filteredOn(name -> name.endsWith("_diffuse.R")).hasSize(lights.size());
            assertThat(names).extracting(name -> String.join("_",
                    Stream.of(name.split("\\.")).map(part -> part.replaceAll("^[0-9]+", "").replaceAll("[^A-Za-z0-9]", "_")).toList())
                    .toLowerCase(Locale.ROOT)).doesNotHaveDuplicates();
        }
    }

    /** A light may have the name of the environment. */
    @Test
    void environments_haveTheirOwnLayers() throws IOException {
        Scene lamp = JenScenes.withSky(JenScenes.of("picture { size 20 16 }  camera { from 0 1 6  to 0 1 0 }  plane floor { }"
                + "  sphere ball { at 0 1 0 }  light environment point { at 0 3 1 }"));
        ExrContent content = new ExrContent(ExrType.FLOAT, ExrContent.Layers.LIT, false, 0);
        List<Map<String, List<Float>>> files = new ArrayList<>();
        for (double intensity : List.of(1.0, 2.0)) {
            Path file = folder.resolve(intensity + ".exr");
            write(lamp.withWorld(lamp.world().withNamed(List.of(JenScenes.dome("studio", intensity)))), content, Optional.empty(), file);
            files.add(reds(file));
        }
        assertThat(files.getFirst().keySet()).filteredOn(name -> name.contains("environment") || name.contains("studio")).containsExactly(
                "environment_diffuse.R", "environment_specular.R", "environment_2_diffuse.R", "environment_2_specular.R",
                "environment_2_gathered.R", "studio_diffuse.R", "studio_specular.R", "studio_gathered.R");
        assertThat(files.getFirst().get("studio_gathered.R")).anyMatch(v -> v > 0);
        files.getFirst().forEach((name, once) -> {
            List<Float> twice = files.getLast().get(name);
            if (name.startsWith("studio_")) {
                assertThat(twice).as(name).isEqualTo(once.stream().map(v -> 2 * v).toList());
            } else if (name.startsWith("environment_")) {
                assertThat(twice).as(name).isEqualTo(once);
            }
        });
    }

    /** Returns the red values of all layers of a file. */
    private static Map<String, List<Float>> reds(Path file) throws IOException {
        try (ExrReader reader = new ExrReader(file)) {
            Map<String, List<Float>> reds = new LinkedHashMap<>();
            for (String layer : new JsonMapper().readValue(reader.header().texts().get("lightning/sum"), String[].class)) {
                reds.put(layer + ".R", new ArrayList<>());
            }
            List<String> names = List.copyOf(reds.keySet());
            reader.read(names, (_, _, values) -> {
                for (int i = 0; i < values.length; i++) {
                    reds.get(names.get(i)).add(values[i]);
                }
            });
            return reds;
        }
    }

    /** Names as long as Lightning allows, equal in many characters, and names of Blender's and Nuke's own layers. */
    @Test
    void blender_listsAllLayersAndItsMatteIsTheFiles() throws IOException {
        PythonPrograms.require("bpy", "OpenEXR");
        Scene studio = StudioScene.of(LightType.POINT);
        Light key = studio.light(StudioScene.KEY).orElseThrow();
        List<Light> lights = List.of(key, key.withName("a".repeat(60)), key.withName("a".repeat(60) + "b"), key.withName("2. Füllung"),
                key.withName("depth"), key.withName("ambient"), key.withName("Combined"));
        Scene scene = studio.withLights(lights)
                .withPicture(studio.picture().withSize(48, 40).withSampling(new SamplingSettings(AntialiasMode.EVERY, 4)));
        Path file = folder.resolve("a.exr");
        write(scene, new ExrContent(ExrType.HALF, ExrContent.Layers.LIT, false, 6), Optional.empty(), file);
        String text = PythonPrograms.output(folder,
                List.of(SCRIPTS.resolve("blender_layers.py").toString(), file.toString(), folder.resolve("out.exr").toString()));
        JsonNode result = new JsonMapper().readTree(text.substring(text.indexOf("RESULT ") + 7).lines().findFirst().orElseThrow());
        List<String> expected = new ArrayList<>(List.of("Combined", "Depth", "N", "P", "shape", "material", "albedo"));
        expected.addAll(LayerNames.of(Layer.of(scene, LightSet.of(scene, false, false), true, false), Optional.empty()));
        for (String kind : List.of("CryptoObject", "CryptoMaterial", "CryptoAsset")) {
            for (int i = 0; i < 3; i++) {
                expected.add(kind + "0" + i);
            }
        }
        assertThat(result.get("passes").values()).extracting(JsonNode::asString).containsAll(expected);
        assertThat(result.get("layers").size()).isZero();
        assertThat(result.get("mattes").values()).extracting(JsonNode::asString).containsExactlyInAnyOrder("CryptoObject", "CryptoMaterial",
                "CryptoAsset");
        assertThat(result.get("largest").asDouble()).isEqualTo(1);
        assertThat(result.get("difference").asDouble()).isZero();
    }
}
