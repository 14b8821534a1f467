package lightning.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.document.manipulation.PreviewCamera;
import lightning.document.manipulation.Viewport;
import lightning.format.jen.JenDocument;
import lightning.format.jen.JenReader;
import lightning.sample.Nightly;
import lightning.sample.PythonPrograms;
import lightning.sample.Slow;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import lightning.scene.material.Material;
import lightning.scene.node.SceneNode;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** The Blender add-on in Blender itself. */
@Slow
@DisabledOnOs(OS.WINDOWS)
class BlenderAddOnTest {
    /** Blender has single precision, and its matrices are products. */
    private static final double PRECISION = 2e-5;
    @TempDir
    private Path folder;

    @BeforeEach
    void requireBlender() {
        PythonPrograms.require("bpy");
    }

    private String run(String script, String... arguments) throws Exception {
        return Blender.run(folder, script, arguments);
    }

    @Test
    void lights_areEqualOutAndBack() throws Exception {
        assertThat(run("blender_round_trip.py")).contains("all lights are equal");
    }

    @Test
    void keysAndNodesOfLights_areEqualOutAndBack() throws Exception {
        assertThat(run("blender_keys.py")).contains("all keys are equal");
    }

    @Test
    void temperatures_areThoseOfBlender() throws Exception {
        assertThat(run("blender_temperatures.py")).contains("all temperatures are equal");
    }

    @Test
    void objectsAndMaterials_comeBack() throws Exception {
        assertThat(run("blender_objects.py")).contains("all objects are equal");
    }

    @Test
    void settingsOfPicture_comeBackOrSurvive() throws Exception {
        assertThat(run("blender_picture.py")).contains("the picture is equal");
    }

    @Test
    void filesOfUser_stay() throws Exception {
        assertThat(run("blender_files.py")).contains("no file of the user has changed");
    }

    /** With a program that starts, so that it can be killed. {@link #filesOfUser_stay} sends while the program fails. */
    @Test
    @Nightly
    void killedWhileSending_losesNothing() throws Exception {
        BlenderAddOn.install(folder);
        assertThat(PythonPrograms.output(folder, List.of("-B", Path.of("src/test/python/blender_kills.py").toAbsolutePath().toString(),
                folder.toString(), Integer.toString(Integer.getInteger("lightning.kills", 4)), "1"))).contains("nothing is lost");
    }

    private void compareWithCycles(String light, String pixels) throws Exception {
        assertThat(run("blender_cycles.py", light, Path.of("textures/evening_sky.hdr").toAbsolutePath().toString(), pixels))
                .contains(light + ": sum");
    }

    /** One light of each kind that the add-on converts in its own way. */
    @ParameterizedTest
    @ValueSource(strings = {"ball", "spot", "wide_sun", "profile360", "screen", "softbox", "tilted_image"})
    void middleOfPictures_equalsDirectLightOfCycles(String light) throws Exception {
        compareWithCycles(light, "part");
    }

    /** All pixels of more lights than {@link #middleOfPictures_equalsDirectLightOfCycles}. */
    @ParameterizedTest
    @Nightly
    @ValueSource(strings = {"point", "ball", "spot", "sun", "profile", "profile180", "profile360", "lamp", "lamp90", "lamp270",
        "lamp360", "wide_sun", "screen", "window", "rect", "disc", "softbox", "snoot", "warm", "world", "sky", "tilted_sky", "tilted_image",
        "photo"})
    void pictures_equalDirectLightOfCycles(String light) throws Exception {
        compareWithCycles(light, "whole");
    }

    @Test
    void rotationOfSky_comesBack() throws Exception {
        assertThat(run("blender_sky.py")).contains("the sky is equal");
    }

    @Test
    void skyAndFog_areSentAndTheRestIsNamed() throws Exception {
        assertThat(run("blender_world.py")).contains("the world is equal");
    }

    @Test
    void partsOfScene_areSent() throws Exception {
        run("blender_parts.py");
        JenDocument document = JenReader.read(folder.resolve("parts.jen"));
        Scene scene = document.scene();
        assertMaterials(scene);
        assertThat(document.text()).contains("mesh Copy {").containsPattern("part Cube\n.*at 2 ");
        assertThat(scene.stage().hasNode("Excluded") || scene.stage().hasNode("Off")).isFalse();
        assertThat(scene.light("Away").orElseThrow().on()).isFalse();
        assertNear(scene.light("Away").orElseThrow().position().y(), 3);
        assertThat(document.text()).containsPattern("group Pots \\{\\s*at 20 0 0\\s*mesh Pot ")
                .containsPattern("group \"Pots.001\" \\{\\s*at 30 0 0\\s*mesh \"Pot 2\" ");
        assertThat(scene.light("Light").orElseThrow().illuminates().names()).containsExactly("Both");
        JsonNode frames = JsonMapper.builder().build().readTree(Files.readAllBytes(folder.resolve("frames.json")));
        assertThat(frames.size()).isEqualTo(12);
        assertThat(document.shot().orElseThrow().rate()).isEqualTo(25);
        for (var frame : frames.properties()) {
            assertFrame(document.shot().orElseThrow().sceneAt(scene, Integer.parseInt(frame.getKey())), frame.getValue());
        }
    }

    private static void assertMaterials(Scene scene) {
        Material water = material(scene, "water");
        assertThat(water.transmission().thin()).isFalse();
        assertNear(water.transmission().ior(), 1.33);
        // Light through both surfaces has the color of a Principled BSDF once, and that of a Glass BSDF twice.
        assertNear(water.transmission().color().g(), 0.6);
        assertNear(water.transmission().color().b(), 0.3);
        // Light falls by exp(−(1 − color) · density · distance).
        assertNear(Math.pow(water.transmission().tint().r(), 1 / water.transmission().tintDistance()), Math.exp(-0.75 * 2));
        assertNear(Math.pow(water.transmission().tint().g(), 1 / water.transmission().tintDistance()), Math.exp(-0.5 * 2));
        assertThat(material(scene, "crystal").transmission().thin()).isFalse();
        assertNear(material(scene, "crystal").transmission().ior(), 1.7);
        assertNear(material(scene, "crystal").transmission().color().g(), 0.5);
        assertThat(material(scene, "pane").transmission().thin()).isTrue();
        Material wall = material(scene, "wall");
        assertThat(wall.texture()).isPresent();
        assertThat(wall.bumpMapping().normalMap()).isPresent();
        assertNear(wall.bumpMapping().strength(), 0.5);
        assertNear(wall.metalness(), 0.25);
        assertNear(wall.roughness(), 0.75);
        assertThat(material(scene, "leaf").cutout().map()).isPresent();
        assertNear(material(scene, "leaf").glow().r(), 2);
    }

    private static Material material(Scene scene, String name) {
        return scene.materials().stream().filter(m -> m.name().equals(name)).findFirst().orElseThrow();
    }

    private static void assertFrame(Scene scene, JsonNode expected) {
        assertThat(scene.picture().width()).isEqualTo(200);
        assertThat(scene.picture().height()).isEqualTo(320);
        for (String name : List.of("Copy", "Both")) {
            SceneNode node = scene.stage().node(name).orElseThrow();
            Transform transform = node.placement().transform();
            assertNear(transform.transformVector(new Vec3(1, 0, 0)), expected.get(name).get(0));
            assertNear(transform.transformVector(new Vec3(0, 1, 0)), expected.get(name).get(1));
            assertNear(transform.transformVector(new Vec3(0, 0, 1)), expected.get(name).get(2));
            assertNear(transform.transformPoint(Vec3.ZERO), expected.get(name).get(3));
        }
        assertNear(scene.camera().from(), expected.get("camera").get(3));
        assertNear(scene.camera().to().minus(scene.camera().from()).normalized().times(-1), expected.get("camera").get(1));
        assertNear(scene.camera().fov(), expected.get("fov").asDouble());
        JsonNode seen = expected.get("seen");
        Viewport.Pixel pixel = new Viewport(200, 320).project(PreviewCamera.of(scene), vector(expected.get("point")));
        assertNear(pixel.x() / 200, seen.get(0).asDouble());
        assertNear(1 - pixel.y() / 320, seen.get(1).asDouble());
        Light light = scene.light("Light").orElseThrow();
        assertNear(light.position(), expected.get("Light").get(3));
        assertThat(light.on()).isEqualTo(expected.get("on").asBoolean());
        assertNear(light.color().g(), expected.get("color").get(1).asDouble());
    }

    private static Vec3 vector(JsonNode in) {
        return new Vec3(in.get(0).asDouble(), in.get(1).asDouble(), in.get(2).asDouble());
    }

    private static void assertNear(Vec3 actual, JsonNode expected) {
        assertNear(actual.x(), expected.get(0).asDouble());
        assertNear(actual.y(), expected.get(1).asDouble());
        assertNear(actual.z(), expected.get(2).asDouble());
    }

    private static void assertNear(double actual, double expected) {
        assertThat(Math.abs(actual - expected)).as("%s, expected %s", actual, expected)
                .isLessThanOrEqualTo(PRECISION * Math.max(1, Math.abs(expected)));
    }
}
