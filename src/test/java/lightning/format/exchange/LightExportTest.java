package lightning.format.exchange;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.data.Offset.offset;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.format.exchange.assembly.ExportedLights;
import lightning.format.exchange.assembly.LightUnits;
import lightning.format.exchange.json.PictureJson;
import lightning.format.gltf.GltfFixtures;
import lightning.format.jen.JenReader;
import lightning.format.mesh.MeshException;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.shot.AnimatedScene;
import lightning.scene.value.Attenuation;
import org.assertj.core.api.Assertions;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tools.jackson.databind.DeserializationFeature;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ObjectNode;

/** Export of lights to the glTF file from which they were imported. */
class LightExportTest {
    private static final JsonMapper EXACT = JsonMapper.builder().enable(DeserializationFeature.USE_BIG_DECIMAL_FOR_FLOATS).build();
    private static final String SCENE = GltfFixtures.SQUARE_JSON.replace("'nodes': [{'mesh': 0, 'name': 'floor'}]", """
            'nodes': [{'name': 'set', 'translation': [0, 0, 5.000], 'children': [1, 2, 3]}, {'mesh': 0, 'name': 'floor'},
              {'name': 'lamp', 'translation': [0, 1, 0], 'extensions': {'KHR_lights_punctual': {'light': 0}}},
              {'name': 'beam', 'rotation': [0, 0.6, 0, 0.8], 'extensions': {'KHR_lights_punctual': {'light': 1}, 'OTHER': {'a': 1.10}}}],
             'extras': {'kept': [1.2300000000000000000004, 1e2, -0.0, 'ä', null, true, 12345678901234567890]},
             'extensions': {'KHR_lights_punctual': {'lights': [{'type': 'point', 'intensity': 5, 'color': [1, 0.5, 0.25]},
              {'type': 'spot', 'intensity': 7, 'spot': {'innerConeAngle': 0.3, 'outerConeAngle': 0.6}}]}}""");
    @TempDir
    private Path folder;
    private Path gltf;
    private Scene scene;

    @BeforeEach
    void setUp() throws Exception {
        gltf = Files.write(folder.resolve("a.gltf"), GltfFixtures.text(SCENE, GltfFixtures.SQUARE));
        scene = imported(gltf, "a.jen");
    }

    @Test
    void untouchedLights_roundTrip() throws Exception {
        Scene reimported = imported(exported(scene), "b.jen");
        assertThat(reimported.lights()).hasSize(2);
        for (int i = 0; i < 2; i++) {
            assertSame(reimported.lights().get(i), scene.lights().get(i));
        }
    }

    @Test
    void editedLights_roundTrip() throws Exception {
        Light light = scene.light("lamp").orElseThrow();
        Scene edited =
                scene.withLight(light.withPosition(new Vec3(3, 4, -5)).withIntensity(2 * light.intensity()).withColor(new Rgb(0, 1, 0.5)))
                        .withLight(scene.light("beam").orElseThrow().withDirection(new Vec3(0, 0, 3)).withAngle(38));
        List<Light> lights = new ArrayList<>(edited.lights());
        lights.add(Light.of("sun", LightType.DIRECTIONAL).withDirection(new Vec3(1, -2, 0.5)).withIntensity(0.25));
        edited = edited.withLights(lights);
        Scene reimported = imported(exported(edited), "b.jen");
        assertThat(reimported.lights()).hasSize(3);
        for (int i = 0; i < 3; i++) {
            assertSame(reimported.light(edited.lights().get(i).name()).orElseThrow(), edited.lights().get(i));
        }
    }

    @Test
    void otherContent_isUnchanged() throws Exception {
        assertThat(withoutLights(EXACT.readTree(Files.readAllBytes(exported(scene)))))
                .isEqualTo(withoutLights(EXACT.readTree(Files.readAllBytes(gltf))));
        assertThat(Files.readString(exported(scene))).contains("1.2300000000000000000004", "12345678901234567890");
    }

    @Test
    void binaryFile_retainsItsData() throws Exception {
        gltf = Files.write(folder.resolve("c.glb"), GltfFixtures.binary(SCENE, GltfFixtures.SQUARE));
        byte[] copy = LightExport.toGltf(gltf, scene, LightUnits.CANDELA, Progress.NONE).bytes();
        byte[] end = Arrays.copyOfRange(copy, copy.length - GltfFixtures.SQUARE.length, copy.length);
        assertThat(end).isEqualTo(GltfFixtures.SQUARE);
        assertThat(imported(Files.write(folder.resolve("d.glb"), copy), "d.jen").lights()).hasSize(2);
    }

    @Test
    void unsupportedFeatures_areNoted() throws Exception {
        Scene odd = scene.withLight(scene.light("lamp").orElseThrow().withAttenuation(new Attenuation(1, 0.5, 0)))
                .withLight(scene.light("beam").orElseThrow().withOn(false).withAngle(120));
        assertThat(LightExport.toGltf(gltf, odd, LightUnits.CANDELA, Progress.NONE).notes()).containsKeys(
                "lights without inverse-square falloff, exact only at distance 1",
                "lights that are off, exported as on", "spots wider than 90 degrees");
    }

    @Test
    void hugeNumber_isRejectedWithItsPath() throws Exception {
        assertRejected("1e999", "extensions.KHR_lights_punctual.lights[0].intensity: must be a number of at most 1.8e308, was '1E+999'");
        assertRejected("1e9999999999", "line 5, column 83: must be a number with an exponent below 2147483648, was '1e9999999999'");
        assertRejected("9".repeat(400), "lights[0].intensity: must be a number of at most 1.8e308, was '" + "9".repeat(99) + "…'");
    }

    private void assertRejected(String intensity, String message) throws Exception {
        Files.write(gltf, GltfFixtures.text(SCENE.replace("'intensity': 5", "'intensity': " + intensity), GltfFixtures.SQUARE));
        assertThatExceptionOfType(MeshException.class).isThrownBy(() -> exported(scene)).withMessageEndingWith(message);
    }

    @Test
    void jsonList_hasEveryAttribute() {
        JsonNode light = EXACT.readTree(LightExport.toJson(AnimatedScene.of(scene)).bytes()).get("lights").get(0);
        assertThat(light.get("name").asString()).isEqualTo("lamp");
        assertThat(light.get("at").get(1).asDouble()).isEqualTo(1);
        assertThat(light.propertyNames()).contains("type", "color", "intensity", "direction", "attenuation", "angle", "dropoff", "on",
                "solo");
    }

    @Test
    void jsonList_hasObjectsAndMaterials() throws Exception {
        String text = "jen 1\ncamera { from 0 0 5  to 0 0 0 }\nmaterial red { model metallic  base 0.5 0.25 0.125  roughness 0.75 }\n"
                + "sphere ball { material red  at 1 2 3  scale 4 5 6  visible no }\n";
        JsonNode root = EXACT.readTree(LightExport.toJson(JenReader.read(text, "text", folder).animatedScene()).bytes());
        JsonNode ball = root.at("/objects/0");
        assertThat(ball.get("name").stringValue()).isEqualTo("ball");
        assertThat(ball.get("visible").booleanValue()).isFalse();
        assertThat(ball.get("matrix").valueStream().map(JsonNode::doubleValue))
                .containsExactly(4.0, 0.0, 0.0, 0.0, 0.0, 5.0, 0.0, 0.0, 0.0, 0.0, 6.0, 0.0, 1.0, 2.0, 3.0, 1.0);
        JsonNode red = root.at("/materials/0");
        assertThat(red.get("name").stringValue()).isEqualTo("red");
        assertThat(red.get("base").valueStream().map(JsonNode::doubleValue)).containsExactly(0.5, 0.25, 0.125);
        assertThat(red.get("roughness").doubleValue()).isEqualTo(0.75);
    }

    @Test
    void jsonList_hasAnimatedAttributesAtEachFrame() throws Exception {
        String text = """
                jen 1
                light lamp point { at 0 1 0 intensity 2 attenuation 0 0 1 }
                shot { frames 3 5  rate 25  light lamp { intensity { 3 1  5 4 }  on { 4 no }  at { 3 0 1 0  5 2 1 0 } } }
                """;
        JsonNode root = EXACT.readTree(LightExport.toJson(JenReader.read(text, "text", folder).animatedScene()).bytes());
        assertThat(root.get("lights").get(0).get("intensity").asDouble()).isEqualTo(2);
        assertThat(root.get("shot").get("frames").toString()).isEqualTo("[3,5]");
        assertThat(root.get("shot").get("rate").asDouble()).isEqualTo(25);
        List<String> tracks = new ArrayList<>();
        root.get("shot").get("tracks").forEach(track -> tracks.add(track.toString()));
        assertThat(tracks).containsExactlyInAnyOrder(
                "{\"light\":\"lamp\",\"attribute\":\"intensity\",\"values\":[1.0,2.5,4.0]}",
                "{\"light\":\"lamp\",\"attribute\":\"relative_intensity\",\"values\":[1.0,2.5,4.0]}",
                "{\"light\":\"lamp\",\"attribute\":\"on\",\"values\":[false,false,false]}",
                "{\"light\":\"lamp\",\"attribute\":\"at\",\"values\":[[0.0,1.0,0.0],[1.0,1.0,0.0],[2.0,1.0,0.0]]}");
        assertThat(EXACT.readTree(LightExport.toJson(AnimatedScene.of(scene)).bytes()).has("shot")).isFalse();
    }

    /** The JSON of a picture restores it. */
    @Test
    void jsonList_hasPicture() throws Exception {
        for (String settings : List.of("size 8 5",
                "size 8 5 depth 2 view agx exposure 1.5 antialias every samples 3 indirect { bounces 3 }")) {
            Scene scene = JenReader.read("jen 1\npicture { " + settings + " }", "text", folder).scene();
            JsonNode json = EXACT.readTree(LightExport.toJson(AnimatedScene.of(scene)).bytes()).get("picture");
            assertThat(PictureJson.read(json, PictureSettings.DEFAULT, Assertions::fail)).isEqualTo(scene.picture());
        }
    }

    @Test
    void jsonList_hasAnimatedGroupsCameraAndObjects() throws Exception {
        String text = """
                jen 1
                picture { size 8 8 }
                camera { from 0 1 5 to 0 0 0 }
                bank fills { intensity 2 }
                light lamp point { at 0 1 0 bank fills }
                material white { diffuse 1 1 1 }
                sphere ball { at 0 0 0 scale 2 1 1 material white }
                group pair { at 0 0 0  sphere inner { at 0 0 0 material white } }
                shot {
                  frames 1 2  rate 25
                  bank fills { intensity { 1 2  2 4 } }
                  camera { fov { 1 30  2 50 } }
                  sphere ball { at { 1 0 0 0  2 3 4 5 }  rotate { 1 0 90 0 } }
                  sphere inner { at { 1 0 0 0  2 3 4 5 } }
                }
                """;
        ExportedLights export = LightExport.toJson(JenReader.read(text, "text", folder).animatedScene());
        JsonNode root = EXACT.readTree(export.bytes());
        assertThat(root.get("camera").get("from").toString()).isEqualTo("[0.0,1.0,5.0]");
        assertThat(export.notes()).containsExactly(Map.entry("animated objects inside of groups", 1));
        JsonNode tracks = root.get("shot").get("tracks");
        assertThat(tracks.get(0).toString()).isEqualTo("{\"bank\":\"fills\",\"attribute\":\"intensity\",\"values\":[2.0,4.0]}");
        assertThat(tracks.get(1).toString()).isEqualTo("{\"camera\":true,\"attribute\":\"fov\",\"values\":[30.0,50.0]}");
        assertThat(tracks.get(2).get("node").asString()).isEqualTo("ball");
        // x is twice as long and turned to -z, y stays, z is turned to x; the position comes last.
        double[] expected = {0, 0, -2, 0, 0, 1, 0, 0, 1, 0, 0, 0, 3, 4, 5, 1};
        for (int i = 0; i < expected.length; i++) {
            assertThat(tracks.get(2).get("matrices").get(1).get(i).asDouble()).isCloseTo(expected[i], offset(1e-12));
        }
        assertThat(tracks.size()).isEqualTo(3);
    }

    /** Returns the file without the extension's lists and references. */
    private static JsonNode withoutLights(JsonNode root) {
        ((ObjectNode) root.get("extensions")).remove("KHR_lights_punctual");
        ((ObjectNode) root).remove("extensionsUsed");
        root.get("nodes").forEach(node -> {
            if (node.get("extensions") instanceof ObjectNode extensions) {
                extensions.remove("KHR_lights_punctual");
                if (extensions.isEmpty()) {
                    ((ObjectNode) node).remove("extensions");
                }
            }
        });
        return root;
    }

    private static void assertSame(Light actual, Light expected) {
        assertThat(actual.name()).isEqualTo(expected.name());
        assertThat(actual.type()).isEqualTo(expected.type());
        assertNear(actual.weight().r() / quadratic(actual), expected.weight().r() / quadratic(expected));
        assertNear(actual.weight().g() / quadratic(actual), expected.weight().g() / quadratic(expected));
        if (expected.type().hasPosition()) {
            assertThat(actual.position().minus(expected.position()).maxAbs()).isLessThan(1e-5);
        }
        if (expected.type().hasDirection()) {
            assertThat(actual.direction().normalized().minus(expected.direction().normalized()).maxAbs()).isLessThan(1e-5);
        }
        if (expected.type().hasCone()) {
            assertNear(actual.angle(), expected.angle());
            assertThat(Math.abs(actual.dropoff() - expected.dropoff())).isLessThan(1e-5 * (1 + expected.dropoff()));
        }
    }

    private static double quadratic(Light light) {
        return light.type().hasPosition() ? light.attenuation().quadratic() : 1;
    }

    private static void assertNear(double actual, double expected) {
        assertThat(Math.abs(actual - expected)).as("%s, expected %s", actual, expected)
                .isLessThanOrEqualTo(1e-9 * Math.max(1e-6, Math.abs(expected)));
    }

    private Path exported(Scene edited) throws Exception {
        return Files.write(folder.resolve("back.gltf"), LightExport.toGltf(gltf, edited, LightUnits.CANDELA, Progress.NONE).bytes());
    }

    private Scene imported(Path file, String name) throws Exception {
        Path sceneFile = folder.resolve(name);
        SceneImporter.read(file, sceneFile, LightUnits.CANDELA, Progress.NONE).write();
        return JenReader.read(sceneFile).scene();
    }
}
