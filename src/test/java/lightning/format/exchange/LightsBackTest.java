package lightning.format.exchange;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.format.gltf.Gltf;
import lightning.format.jen.JenReader;
import lightning.format.mesh.MeshException;
import lightning.scene.Attenuation;
import lightning.scene.Light;
import lightning.scene.LightType;
import lightning.scene.Scene;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tools.jackson.databind.DeserializationFeature;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ObjectNode;

/** Lights go back into the glTF file that they came from. */
class LightsBackTest {
    private static final JsonMapper EXACT = JsonMapper.builder().enable(DeserializationFeature.USE_BIG_DECIMAL_FOR_FLOATS).build();
    private static final String SCENE = Gltf.SQUARE_JSON.replace("'nodes': [{'mesh': 0, 'name': 'floor'}]", """
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
    void bringIn() throws Exception {
        gltf = Files.write(folder.resolve("a.gltf"), Gltf.text(SCENE, Gltf.SQUARE));
        scene = imported(gltf, "a.jen");
    }

    @Test
    void lightsThatWereNotTouched_comeBackAsTheyWere() throws Exception {
        Scene again = imported(back(scene), "b.jen");
        assertThat(again.lights()).hasSize(2);
        for (int i = 0; i < 2; i++) {
            assertSame(again.lights().get(i), scene.lights().get(i));
        }
    }

    @Test
    void editedLights_comeBackAsTheyAre() throws Exception {
        Light lamp = scene.light("lamp").orElseThrow();
        Scene edited =
                scene.withLight(lamp.withPosition(new Vec3(3, 4, -5)).withIntensity(2 * lamp.intensity()).withColor(new Rgb(0, 1, 0.5)))
                        .withLight(scene.light("beam").orElseThrow().withDirection(new Vec3(0, 0, 3)).withAngle(38));
        List<Light> more = new ArrayList<>(edited.lights());
        more.add(Light.of("sun", LightType.DIRECTIONAL).withDirection(new Vec3(1, -2, 0.5)).withIntensity(0.25));
        edited = edited.withLights(more);
        Scene again = imported(back(edited), "b.jen");
        assertThat(again.lights()).hasSize(3);
        for (int i = 0; i < 3; i++) {
            assertSame(again.light(edited.lights().get(i).name()).orElseThrow(), edited.lights().get(i));
        }
    }

    @Test
    void allElse_staysAsItIs() throws Exception {
        assertThat(withoutLights(EXACT.readTree(Files.readAllBytes(back(scene)))))
                .isEqualTo(withoutLights(EXACT.readTree(Files.readAllBytes(gltf))));
        assertThat(Files.readString(back(scene))).contains("1.2300000000000000000004", "12345678901234567890");
    }

    @Test
    void binaryFile_keepsItsData() throws Exception {
        gltf = Files.write(folder.resolve("c.glb"), Gltf.binary(SCENE, Gltf.SQUARE));
        byte[] copy = LightsBack.into(gltf, scene, LightUnits.CANDELA, Progress.NONE).bytes();
        byte[] end = Arrays.copyOfRange(copy, copy.length - Gltf.SQUARE.length, copy.length);
        assertThat(end).isEqualTo(Gltf.SQUARE);
        assertThat(imported(Files.write(folder.resolve("d.glb"), copy), "d.jen").lights()).hasSize(2);
    }

    @Test
    void whatGltfCannotSay_isTold() throws Exception {
        Scene odd = scene.withLight(scene.light("lamp").orElseThrow().withAttenuation(new Attenuation(1, 0.5, 0)))
                .withLight(scene.light("beam").orElseThrow().withOn(false).withAngle(120));
        assertThat(LightsBack.into(gltf, odd, LightUnits.CANDELA, Progress.NONE).notes()).containsKeys(
                "lights that do not fall off with the square of the distance; theirs is right at distance 1",
                "lights that are dark, which shine there", "spots wider than 90 degrees");
    }

    @Test
    void numberThatNobodyCanHold_isRefusedWithItsPlace() throws Exception {
        assertRefused("1e999", "extensions.KHR_lights_punctual.lights[0].intensity: must be a number of at most 1.8e308, was '1E+999'");
        assertRefused("1e9999999999", "line 5, column 83: must be a number with an exponent below 2147483648, was '1e9999999999'");
        assertRefused("9".repeat(400), "lights[0].intensity: must be a number of at most 1.8e308, was '" + "9".repeat(99) + "…'");
    }

    private void assertRefused(String intensity, String message) throws Exception {
        Files.write(gltf, Gltf.text(SCENE.replace("'intensity': 5", "'intensity': " + intensity), Gltf.SQUARE));
        assertThatExceptionOfType(MeshException.class).isThrownBy(() -> back(scene)).withMessageEndingWith(message);
    }

    @Test
    void plainList_saysAllOfALight() {
        JsonNode lamp = EXACT.readTree(LightsBack.json(scene).bytes()).get("lights").get(0);
        assertThat(lamp.get("name").asString()).isEqualTo("lamp");
        assertThat(lamp.get("at").get(1).asDouble()).isEqualTo(1);
        assertThat(lamp.propertyNames()).contains("type", "color", "intensity", "direction", "attenuation", "angle", "dropoff", "on",
                "solo");
    }

    /** The file without the extension's lists and references. */
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

    private Path back(Scene of) throws Exception {
        return Files.write(folder.resolve("back.gltf"), LightsBack.into(gltf, of, LightUnits.CANDELA, Progress.NONE).bytes());
    }

    private Scene imported(Path file, String name) throws Exception {
        Path to = folder.resolve(name);
        Importer.read(file, to, LightUnits.CANDELA, Progress.NONE).write();
        return JenReader.read(to).scene();
    }
}
