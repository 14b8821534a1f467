package lightning.format.exchange;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.format.exchange.assembly.ImportedScene;
import lightning.format.exchange.assembly.LightUnits;
import lightning.format.gltf.GltfFixtures;
import lightning.format.jen.JenDocument;
import lightning.format.jen.JenReader;
import lightning.format.mesh.MeshException;
import lightning.sample.ByteFuzzer;
import lightning.scene.Camera;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import lightning.scene.shot.Shot;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Animations of glTF files: the values at each frame. */
class GltfAnimationTest {
    private static final int ACCESSORS = 4;
    private static final int VIEWS = 2;
    private static final String LAMPS = "'extensions': {'KHR_lights_punctual': {'lights': [{'type': 'spot', 'intensity': 100}]}}";

    @TempDir
    private Path folder;
    /** Channels of the animation, and the samplers and accessors that they need. */
    private final List<String> channels = new ArrayList<>();
    private final List<String> samplers = new ArrayList<>();
    private final List<String> accessors = new ArrayList<>();
    private final List<String> views = new ArrayList<>();
    private final List<byte[]> data = new ArrayList<>(List.of(GltfFixtures.SQUARE));

    private static byte[] floats(double... values) {
        ByteBuffer bytes = ByteBuffer.allocate(4 * values.length).order(ByteOrder.LITTLE_ENDIAN);
        for (double v : values) {
            bytes.putFloat((float) v);
        }
        return bytes.array();
    }

    private int byteCount() {
        return data.stream().mapToInt(bytes -> bytes.length).sum();
    }

    private int accessor(String type, int components, double... values) {
        views.add(String.format(Locale.ROOT, "{'buffer': 0, 'byteOffset': %d, 'byteLength': %d}", byteCount(), 4 * values.length));
        data.add(floats(values));
        accessors.add(String.format(Locale.ROOT, "{'bufferView': %d, 'componentType': 5126, 'count': %d, 'type': '%s'}",
                VIEWS + views.size() - 1, values.length / components, type));
        return ACCESSORS + accessors.size() - 1;
    }

    private int sampler(String interpolation, double[] times, int components, double... values) {
        int input = accessor("SCALAR", 1, times);
        int output = accessor(List.of("SCALAR", "VEC2", "VEC3", "VEC4").get(components - 1), components, values);
        samplers.add(String.format(Locale.ROOT, "{'input': %d, 'output': %d, 'interpolation': '%s'}", input, output, interpolation));
        return samplers.size() - 1;
    }

    private void key(int node, String path, String interpolation, double[] times, double... values) {
        int components = path.equals("rotation") ? 4 : path.equals("weights") ? 1 : 3;
        channels.add(String.format(Locale.ROOT, "{'sampler': %d, 'target': {'node': %d, 'path': '%s'}}",
                sampler(interpolation, times, components, values), node, path));
    }

    private void pointer(String pointer, int components, double[] times, double... values) {
        channels.add(String.format(Locale.ROOT,
                "{'sampler': %d, 'target': {'path': 'pointer', 'extensions': {'KHR_animation_pointer': {'pointer': '%s'}}}}",
                sampler("LINEAR", times, components, values), pointer));
    }

    private static double[] times(double... seconds) {
        return seconds;
    }

    /** Returns the file with nodes; other properties of its root follow. */
    private byte[] file(String nodes, String others) {
        String json = GltfFixtures.SQUARE_JSON.replace("'nodes': [{'mesh': 0, 'name': 'floor'}]", "'nodes': [" + nodes + "]"
                + (others.isEmpty() ? "" : ", " + others) + ", 'animations': [{'channels': [" + String.join(", ", channels)
                + "], 'samplers': ["
                + String.join(", ", samplers) + "]}]");
        json = json.replace("'byteLength': 12}]", "'byteLength': 12}, " + String.join(", ", views) + "]")
                .replace("'count': 6, 'type': 'SCALAR'}", "'count': 6, 'type': 'SCALAR'}, " + String.join(", ", accessors))
                .replace("'byteLength': 140", "'byteLength': " + byteCount());
        ByteBuffer all = ByteBuffer.allocate(byteCount());
        data.forEach(all::put);
        return GltfFixtures.binary(json, all.array());
    }

    private ImportedScene read(byte[] file, LightUnits units) throws IOException, MeshException {
        return SceneImporter.read(Files.write(folder.resolve("a.glb"), file), folder.resolve("scene/a.jen"), units, Progress.NONE);
    }

    private ImportedScene read(String nodes, String others) throws IOException, MeshException {
        return read(file(nodes, others), LightUnits.CANDELA);
    }

    private JenDocument written(ImportedScene imported) throws Exception {
        Files.createDirectories(folder.resolve("scene"));
        imported.writeReplacing();
        return JenReader.read(folder.resolve("scene/a.jen"));
    }

    private static Scene at(JenDocument document, double frame) {
        return document.shot().orElseThrow().sceneAt(document.scene(), frame);
    }

    private static void assertNear(Vec3 actual, Vec3 expected) {
        assertThat(actual.minus(expected).maxAbs()).as("%s, expected %s", actual, expected).isLessThan(1e-5);
    }

    private static Vec3 corner(Scene scene) {
        return scene.placedShapes().getFirst().toWorld().transformPoint(new Vec3(1, 0, 0));
    }

    /** The parent turns a light about z by 90° in 24 frames, at distance 2, while the light rises by 1 for each second. */
    @Test
    void lightOfAMovingParent_isAtItsPlaceInEachFrame() throws Exception {
        double h = Math.sqrt(0.5);
        key(1, "rotation", "LINEAR", times(0, 1), 0, 0, 0, 1, 0, 0, h, h);
        key(2, "translation", "LINEAR", times(0, 1), 2, 0, 0, 2, 0, 1);
        JenDocument document = written(read("{'mesh': 0, 'children': [1]}, {'children': [2]},"
                + " {'name': 'lamp', 'extensions': {'KHR_lights_punctual': {'light': 0}}}", LAMPS));
        Shot shot = document.shot().orElseThrow();
        assertThat(List.of(shot.first(), shot.last(), shot.rate())).isEqualTo(List.of(0, 24, 24.0));
        for (int frame = 0; frame <= 24; frame++) {
            double angle = Math.PI / 2 * frame / 24;
            Light light = at(document, frame).lights().getFirst();
            assertNear(light.position(), new Vec3(2 * Math.cos(angle), 2 * Math.sin(angle), frame / 24.0));
            assertNear(light.direction(), new Vec3(0, 0, -1));
        }
    }

    /** Appendix C of glTF 2.0, with a tangent of (0, 0, 8) per second at the start. */
    @Test
    void cubicSpline_isHermitesCubicWithTangentsPerSecond() throws Exception {
        key(0, "translation", "CUBICSPLINE", times(0, 2), 9, 9, 9, 0, 0, 0, 0, 0, 8, 0, 0, -3, 4, 0, 0, 9, 9, 9);
        JenDocument document = written(read("{'mesh': 0}", ""));
        for (int frame = 0; frame <= 48; frame++) {
            double t = frame / 48.0;
            double h10 = t * t * t - 2 * t * t + t;
            double h01 = -2 * t * t * t + 3 * t * t;
            double h11 = t * t * t - t * t;
            assertNear(corner(at(document, frame)), new Vec3(1 + 4 * h01, 0, 2 * 8 * h10 + 2 * -3 * h11));
        }
    }

    @Test
    void steps_holdUntilTheNextKey() throws Exception {
        // 1 / 3 second is frame 8, though the float of the time is a little more.
        key(0, "scale", "STEP", times(0, 1 / 3.0, 1), 1, 1, 1, 2, 1, 1, 3, 1, 1);
        JenDocument document = written(read("{'mesh': 0}", ""));
        assertThat(Stream.of(0, 7, 8, 23, 24).map(frame -> corner(at(document, frame)).x())).containsExactly(1.0, 1.0, 2.0, 2.0, 3.0);
    }

    @Test
    void rotation_takesTheShorterArcWithConstantSpeed() throws Exception {
        // From 0° to 120° about z; the second quaternion has the other sign.
        key(0, "rotation", "LINEAR", times(0, 0.5), 0, 0, 0, 1, 0, 0, -Math.sin(Math.PI / 3), -Math.cos(Math.PI / 3));
        JenDocument document = written(read("{'mesh': 0, 'scale': [3, 3, 3]}", ""));
        for (int frame = 0; frame <= 12; frame++) {
            double angle = Math.toRadians(10 * frame);
            assertNear(corner(at(document, frame)), new Vec3(3 * Math.cos(angle), 3 * Math.sin(angle), 0));
        }
    }

    @Test
    void rate_isTheFirstUsualOneThatHasAllKeys() throws Exception {
        for (double rate : List.of(24.0, 25.0, 30.0, 60.0)) {
            channels.clear();
            key(0, "translation", "LINEAR", times(7 / rate, 11 / rate, 19 / rate), 0, 0, 0, 1, 0, 0, 5, 0, 0);
            Shot shot = read("{'mesh': 0}", "").shot().orElseThrow();
            assertThat(List.of(shot.first(), shot.last(), shot.rate())).isEqualTo(List.of(7, 19, rate));
        }
        channels.clear();
        key(0, "translation", "LINEAR", times(0.1234, 0.777), 0, 0, 0, 1, 0, 0);
        Shot shot = read("{'mesh': 0}", "").shot().orElseThrow();
        assertThat(List.of(shot.first(), shot.last(), shot.rate())).isEqualTo(List.of(2, 19, 24.0));
    }

    @Test
    void cameraInMovingNode_movesWithIt() throws Exception {
        key(1, "translation", "LINEAR", times(0, 1), 0, 0, 0, 12, 0, 0);
        pointer("/cameras/0/perspective/yfov", 1, times(0, 1), Math.toRadians(30), Math.toRadians(54));
        JenDocument document = written(read("{'mesh': 0, 'children': [1]}, {'children': [2]}, {'camera': 0, 'translation': [0, 0, 9]}",
                "'cameras': [{'type': 'perspective', 'perspective': {'yfov': 0.5, 'znear': 1}}]"));
        for (int frame = 0; frame <= 24; frame++) {
            Camera camera = at(document, frame).camera();
            assertNear(camera.from(), new Vec3(frame / 2.0, 0, 9));
            assertNear(camera.to().minus(camera.from()).normalized(), new Vec3(0, 0, -1));
            assertThat(camera.fov()).isCloseTo(30 + frame, within(1e-4));
        }
    }

    @Test
    void pointers_changeLightsInTheChosenUnits() throws Exception {
        pointer("/extensions/KHR_lights_punctual/lights/0/intensity", 1, times(0, 1), 100, 340);
        pointer("/extensions/KHR_lights_punctual/lights/0/color", 3, times(0, 1), 1, 1, 1, 1, 0.5, 0);
        pointer("/nodes/0/translation", 3, times(0, 1), 0, 0, 0, 24, 0, 0);
        pointer("/materials/0/alphaCutoff", 1, times(0, 1), 0, 1);
        pointer("/nodes/99/scale", 3, times(0, 1), 1, 1, 1, 2, 2, 2);
        byte[] file = file("{'mesh': 0, 'children': [1]}, {'extensions': {'KHR_lights_punctual': {'light': 0}}}", LAMPS);
        ImportedScene imported = read(file, LightUnits.CANDELA);
        assertThat(imported.notes()).containsEntry("animated properties of a kind that is not imported", 2);
        for (LightUnits units : LightUnits.values()) {
            ImportedScene scene = imported.inUnits(units);
            Light still = scene.scene().lights().getFirst();
            for (int frame = 0; frame <= 24; frame++) {
                Light light = scene.shot().orElseThrow().sceneAt(scene.scene(), frame).lights().getFirst();
                assertThat(light.intensity() / still.intensity()).isCloseTo(1 + frame / 10.0, within(1e-6));
                assertNear(new Vec3(light.color().r(), light.color().g(), light.color().b()),
                        new Vec3(1, 1 - frame / 48.0, 1 - frame / 24.0));
                assertNear(light.position(), new Vec3(frame, 0, 0));
            }
        }
        assertThat(at(written(imported), 24).lights().getFirst().intensity())
                .isCloseTo(3.4 * imported.scene().lights().getFirst().intensity(), within(1e-9));
    }

    @Test
    void objectOfScaleZero_isHiddenInTheseFrames() throws Exception {
        key(0, "scale", "STEP", times(0, 0.5), 1, 1, 1, 0, 0, 0);
        ImportedScene imported = read("{'mesh': 0}", "");
        JenDocument document = written(imported);
        assertThat(at(document, 11).placedShapes()).hasSize(1);
        assertThat(at(document, 11).nodes().getFirst().visible()).isTrue();
        assertThat(at(document, 12).nodes().getFirst().visible()).isFalse();
        assertThat(imported.notes()).containsEntry("objects that are flat, too small or too large in some frames, hidden in these", 1);
    }

    @Test
    void objectThatIsFlatWithoutAnimation_appearsWithIt() throws Exception {
        key(0, "scale", "LINEAR", times(0, 0.5, 1), 0, 0, 0, 0, 0, 0, 3, 3, 3);
        JenDocument document = written(read("{'mesh': 0, 'scale': [0, 0, 0], 'children': [1]}, {'mesh': 0}", ""));
        assertThat(document.scene().nodes().getFirst().visible()).isFalse();
        assertThat(at(document, 12).nodes().getFirst().visible()).isFalse();
        assertThat(at(document, 13).nodes().getFirst().visible()).isTrue();
        assertNear(corner(at(document, 18)), new Vec3(1.5, 0, 0));
        channels.clear();
        key(0, "scale", "LINEAR", times(0, 1), 2, 2, 2, 2, 2, 2);
        JenDocument steady = written(read("{'mesh': 0, 'scale': [0, 0, 0]}", ""));
        assertThat(at(steady, 5).nodes().getFirst().visible()).isTrue();
        assertNear(corner(at(steady, 5)), new Vec3(2, 0, 0));
    }

    /** The values of the animation count, not those of the nodes. */
    @Test
    void animationAtRest_isAtItsOwnPlace() throws Exception {
        key(0, "translation", "LINEAR", times(0, 1), 7, 0, 0, 7, 0, 0);
        key(1, "translation", "STEP", times(0.5), 0, 4, 0);
        ImportedScene imported = read("{'mesh': 0, 'translation': [1, 2, 3], 'children': [1]},"
                + " {'name': 'key', 'extensions': {'KHR_lights_punctual': {'light': 0}}}", LAMPS);
        JenDocument document = written(imported);
        assertNear(corner(at(document, 3)), new Vec3(8, 0, 0));
        assertNear(at(document, 3).lights().getFirst().position(), new Vec3(7, 4, 0));
        assertThat(document.shot().orElseThrow().tracks()).hasSize(2).allMatch(track -> track.keys().size() == 1);
        assertThat(ImportLighting.STUDIO.apply(imported).shot().orElseThrow().tracks()).hasSize(1);
    }

    @Test
    void severalTurns_doNotTurnBack() throws Exception {
        List<Double> values = new ArrayList<>();
        double[] seconds = new double[13];
        for (int i = 0; i <= 12; i++) {
            seconds[i] = i / 4.0;
            values.addAll(List.of(Math.sin(i * Math.PI / 4), 0.0, 0.0, Math.cos(i * Math.PI / 4)));
        }
        key(0, "rotation", "LINEAR", seconds, values.stream().mapToDouble(v -> v).toArray());
        JenDocument document = written(read("{'mesh': 0}", ""));
        for (int k = 0; k <= 144; k++) {
            assertThat(at(document, k / 2.0).nodes().getFirst().placement().rotation().x()).isCloseTo(15 * k / 2.0, within(1e-3));
        }
    }

    @Test
    void movingSkinsAndMorphTargets_areNoted() throws Exception {
        key(1, "translation", "LINEAR", times(0, 1), 0, 0, 0, 1, 0, 0);
        key(0, "weights", "LINEAR", times(0, 1), 0, 1);
        ImportedScene imported = read("{'mesh': 0, 'skin': 0, 'children': [1]}, {'children': [2]}, {'name': 'joint'}",
                "'skins': [{'joints': [2]}]");
        assertThat(imported.notes()).containsEntry("moving skins and morph targets, posed as the file has them", 2);
        assertThat(imported.shot()).isEmpty();
    }

    @Test
    void invalidAnimation_isNotedAndTheRestImported() throws Exception {
        for (double[] wrong : List.of(times(1, 0), times(-1, 1), times(0, Double.NaN), times(0, 3e9), times(0, 1, 2))) {
            channels.clear();
            key(0, "translation", "LINEAR", wrong, 0, 0, 0, 1, 0, 0);
            ImportedScene imported = read("{'mesh': 0}", "");
            assertThat(imported.shot()).isEmpty();
            assertThat(imported.notes()).containsEntry("animations that cannot be read", 1);
            assertThat(imported.scene().placedShapes()).hasSize(1);
        }
        channels.clear();
        key(0, "translation", "LINEAR", times(0, 1), 0, 0, 0, 1, 0, 0);
        ImportedScene matrix = read("{'mesh': 0, 'matrix': [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]}", "");
        assertThat(matrix.notes()).containsEntry("animated properties of nodes with a matrix", 1);
        assertThat(matrix.shot()).isEmpty();
    }

    @Test
    void longAnimation_isCutAndFast() throws Exception {
        key(0, "translation", "LINEAR", times(0, 1000), 0, 0, 0, 24_000, 0, 0);
        ImportedScene imported = read("{'mesh': 0}", "");
        Shot shot = imported.shot().orElseThrow();
        assertThat(shot.last()).isEqualTo(9999);
        assertThat(shot.tracks().getFirst().keys()).hasSizeLessThan(4);
        assertThat(imported.notes()).containsEntry("frames after the first 10000", 14_001);
        assertNear(corner(shot.sceneAt(imported.scene(), 5001)), new Vec3(5002, 0, 0));
    }

    /** A mirrored node that turns: its placement has the scale and angles of one transform. */
    @Test
    void mirroredNode_keepsItsTransform() throws Exception {
        key(0, "rotation", "LINEAR", times(0, 1), 0, 0, 0, 1, 0, Math.sin(0.5), 0, Math.cos(0.5));
        JenDocument document = written(read("{'mesh': 0, 'scale': [1, -2, 1]}", ""));
        for (int frame = 0; frame <= 24; frame++) {
            Transform expected =
                    Transform.rotation(new Vec3(0, Math.toDegrees(frame / 24.0), 0)).times(Transform.scaling(new Vec3(1, -2, 1)));
            Transform actual = at(document, frame).placedShapes().getFirst().toWorld();
            for (Vec3 v : List.of(new Vec3(1, 0, 0), Vec3.Y, new Vec3(0, 0, 1))) {
                assertNear(actual.transformVector(v), expected.transformVector(v));
            }
        }
    }

    @Test
    void damagedAnimation_isReadOrRejected() throws Exception {
        key(0, "rotation", "LINEAR", times(0, 1), 0, 0, 0, 1, 0, 0.5, 0, 0.8);
        key(1, "translation", "CUBICSPLINE", times(0, 2), 9, 9, 9, 0, 0, 0, 0, 0, 8, 0, 0, -3, 4, 0, 0, 9, 9, 9);
        pointer("/extensions/KHR_lights_punctual/lights/0/intensity", 1, times(0, 1), 100, 340);
        List<byte[]> pool = List.of(file("{'mesh': 0, 'children': [1]}, {'extensions': {'KHR_lights_punctual': {'light': 0}}}", LAMPS));
        List<byte[]> insertions = Stream.of("-1", "99999999999", "1e999", "null", "\"count\": 60000000,", "\u0000\u0000\u0080\u007f", "[[",
                "STEP", "scale", "\"node\": 7,").map(text -> text.getBytes(StandardCharsets.ISO_8859_1)).toList();
        int shots = 0;
        for (int i = 0; i < ByteFuzzer.tryCount(1_000); i++) {
            SplittableRandom random = ByteFuzzer.random(i);
            try {
                ImportedScene imported = read(ByteFuzzer.mutate(pool, random, insertions), LightUnits.CANDELA);
                shots += imported.shot().isPresent() ? 1 : 0;
                imported.shot().ifPresent(shot -> shot.check(imported.scene()));
            } catch (MeshException e) {
                assertThat(e.getMessage()).as("try " + i).isNotBlank();
            } catch (IOException | RuntimeException | Error e) {
                throw new AssertionError("try " + i, e);
            }
        }
        assertThat(shots).isPositive();
    }
}
