package lightning.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.format.jen.JenDocument;
import lightning.format.jen.JenReader;
import lightning.sample.PythonPrograms;
import lightning.sample.Slow;
import lightning.scene.PlacedShape;
import lightning.scene.Scene;
import lightning.scene.material.Anisotropy;
import lightning.scene.material.Material;
import lightning.scene.material.ShadingModel;
import lightning.scene.material.Sheen;
import lightning.scene.node.Mesh;
import lightning.scene.node.NodeGroup;
import lightning.scene.node.SceneNode;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** What a render of Blender shows is in the scene that the add-on sends, or a message names it. Lengths are Blender's units; y is up. */
@Slow
@DisabledOnOs(OS.WINDOWS)
class BlenderShownTest {
    private static final double PRECISION = 2e-5;
    @TempDir
    private Path folder;

    @BeforeEach
    void requireBlender() {
        PythonPrograms.require("bpy");
    }

    private JenDocument send(String name) throws Exception {
        assertThat(Blender.run(folder, "blender_shown.py", name)).contains("sent");
        return JenReader.read(folder.resolve("scene.jen"));
    }

    private List<String> messages() throws IOException {
        return Files.readAllLines(folder.resolve("messages.txt"));
    }

    @Test
    void objectsHiddenInViewport_areAtTheirPlaces() throws Exception {
        JenDocument document = send("hidden");
        Scene scene = document.scene();
        assertBox(scene, "screen", new Vec3(1.6, 2.6, -0.4), new Vec3(2.4, 3.4, 0.4));
        assertBox(scene, "eye", new Vec3(3.6, 2.6, -0.4), new Vec3(4.4, 3.4, 0.4));
        assertBox(scene, "collection", new Vec3(5.6, 2.6, -0.4), new Vec3(6.4, 3.4, 0.4));
        assertBox(document.shot().orElseThrow().sceneAt(scene, 12), "screen", new Vec3(1.6, 7.6, -0.4), new Vec3(2.4, 8.4, 0.4));
        assertNear(scene.light("lamp").orElseThrow().position(), new Vec3(1, 3, -2), PRECISION);
        assertThat(scene.light("lamp").orElseThrow().area().width()).isEqualTo(6);
    }

    @Test
    void shearedChild_hasItsShape() throws Exception {
        Scene scene = send("sheared").scene();
        double half = 0.4 * (Math.cos(0.8) + Math.sin(0.8));
        assertBox(scene, "sheared", new Vec3(4 - half, -0.3 * half, -0.4), new Vec3(4 + half, 0.3 * half, 0.4));
    }

    @Test
    void shapeKeys_haveTheirValues() throws Exception {
        assertBox(send("keys").scene(), "shape", new Vec3(-0.4, -1, -0.4), new Vec3(0.4, 1, 0.4));
    }

    @Test
    void subdivision_hasRenderLevels() throws Exception {
        // Six faces, of which each becomes four at each level, in two triangles.
        assertThat(triangles(send("levels").scene(), "smooth")).isEqualTo(6 * 64 * 2);
    }

    @Test
    void instancesOfGeometryNodes_moveWithTheirObject() throws Exception {
        JenDocument document = send("instances");
        Scene scene = document.scene();
        assertThat(shapes(scene.stage().node("scatter").orElseThrow())).hasSize(8);
        // An icosahedron has corners above and below its center.
        assertThat(min(scene, "scatter").y()).isCloseTo(-0.6, within());
        assertThat(max(scene, "scatter").y()).isCloseTo(0.6, within());
        Scene last = document.shot().orElseThrow().sceneAt(scene, 12);
        assertThat(min(last, "scatter").y()).isCloseTo(6.4, within());
    }

    @Test
    void halfRealizedInstances_areShown() throws Exception {
        Scene scene = send("instances").scene();
        assertThat(shapes(scene.stage().node("joined").orElseThrow())).hasSize(9);
        assertThat(triangles(scene, "joined")).isEqualTo(16 * 20);
        // The script moved it from the origin to a height of 2.
        assertThat(min(scene, "joined").y()).isCloseTo(2 - 0.6, within());
        assertThat(max(scene, "joined").y()).isCloseTo(2 + 4.6, within());
    }

    @Test
    void metaball_isShownOnce() throws Exception {
        Scene scene = send("metaball").scene();
        // Its surface is where stiffness · (1 − d²)³ is the threshold; Blender finds it on a grid of 0.05.
        double radius = Math.sqrt(1 - Math.cbrt(0.6 / 2));
        assertNear(min(scene, "meta"), new Vec3(-radius, 2 - radius, -radius), 0.01);
        assertNear(max(scene, "meta"), new Vec3(radius, 2 + radius, radius), 0.01);
        assertThat(shapes(scene.stage().node("meta").orElseThrow())).hasSize(1);
    }

    @Test
    void hair_isTubes() throws Exception {
        Scene scene = send("hair").scene();
        assertThat(triangles(scene, "strands")).isEqualTo((1 + 2) * 6);
        // Tubes of three sides, as wide on average as round ones of radius 0.01.
        double corner = 0.01 * 2 * Math.PI / (6 * Math.sin(Math.PI / 3));
        assertThat(min(scene, "strands").y()).isCloseTo(0, within());
        assertThat(max(scene, "strands").y()).isCloseTo(2, within());
        assertThat(min(scene, "strands").x()).isBetween(-corner - PRECISION, -corner / 2);
        assertThat(max(scene, "strands").x()).isBetween(1 + corner / 2, 1 + corner + PRECISION);
        // The hair of a turned square starts at it, and is as long as it should be.
        assertThat(triangles(scene, "field")).isEqualTo(2 + 100 * 8 * 6);
        assertThat(min(scene, "field").z()).isCloseTo(0, within());
        assertThat(max(scene, "field").z()).isCloseTo(0.5, within());
        assertThat(max(scene, "field").y()).isBetween(0.8, 1.02);
    }

    @Test
    void moreHairThanLimit_isThinnedOutWithMessage() throws Exception {
        Scene scene = send("too_much_hair").scene();
        // Of 300,000 points, half are beyond 200,000.
        assertThat(triangles(scene, "coat")).isEqualTo(75_000 * 6);
        assertThat(messages()).anyMatch(m -> m.contains("one of 2 strands") && m.contains("coat (150000 strands)"));
    }

    @Test
    void objectsHiddenFromCamera_areNamed() throws Exception {
        Scene scene = send("camera").scene();
        assertThat(scene.stage().hasNode("seen") && scene.stage().hasNode("indirect")).isTrue();
        assertThat(scene.stage().hasNode("unseen") || scene.stage().hasNode("bounced")).isFalse();
        assertThat(messages()).anyMatch(m -> m.startsWith("hidden from the camera") && m.endsWith(": bounced, unseen"))
                .anyMatch(m -> m.contains("(shadow)") && m.endsWith(": indirect"))
                .anyMatch(m -> m.startsWith("shadow catchers") && m.endsWith(": catcher"));
    }

    @Test
    void nestedInstances_areAtTheirPlaces() throws Exception {
        Scene scene = send("lamps").scene();
        assertBox(scene, "first", new Vec3(-2.4, 1.6, -0.4), new Vec3(-1.6, 2.4, 0.4));
        assertBox(scene, "second", new Vec3(1.2, 3.2, -10.8), new Vec3(2.8, 4.8, -9.2));
    }

    @Test
    void lightsInInstances_shineAndStayOutOfBlender() throws Exception {
        Scene scene = send("lamps").scene();
        assertNear(scene.light("bulb of first").orElseThrow().position(), new Vec3(-2, 1.5, 0), PRECISION);
        assertNear(scene.light("bulb of second").orElseThrow().position(), new Vec3(2, 3, -10), PRECISION);
        // A watt is 1 / 4π² of Lightning's units.
        assertThat(scene.light("bulb of second").orElseThrow().intensity()).isCloseTo(100 / (4 * Math.PI * Math.PI), within());
        assertThat(scene.lights()).hasSize(3);
    }

    @Test
    void otherTypes_areMeshesOrNamed() throws Exception {
        Scene scene = send("types").scene();
        assertThat(min(scene, "pipe").x()).isCloseTo(-1, within());
        assertThat(max(scene, "pipe").x()).isCloseTo(1, within());
        assertThat(scene.stage().hasNode("text")).isTrue();
        assertThat(scene.stage().hasNode("wire")).isFalse();
        assertThat(messages()).contains("volumes are not sent: fog", "point clouds are not sent: dust, snow",
                "Grease Pencil is not sent: sketch");
    }

    @Test
    void otherShaders_areWhatTheyMean() throws Exception {
        Scene scene = send("shaders").scene();
        Rgb brown = new Rgb(0.5, 0.25, 0.125);
        assertSurface(scene, "metal", brown, 1, 0.25);
        assertSurface(scene, "plastic", brown, 0, 0.25);
        assertThat(material(scene, "plastic").f0()).as("((3 - 1) / (3 + 1))²").isCloseTo(0.25, within());
        assertSurface(scene, "mixed", brown, 0.25, 0.25);
        assertSurface(scene, "lacquer", brown, 1, 0.25);
        assertThat(material(scene, "lacquer").coat().weight()).isCloseTo(1, within());
        assertThat(material(scene, "lacquer").coat().roughness()).isCloseTo(0.125, within());
        assertThat(material(scene, "lacquer").coat().ior()).isCloseTo(1.75, within());
        assertThat(material(scene, "paint").albedo()).isEqualTo(brown);
        assertThat(material(scene, "paint").model()).as("without any reflection").isEqualTo(ShadingModel.PHONG);
        assertThat(material(scene, "glow").glow()).isEqualTo(new Rgb(3, 1.5, 0.75));
        assertThat(material(scene, "glow").albedo()).isEqualTo(Rgb.BLACK);
        assertThat(material(scene, "lamp").glow()).isEqualTo(Rgb.gray(2));
        assertThat(material(scene, "lamp").albedo()).isEqualTo(brown);
        assertThat(material(scene, "veil").transmission().color().r()).isCloseTo(0.25, within());
        assertThat(material(scene, "boxed").albedo()).isEqualTo(new Rgb(0.25, 0.5, 0.75));
        assertThat(material(scene, "wood").texture()).isPresent();
        assertThat(material(scene, "leaf").albedo()).isEqualTo(new Rgb(0.25, 0.5, 0.125));
        assertThat(material(scene, "velvet").albedo()).isEqualTo(brown);
        assertThat(material(scene, "velvet").sheen()).isEqualTo(new Sheen(new Rgb(1, 0.5, 0.25), 0.375));
        assertThat(material(scene, "silk").sheen()).isEqualTo(new Sheen(new Rgb(0.5, 0.25, 0.125), 0.25));
        // Widths of 1 ± 0.5 in other terms: their ratio is 1/4.
        assertThat(material(scene, "brush").anisotropy().strength()).isCloseTo(0.75 / 0.9, within());
        assertThat(material(scene, "brush").anisotropy().rotation()).isCloseTo(90, within());
        assertThat(material(scene, "steel").anisotropy()).isEqualTo(new Anisotropy(0.5, 45));
        // Half of the level of plastic, ((1.5 - 1) / (1.5 + 1))².
        assertThat(material(scene, "skin").f0()).isCloseTo(0.02, within());
    }

    private static void assertSurface(Scene scene, String name, Rgb base, double metalness, double roughness) {
        Material material = material(scene, name);
        assertThat(material.base().r()).as(name).isCloseTo(base.r(), within());
        assertThat(material.base().g()).as(name).isCloseTo(base.g(), within());
        assertThat(material.base().b()).as(name).isCloseTo(base.b(), within());
        assertThat(material.metalness()).as(name).isCloseTo(metalness, within());
        assertThat(material.roughness()).as(name).isCloseTo(roughness, within());
    }

    private static Material material(Scene scene, String name) {
        return scene.materials().stream().filter(m -> m.name().equals(name)).findFirst().orElseThrow();
    }

    @Test
    void lossesOfShaders_areNamed() throws Exception {
        send("shaders");
        assertThat(messages()).contains("displacement is not sent: rough",
                "shaders are not sent exactly: leaf (Translucent BSDF, sent as diffuse), "
                        + "skin (subsurface scattering, sent as diffuse)");
    }

    @Test
    void valuesOfNodes_areSent() throws Exception {
        Material constant = material(send("linked").scene(), "constant");
        assertThat(constant.base()).isEqualTo(new Rgb(0.25, 0.5, 0.75));
        assertThat(constant.f0()).as("((2 - 1) / (2 + 1))²").isCloseTo(1 / 9.0, within());
        assertThat(constant.coat().weight()).isCloseTo(0.25, within());
        assertThat(constant.coat().ior()).isCloseTo(1.75, within());
    }

    @Test
    void coat_hasBlendersRoughness() throws Exception {
        assertThat(material(send("linked").scene(), "lacquer").coat().roughness()).isCloseTo(0.03, within());
    }

    @Test
    void nodesThatAreNotSent_areNamed() throws Exception {
        Material noisy = material(send("linked").scene(), "noisy");
        assertThat(noisy.base()).as("the mean").isEqualTo(Rgb.gray(0.5));
        assertThat(noisy.coat().roughness()).isCloseTo(0.5, within());
        assertThat(messages()).contains("shaders are not sent exactly: noisy (Noise Texture for Coat Roughness, sent as the mean, "
                + "Noise Texture for Base Color, sent as the mean), bumpy (Bump for Normal, not sent, Bump for Coat Normal, not sent), "
                + "colored (colors of coats)");
    }

    @Test
    void motionWithoutKeys_isNamed() throws Exception {
        send("motion");
        assertThat(messages()).contains("instances that move in their group are sent as at the current frame: car",
                "objects that appear or disappear are sent as at the current frame: ghost",
                "deformation is not sent, only the shape at the current frame: growing");
    }

    @Test
    void sending_leavesBlendersFileAsItIs() throws Exception {
        Scene scene = send("untouched").scene();
        assertThat(triangles(scene, "edited")).isEqualTo(6 * 16 * 2);
        assertThat(scene.stage().hasNode("hidden")).isTrue();
    }

    private static Offset<Double> within() {
        return Offset.offset(PRECISION);
    }

    private static List<Shape> shapes(SceneNode node) {
        return switch (node) {
            case Shape shape -> List.of(shape);
            case NodeGroup group -> group.children().stream().flatMap(child -> shapes(child).stream()).toList();
        };
    }

    private static List<PlacedShape> placed(Scene scene, String name) {
        List<Shape> shapes = shapes(scene.stage().node(name).orElseThrow());
        return scene.stage().placedShapes().stream().filter(p -> shapes.contains(p.shape())).toList();
    }

    private static Mesh mesh(PlacedShape placed) {
        return ((Solid.TriangleMesh) placed.shape().solid()).mesh();
    }

    private static int triangles(Scene scene, String name) {
        return placed(scene, name).stream().mapToInt(p -> mesh(p).triangleCount()).sum();
    }

    private static List<Vec3> corners(Scene scene, String name) {
        List<Vec3> corners = new ArrayList<>();
        for (PlacedShape placed : placed(scene, name)) {
            float[] positions = mesh(placed).positions();
            for (int i = 0; i < positions.length; i += 3) {
                corners.add(placed.toWorld().transformPoint(new Vec3(positions[i], positions[i + 1], positions[i + 2])));
            }
        }
        return corners;
    }

    private static Vec3 min(Scene scene, String name) {
        return corners(scene, name).stream()
                .reduce((a, b) -> new Vec3(Math.min(a.x(), b.x()), Math.min(a.y(), b.y()), Math.min(a.z(), b.z()))).orElseThrow();
    }

    private static Vec3 max(Scene scene, String name) {
        return corners(scene, name).stream()
                .reduce((a, b) -> new Vec3(Math.max(a.x(), b.x()), Math.max(a.y(), b.y()), Math.max(a.z(), b.z()))).orElseThrow();
    }

    private static void assertBox(Scene scene, String name, Vec3 min, Vec3 max) {
        assertNear(min(scene, name), min, PRECISION);
        assertNear(max(scene, name), max, PRECISION);
    }

    private static void assertNear(Vec3 actual, Vec3 expected, double tolerance) {
        assertThat(actual.minus(expected).maxAbs()).as("%s, expected %s", actual, expected).isLessThanOrEqualTo(tolerance);
    }
}
