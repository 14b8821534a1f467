package lightning.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.data.Offset.offset;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import lightning.base.math.SrgbCurve;
import lightning.format.jen.JenReader;
import lightning.sample.PythonPrograms;
import lightning.sample.Slow;
import lightning.scene.Scene;
import lightning.scene.asset.TextureChannel;
import lightning.scene.asset.TextureMap;
import lightning.scene.asset.TexturePlacement;
import lightning.scene.material.LayerMaps;
import lightning.scene.material.Material;
import lightning.scene.node.Mesh;
import lightning.scene.node.Solid;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** Images of numbers and reflected colors in Blender. Their left pixel is 0.2, 0.4, 0.6 with an alpha of 0.8, the right one is 0. */
@Slow
@DisabledOnOs(OS.WINDOWS)
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class BlenderMapsTest {
    /** Half a code of 8 bits. */
    private static final double PRECISION = 0.5 / 255 + 1e-4;
    private Scene scene;
    private List<String> messages;

    @BeforeAll
    void send(@TempDir Path folder) throws Exception {
        PythonPrograms.require("bpy");
        assertThat(Blender.run(folder, "blender_maps.py")).contains("sent");
        scene = JenReader.read(folder.resolve("scene.jen")).scene();
        messages = Files.readAllLines(folder.resolve("messages.txt"));
    }

    private static float texel(Optional<TextureMap> map, TextureChannel channel, int x) {
        return map.orElseThrow().image().channel(x, 0, channel.ordinal());
    }

    private void assertRoughness(String name, double left, double right) {
        Material material = scene.material(name).orElseThrow();
        Optional<TextureMap> map = material.surfaceMaps().roughness();
        assertThat(material.mappedRoughness(texel(map, material.surfaceMaps().roughnessChannel(), 0))).isCloseTo(left, offset(PRECISION));
        assertThat(material.mappedRoughness(texel(map, material.surfaceMaps().roughnessChannel(), 1))).isCloseTo(right, offset(PRECISION));
    }

    private void assertMetalness(String name, double left, double right) {
        Material material = scene.material(name).orElseThrow();
        Optional<TextureMap> map = material.surfaceMaps().metalness();
        assertThat(material.mappedMetalness(texel(map, material.surfaceMaps().metalnessChannel(), 0))).isCloseTo(left, offset(PRECISION));
        assertThat(material.mappedMetalness(texel(map, material.surfaceMaps().metalnessChannel(), 1))).isCloseTo(right, offset(PRECISION));
    }

    /** Asserts a number whose map has two pixels. */
    private static void assertNumber(double factor, Optional<TextureMap> map, TextureChannel channel, double left, double right) {
        assertThat(factor * texel(map, channel, 0)).isCloseTo(left, offset(PRECISION));
        assertThat(factor * texel(map, channel, 1)).isCloseTo(right, offset(PRECISION));
    }

    @Test
    void weightAndRoughnessOfCoat_areSent() {
        Material lacquer = scene.material("lacquer").orElseThrow();
        LayerMaps maps = lacquer.layerMaps();
        assertNumber(lacquer.coat().weight(), maps.coat(), maps.coatChannel(), 0.6, 0);
        assertNumber(lacquer.coat().roughness(), maps.coatRoughness(), maps.coatRoughnessChannel(), 0.6, 1);
    }

    /** A level of 0.5 is a reflectance of 0.04 at an index of 1.5. */
    @Test
    void levelOfReflection_isSent() {
        Material level = scene.material("level").orElseThrow();
        assertNumber(level.f0(), level.surfaceMaps().f0(), level.surfaceMaps().f0Channel(), 0.08 * 0.4, 0);
        assertThat(level.f0()).isCloseTo(0.08, offset(1e-9));
    }

    @Test
    void tintOfReflection_isSent() {
        Optional<TextureMap> map = scene.material("tinted").orElseThrow().surfaceMaps().specularTint();
        assertThat(texel(map, TextureChannel.RED, 0)).isCloseTo(0.6f, offset(0.01f));
        assertThat(texel(map, TextureChannel.BLUE, 1)).isCloseTo(0.5f, offset(0.01f));
    }

    @Test
    void colorAndRoughnessOfSheen_areSent() {
        Material fibers = scene.material("fibers").orElseThrow();
        LayerMaps maps = fibers.layerMaps();
        assertNumber(fibers.sheen().color().r(), maps.sheen(), TextureChannel.RED, 0.2, 0);
        assertNumber(fibers.sheen().color().g(), maps.sheen(), TextureChannel.GREEN, 0.1, 0);
        assertNumber(fibers.sheen().roughness(), maps.sheenRoughness(), maps.sheenRoughnessChannel(), 0.6, 0);
        assertThat(messages).noneMatch(message -> message.contains("sheen"));
    }

    @Test
    void channels_areSent() {
        assertRoughness("channels", 0.2, 0);
        assertMetalness("channels", 0.6, 0);
    }

    @Test
    void color_isItsLuminance() {
        assertRoughness("direct", 0.2126 * 0.2 + 0.7152 * 0.4 + 0.0722 * 0.6, 0);
    }

    @Test
    void alpha_isSent() {
        assertRoughness("alpha", 0.8, 0);
    }

    @Test
    void srgbImage_isLinear() {
        assertRoughness("curved", SrgbCurve.toLinear(0.4), 0);
    }

    @Test
    void product_isSent() {
        assertRoughness("product", 0.2, 0);
        assertThat(scene.material("product").orElseThrow().roughness()).isEqualTo(0.5);
        assertRoughness("large", 0.8, 0);
    }

    @Test
    void inverted_isSent() {
        assertRoughness("inverted", 0.6, 1);
    }

    @Test
    void mappedRange_isSent() {
        assertMetalness("mapped", 0.25 + 0.5 * 0.6, 0.25);
    }

    @Test
    void ramp_isSent() {
        assertRoughness("ramp", 1 - 0.5 * 0.4, 1);
    }

    @Test
    void mix_isSent() {
        assertRoughness("mixed", 0.75 + 0.25 * 0.4, 0.75);
    }

    @Test
    void groups_areFollowed() {
        assertRoughness("grouped", 0.2, 0);
    }

    /** A Mapping node scales, turns and moves coordinates. */
    @Test
    void imagesOfOneMaterial_haveTheirOwnMapping() {
        Mesh mesh = scene.placedShapes().stream().filter(shape -> shape.material().name().equals("placed")).findFirst()
                .map(shape -> ((Solid.TriangleMesh) shape.shape().solid()).mesh()).orElseThrow();
        TextureMap rough = scene.material("placed").orElseThrow().surfaceMaps().roughness().orElseThrow();
        for (int i = 0; i < mesh.positions().length / 3; i++) {
            // The plane has coordinates from 0 to 1 from its left front.
            double u = (mesh.positions()[3 * i] + 1) / 2;
            double v = (1 - mesh.positions()[3 * i + 2]) / 2;
            assertPlace(scene.material("placed").orElseThrow().texture().orElseThrow(), mesh, i, 0.25 + 2 * u, 0.5 + 2 * v);
            assertPlace(rough, mesh, i, 0.125 + Math.cos(0.5) * 3 * u - Math.sin(0.5) * 1.5 * v,
                    0.75 + Math.sin(0.5) * 3 * u + Math.cos(0.5) * 1.5 * v);
        }
    }

    private static void assertPlace(TextureMap map, Mesh mesh, int vertex, double u, double v) {
        TexturePlacement placement = map.placement();
        double x = map.repeatU() * mesh.coordinates()[2 * vertex];
        double y = map.repeatV() * mesh.coordinates()[2 * vertex + 1];
        assertThat(Math.IEEEremainder(placement.cosine() * x - placement.sine() * y + placement.offsetU() - u, 1)).isCloseTo(0,
                offset(1e-5));
        assertThat(Math.IEEEremainder(placement.sine() * x + placement.cosine() * y + placement.offsetV() - v, 1)).isCloseTo(0,
                offset(1e-5));
    }

    @Test
    void otherMappingOfRoughness_isNamed() {
        assertThat(messages).anyMatch(message -> message.contains("apart (coordinates of the image of Roughness"));
    }

    @Test
    void constants_areComputed() {
        assertThat(scene.material("constant").orElseThrow().roughness()).isCloseTo(0.25, offset(1e-6));
    }

    @Test
    void mapsOfMixedShader_areSent() {
        Material cut = scene.material("cut").orElseThrow();
        assertThat(cut.roughness()).isCloseTo(0.2, offset(PRECISION));
        assertThat(cut.metalness()).isCloseTo(0.3, offset(PRECISION));
    }

    @Test
    void otherNodes_areTheirMeanWithMessage() {
        double gray = 0.2126 * 0.2 + 0.7152 * 0.4 + 0.0722 * 0.6;
        assertThat(scene.material("unknown").orElseThrow().roughness()).isCloseTo(gray / 2, offset(PRECISION));
        assertThat(scene.material("noisy").orElseThrow().roughness()).isCloseTo(0.5, offset(PRECISION));
        assertThat(messages).anyMatch(message -> message.contains("unknown (Hue/Saturation/Value for Roughness, sent as the mean)")
                && message.contains("noisy (Noise Texture for Roughness, sent as the mean)"));
    }
}
