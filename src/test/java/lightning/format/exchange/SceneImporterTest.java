package lightning.format.exchange;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.CancellationException;
import javax.imageio.ImageIO;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.base.work.Await;
import lightning.base.work.Progress;
import lightning.format.exchange.assembly.ImportedScene;
import lightning.format.exchange.assembly.LightUnits;
import lightning.format.gltf.GltfFixtures;
import lightning.format.jen.JenException;
import lightning.format.jen.JenReader;
import lightning.format.mesh.MeshException;
import lightning.scene.PlacedShape;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.material.BumpMapping;
import lightning.scene.material.Coat;
import lightning.scene.material.Material;
import lightning.scene.material.ShadingModel;
import lightning.scene.material.SurfaceMaps;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Import of other programs' files to scenes that can be read and rendered. */
class SceneImporterTest {
    private static final String SCENE = GltfFixtures.SQUARE_JSON.replace("'nodes': [{'mesh': 0, 'name': 'floor'}]", """
            'nodes': [{'name': 'set', 'translation': [0, 0, 5], 'scale': [2, 2, 2], 'children': [1, 2, 3, 4]},
              {'mesh': 0, 'name': 'floor', 'rotation': [-0.70710678, 0, 0, 0.70710678]}, {'mesh': 0, 'name': 'floor'},
              {'name': 'bulb', 'translation': [0, 1, 0], 'extensions': {'KHR_lights_punctual': {'light': 0}}},
              {'name': 'eye', 'camera': 0, 'translation': [0, 0, 4]}],
             'extensions': {'KHR_lights_punctual': {'lights': [{'type': 'point', 'intensity': 683, 'range': 3}]}},
             'cameras': [{'perspective': {'yfov': 1}}], 'skins': [{}],
             'materials': [{'name': 'red', 'pbrMetallicRoughness': {'baseColorFactor': [1, 0, 0, 1], 'metallicFactor': 0}}]""")
            .replace("'indices': 3", "'indices': 3, 'material': 0");
    /** PNG of a pixel with the values 128, 192, 255, in Base64. */
    private static final String PIXEL =
            "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAIAAACQd1PeAAAADElEQVR4nGNoOPAfAAQDAkBvhCYaAAAAAElFTkSuQmCC";

    @TempDir
    private Path folder;
    private Path from;
    private Path to;

    @BeforeEach
    void makeFolders() throws IOException {
        from = Files.createDirectory(folder.resolve("from"));
        to = Files.createDirectory(folder.resolve("to")).resolve("a.jen");
    }

    /** Chunks of extensions may stand before and after that of the buffers; readers skip them (glTF 2.0, 4.4.3). */
    @Test
    void unknownChunks_areSkipped() throws Exception {
        byte[] plain = GltfFixtures.binary(SCENE, GltfFixtures.SQUARE);
        int binary = plain.length - GltfFixtures.SQUARE.length - 8;
        ByteBuffer chunk = ByteBuffer.allocate(16).order(ByteOrder.LITTLE_ENDIAN).putInt(8).putInt(0x544D4853).putLong(-1);
        var more = new ByteArrayOutputStream();
        more.write(plain, 0, binary);
        more.writeBytes(chunk.array());
        more.write(plain, binary, plain.length - binary);
        more.writeBytes(chunk.array());
        String expected = read(Files.write(from.resolve("a.glb"), plain)).text();
        assertThat(read(Files.write(from.resolve("a.glb"), more.toByteArray())).text()).isEqualTo(expected).contains("mesh");
    }

    @Test
    void nodes_haveTheTransformsOfTheFile() throws Exception {
        Scene scene = imported(Files.write(from.resolve("a.glb"), GltfFixtures.binary(SCENE, GltfFixtures.SQUARE)));
        assertThat(scene.placedShapes()).extracting(s -> s.shape().name()).containsExactly("floor", "floor 2");
        PlacedShape lying = scene.placedShapes().getFirst();
        assertNear(lying.toWorld().transformPoint(new Vec3(1, 1, 0)), new Vec3(2, 0, 3));
        assertThat(lying.material().base()).isEqualTo(new Rgb(1, 0, 0));
    }

    @Test
    void shearedNode_becomesTwoGroups() throws Exception {
        String sheared = SCENE.replace("'rotation': [-0.70710678, 0, 0, 0.70710678]", "'matrix': [1,0,0,0, 0.5,1,0,0, 0,0,-2,0, 0,3,0,1]");
        ImportedScene imported = read(Files.write(from.resolve("a.glb"), GltfFixtures.binary(sheared, GltfFixtures.SQUARE)));
        PlacedShape shape = imported.scene().placedShapes().getFirst();
        assertNear(shape.toWorld().transformPoint(new Vec3(1, 1, 1)), new Vec3(3, 8, 1));
        assertThat(imported.notes().keySet()).noneMatch(note -> note.contains("nodes"));
    }

    @Test
    void cameraAndLight_matchTheFile() throws Exception {
        Scene scene = imported(Files.write(from.resolve("a.glb"), GltfFixtures.binary(SCENE, GltfFixtures.SQUARE)));
        assertNear(scene.camera().from(), new Vec3(0, 0, 13));
        // A new light takes its size from this distance.
        assertThat(scene.camera().to().minus(scene.camera().from()).length()).as("distance of the objects").isGreaterThan(5);
        assertThat(scene.camera().fov()).isCloseTo(Math.toDegrees(1), Offset.offset(1e-9));
        Light bulb = scene.light("bulb").orElseThrow();
        assertThat(bulb.type()).isEqualTo(LightType.POINT);
        assertNear(bulb.position(), new Vec3(0, 2, 5));
        // 683 candela are a watt per steradian, which gives white at distance 1 the value 1 / π.
        assertThat(bulb.intensity() / bulb.attenuation().quadratic()).isCloseTo(1 / Math.PI, Offset.offset(1e-12));
    }

    @Test
    void skippedFeatures_areNotedAndCounted() throws Exception {
        ImportedScene imported = read(Files.write(from.resolve("a.glb"), GltfFixtures.binary(SCENE, GltfFixtures.SQUARE)));
        assertThat(imported.notes()).containsEntry("ranges of lights", 1);
        assertThat(imported.text())
                .startsWith("jen 1\n# imported from a.glb\n# light units: the file's numbers were taken as candela and lux\n");
    }

    @Test
    void samplers_sayWhatFollowsTheEdges() throws Exception {
        String clamped =
                SCENE.replace("'metallicFactor': 0}", "'metallicFactor': 0, 'baseColorTexture': {'index': 0}}").replace("'cameras':",
                        "'textures': [{'sampler': 0, 'source': 0}], 'samplers': [{'wrapS': 33071, 'wrapT': 33648, 'magFilter': 9728}], "
                                + "'images': [{'uri': 'data:image/png;base64," + PIXEL + "'}], 'cameras':");
        ImportedScene imported = read(Files.write(from.resolve("a.glb"), GltfFixtures.binary(clamped, GltfFixtures.SQUARE)));
        assertThat(imported.text()).contains(" wrap clamp_mirror");
        assertThat(imported.notes()).containsEntry("unfiltered textures, imported as filtered", 1);
    }

    @Test
    void normalMap_hasItsScale() throws Exception {
        String mapped =
                SCENE.replace("'materials': [{", "'materials': [{'normalTexture': {'index': 0, 'scale': 0.5}, ").replace("'cameras':",
                        "'textures': [{'source': 0}], 'images': [{'uri': 'data:image/png;base64," + PIXEL + "'}], 'cameras':");
        BumpMapping relief = imported(Files.write(from.resolve("a.glb"), GltfFixtures.binary(mapped, GltfFixtures.SQUARE))).materials()
                .getFirst().bumpMapping();
        assertThat(relief.strength()).isEqualTo(0.5);
        assertThat(relief.normalMap().orElseThrow().image().channel(0, 0, 1)).as("a number, no color of sRGB").isEqualTo(192 / 255f);
    }

    @Test
    void cameraExtras_areNoted() throws Exception {
        String rich = SCENE.replace("{'yfov': 1}", "{'yfov': 1, 'aspectRatio': 1.5, 'znear': 0.1, 'zfar': 100}");
        assertThat(read(Files.write(from.resolve("a.glb"), GltfFixtures.binary(rich, GltfFixtures.SQUARE))).notes())
                .containsEntry("clipping distances of cameras (znear)", 1).containsEntry("clipping distances of cameras (zfar)", 1);
    }

    @ParameterizedTest
    @CsvSource({"1.5, 800, 533", "1, 800, 800", "0.5, 400, 800", "1e9, 800, 1", "1e-9, 1, 800"})
    void cameraAspectRatio_setsTheImageSize(String ratio, int width, int height) throws Exception {
        String shaped = SCENE.replace("{'yfov': 1}", "{'yfov': 1, 'aspectRatio': " + ratio + "}");
        ImportedScene imported = read(Files.write(from.resolve("a.glb"), GltfFixtures.binary(shaped, GltfFixtures.SQUARE)));
        assertThat(imported.scene().picture().width()).isEqualTo(width);
        assertThat(imported.scene().picture().height()).isEqualTo(height);
        assertThat(imported.scene().camera().fov()).as("vertical in both").isCloseTo(Math.toDegrees(1), Offset.offset(1e-9));
        assertThat(imported.notes()).doesNotContainKey("aspect ratios of cameras");
    }

    @Test
    void orthographicCamera_setsTheImageSize() throws Exception {
        String parallel = SCENE.replace("{'perspective': {'yfov': 1}}", "{'orthographic': {'xmag': 1, 'ymag': 2, 'znear': 0, 'zfar': 9}}");
        ImportedScene imported = read(Files.write(from.resolve("a.glb"), GltfFixtures.binary(parallel, GltfFixtures.SQUARE)));
        assertThat(imported.scene().picture().width()).isEqualTo(400);
        assertThat(imported.scene().picture().height()).isEqualTo(800);
    }

    @Test
    void invalidAspectRatio_isRejected() throws IOException {
        Path file = Files.write(from.resolve("a.glb"),
                GltfFixtures.binary(SCENE.replace("{'yfov': 1}", "{'yfov': 1, 'aspectRatio': 0}"), GltfFixtures.SQUARE));
        assertThatExceptionOfType(MeshException.class).isThrownBy(() -> read(file))
                .withMessageEndingWith("cameras[0].perspective.aspectRatio: must be above 0, was 0");
    }

    /** For any camera position and orientation, the default light comes from above its right side. */
    @ParameterizedTest
    @CsvSource({"0, 0, 4, 0, 0, 0, 1", "0, 0, -4, 0, 1, 0, 0", "4, 0, 0, 0, 0.70710678, 0, 0.70710678",
        "0, 4, 0, -0.70710678, 0, 0, 0.70710678",
        "0, 0, 4, 0, 0, 1, 0"})
    void defaultLight_isOnTheCameraSide(double x, double y, double z, double qx, double qy, double qz, double qw) throws Exception {
        String unlit = GltfFixtures.SQUARE_JSON.replace("'nodes': [{'mesh': 0, 'name': 'floor'}]",
                "'nodes': [{'mesh': 0, 'name': 'floor', 'children': [1]}, {'camera': 0, 'translation': [" + x + "," + y + "," + z
                        + "], 'rotation': [" + qx + "," + qy + "," + qz + "," + qw + "]}], 'cameras': [{'perspective': {'yfov': 1}}]");
        assertLitFromTheCamera(imported(Files.write(from.resolve("a.glb"), GltfFixtures.binary(unlit, GltfFixtures.SQUARE))));
    }

    @Test
    void defaultLightOfDefaultCamera_isOnItsSide() throws Exception {
        assertLitFromTheCamera(imported(Files.writeString(from.resolve("b.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")));
    }

    private static void assertLitFromTheCamera(Scene scene) {
        Vec3 lightDirection = scene.lights().getFirst().direction().normalized();
        Vec3 view = scene.camera().to().minus(scene.camera().from()).normalized();
        Vec3 right = view.cross(scene.camera().up()).normalized();
        assertThat(lightDirection.dot(view)).as("along the view").isGreaterThan(0.6);
        assertThat(lightDirection.dot(right.cross(view))).as("from above").isLessThan(-0.3);
        assertThat(Math.abs(lightDirection.dot(right))).as("from one side").isGreaterThan(0.25);
    }

    @Test
    void assets_areCopiedWithoutOverwriting() throws Exception {
        Path file = Files.write(from.resolve("a.gltf"), new String(GltfFixtures.text(SCENE, new byte[0]), StandardCharsets.UTF_8).replace(
                "data:application/octet-stream;base64,", "my%20data.bin").getBytes(StandardCharsets.UTF_8));
        Files.write(from.resolve("my data.bin"), GltfFixtures.SQUARE);
        imported(file);
        assertThat(to.resolveSibling("my data.bin")).hasSameBinaryContentAs(from.resolve("my data.bin"));
        Files.write(to.resolveSibling("a.gltf"), new byte[1]);
        assertThatExceptionOfType(IOException.class).isThrownBy(() -> read(file).write())
                .withMessageContaining("a.gltf: already exists with other content");
        assertThat(to.resolveSibling("a.gltf")).hasSize(1);
    }

    @Test
    void objWithMaterials_isImported() throws Exception {
        Files.writeString(from.resolve("b.mtl"), "newmtl red\nKd 1 0 0\nKs 0.5 0.5 0.5\nNs 20\nillum 3\n");
        Scene scene = imported(Files.writeString(from.resolve("b.obj"),
                "mtllib b.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\no one\nusemtl red\nf 1 2 3\no two\nf 1 3 2\nusemtl blue\nf 1 2 3\n"));
        assertThat(scene.placedShapes()).extracting(s -> s.shape().name()).containsExactly("one", "two (red)", "two (blue)");
        assertThat(scene.placedShapes().getFirst().material().reflective()).isEqualTo(Rgb.gray(0.5));
        assertThat(scene.lights()).as("one is made up").hasSize(1);
    }

    /** MTL files of MeshLab, for the diffuse model and the highlight model. */
    @ParameterizedTest
    @ValueSource(ints = {1, 2})
    void zeroExponent_addsNoHighlight(int illumination) throws Exception {
        Material material = objMaterial("Kd 0.5 0.2 0.1\nKs 1 1 1\nNs 0\nillum " + illumination + "\n").material();
        assertThat(material.specular()).isEqualTo(Rgb.BLACK);
        assertThat(material.diffuse()).isEqualTo(new Rgb(0.5, 0.2, 0.1));
    }

    @Test
    void diffuseModel_hasNoHighlight() throws Exception {
        assertThat(objMaterial("Ks 1 1 1\nNs 50\nillum 1\n").material().specular()).isEqualTo(Rgb.BLACK);
        assertThat(objMaterial("Ks 1 1 1\nNs 50\nillum 2\n").material().specular()).isEqualTo(Rgb.WHITE);
    }

    @Test
    void highlightWithoutExponent_hasTheDefault() throws Exception {
        Material material = objMaterial("Ks 1 1 1\n").material();
        assertThat(material.specular()).isEqualTo(Rgb.WHITE);
        assertThat(material.shininess()).isEqualTo(Material.DEFAULT.shininess());
    }

    @Test
    void mirrorWithoutHighlight_isReflective() throws Exception {
        Material material = objMaterial("Ks 0.5 0.5 0.5\nNs 0\nillum 3\n").material();
        assertThat(material.specular()).isEqualTo(Rgb.BLACK);
        assertThat(material.reflective()).isEqualTo(Rgb.gray(0.5));
    }

    @Test
    void physicalStatements_makePrincipledMaterial() throws Exception {
        Material material = objMaterial("Kd 0.5 0.2 0.1\nPr 0.25\nPm 0.75\nPc 0.5\nPcr 0.125\nNi 3\n").material();
        assertThat(material).isEqualTo(Material.of(material.name()).withModel(ShadingModel.PRINCIPLED).withBase(new Rgb(0.5, 0.2, 0.1))
                .withRoughness(0.25).withMetalness(0.75).withF0(0.25).withCoat(new Coat(0.5, 0.125, 1.5)));
    }

    /** A packed image has the roughness in green and the metalness in blue. */
    @Test
    void packedImage_isRoughnessMapAndMetalnessMap() throws Exception {
        var image = new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB);
        image.setRGB(0, 0, 0x336699);
        ImageIO.write(image, "png", to.resolveSibling("orm.png").toFile());
        Material material = objMaterial("Pr 0.5\nPm 0\nmap_Pr -s 2 3 orm.png\nmap_Pm orm.png\n").material();
        assertThat(material.model()).isEqualTo(ShadingModel.PRINCIPLED);
        assertThat(material.roughness()).isEqualTo(0.5);
        assertThat(material.metalness()).as("a factor of 0 would hide the image").isEqualTo(1);
        assertThat(material.surfaceMaps().meanRoughness()).isEqualTo(0x66 / 255f);
        assertThat(material.surfaceMaps().meanMetalness()).isEqualTo(0x99 / 255f);
        assertThat(material.surfaceMaps().roughness().orElseThrow().repeatV()).isEqualTo(3);
    }

    @Test
    void imagesOfCoat_areMaps() throws Exception {
        var image = new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB);
        image.setRGB(0, 0, 0x336699);
        ImageIO.write(image, "png", to.resolveSibling("coat.png").toFile());
        Material material = objMaterial("Pr 0.5\nPc 0.5\nmap_Pc coat.png\nmap_Pcr coat.png\n").material();
        assertThat(material.coat()).as("a roughness of 0 would hide the image").isEqualTo(new Coat(0.5, 1, 1.5));
        assertThat(material.layerMaps().coat().orElseThrow().image().channel(0, 0, material.layerMaps().coatChannel().ordinal()))
                .isEqualTo(0x33 / 255f);
        assertThat(material.layerMaps().coatRoughness()).isPresent();
    }

    @Test
    void missingRoughnessMap_leavesItsFactor() throws Exception {
        Material material = objMaterial("Pr 0.25\nmap_Pr none.png\nmap_Pm none.png\n").material();
        assertThat(material.roughness()).isEqualTo(0.25);
        assertThat(material.metalness()).isZero();
        assertThat(material.surfaceMaps()).isEqualTo(SurfaceMaps.NONE);
    }

    @Test
    void mapsOfGlass_areNoted() throws Exception {
        Files.write(from.resolve("t.png"), Files.readAllBytes(Path.of("textures/checker.png")));
        Files.writeString(from.resolve("g.mtl"), "newmtl a\nd 0.5\nmap_Pr t.png\n");
        Path file = Files.writeString(from.resolve("g.obj"), "mtllib g.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n");
        assertThat(SceneImporter.read(file, to, LightUnits.CANDELA, Progress.NONE).notes()).containsEntry("map_Pr of transparent materials",
                1);
    }

    @Test
    void constantModel_ignoresLights() throws Exception {
        Material material = objMaterial("Kd 0.5 0.2 0.1\nKe 0 0 1\nKs 1 1 1\nNs 50\nillum 0\n").material();
        assertThat(material.ambient()).isEqualTo(new Rgb(0.5, 0.2, 0.1));
        assertThat(material.glow()).isEqualTo(new Rgb(0, 0, 1));
        assertThat(material.diffuse()).isEqualTo(Rgb.BLACK);
        assertThat(material.specular()).isEqualTo(Rgb.BLACK);
    }

    @ParameterizedTest
    @CsvSource({"Ke 0 3 1, 0, 3, 1", "Ke 0 0 0, 1, 1, 1"})
    void emissionImage_becomesGlowMap(String emission, double r, double g, double b) throws Exception {
        ImageIO.write(new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB), "png", to.resolveSibling("lamps.png").toFile());
        Material material = objMaterial(emission + "\nmap_Ke lamps.png\n").material();
        assertThat(material.glow()).isEqualTo(new Rgb(r, g, b));
        assertThat(material.glowMap().orElseThrow().file()).isEqualTo("lamps.png");
        assertThat(objMaterial("Ke 1 1 1\nmap_Ke missing.png\n").material().glow()).isEqualTo(Rgb.BLACK);
    }

    @Test
    void emission_becomesGlow() throws Exception {
        Material material = objMaterial("Kd 0.5 0.2 0.1\nKe 0 3 1\n").material();
        assertThat(material.glow()).isEqualTo(new Rgb(0, 3, 1));
        assertThat(material.ambient()).isEqualTo(Rgb.BLACK);
        assertThat(material.diffuse()).isEqualTo(new Rgb(0.5, 0.2, 0.1));
    }

    @ParameterizedTest
    @ValueSource(strings = {"UTF-16LE", "UTF-16BE", "UTF-8"})
    void textWithByteOrderMark_isRead(String charset) throws Exception {
        Files.write(from.resolve("ä.mtl"), "\uFEFFnewmtl ä\nKd 0.5 0.25 0\n".getBytes(charset));
        Path file = Files.write(from.resolve("a.obj"),
                "\uFEFFmtllib ä.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl ä\nf 1 2 3\n".getBytes(charset));
        assertThat(imported(file).materials().getFirst().diffuse()).isEqualTo(new Rgb(0.5, 0.25, 0));
    }

    @Test
    void defaultCamera_hasRoundedNumbers() throws Exception {
        Scene scene = imported(Files.writeString(from.resolve("b.obj"), "v 0 0 0\nv 1000.123456 0 0\nv 0 1 0\nf 1 2 3\n"));
        assertThat(scene.camera().to()).isEqualTo(new Vec3(500, 0, 0));
    }

    @Test
    void fileNextToScene_isNotCopied() throws Exception {
        Path file = Files.writeString(to.resolveSibling("c.ply"), """
                ply
                format ascii 1.0
                element vertex 3
                property float x
                property float y
                property float z
                element face 1
                property list uchar int vertex_indices
                end_header
                0 0 0 1 0 0 0 1 0 3 0 1 2
                """);
        assertThat(imported(file).placedShapes()).hasSize(1);
        try (var files = Files.list(to.getParent())) {
            assertThat(files).hasSize(2);
        }
    }

    @Test
    void cyclicNode_isRejected() throws IOException {
        Path file = Files.write(from.resolve("a.glb"),
                GltfFixtures.binary(SCENE.replace("'children': [1, 2, 3, 4]", "'children': [1, 0]"), GltfFixtures.SQUARE));
        assertThatExceptionOfType(MeshException.class).isThrownBy(() -> read(file))
                .withMessageEndingWith("nodes[0].children[1]: must be a node with a single parent, was 0");
    }

    /** Writes a scene with a texture of the given file name. */
    private Path withTexture(String uri) throws IOException {
        return Files.write(from.resolve("a.glb"), GltfFixtures.binary(SCENE.replace("'metallicFactor': 0}",
                "'metallicFactor': 0, 'baseColorTexture': {'index': 0}}").replace("'cameras':",
                        "'textures': [{'source': 0}], 'images': [{'uri': '" + uri + "'}], 'cameras':"),
                GltfFixtures.SQUARE));
    }

    @Test
    @Timeout(Await.TIMEOUT_SECONDS)
    @DisabledOnOs(OS.WINDOWS)
    void textureThatIsAPipe_isLeftOutImmediately() throws Exception {
        assertThat(new ProcessBuilder("mkfifo", from.resolve("pipe.png").toString()).start().waitFor()).isZero();
        assertThat(read(withTexture("pipe.png")).notes()).containsEntry("textures that are missing", 1);
    }

    @Test
    void textureThatIsAFolder_isLeftOut() throws Exception {
        assertThat(read(withTexture(".")).notes()).containsEntry("textures that are missing", 1);
    }

    @Test
    @Timeout(Await.TIMEOUT_SECONDS)
    @DisabledOnOs(OS.WINDOWS)
    void pipeAtTargetPath_isRejectedImmediately() throws Exception {
        Path file = Files.write(from.resolve("a.glb"), GltfFixtures.binary(SCENE, GltfFixtures.SQUARE));
        assertThat(new ProcessBuilder("mkfifo", to.resolveSibling("a.glb").toString()).start().waitFor()).isZero();
        assertThatExceptionOfType(IOException.class).isThrownBy(() -> read(file).write())
                .withMessageEndingWith("a.glb: is a pipe or a device, expected a file to copy next to the scene");
    }

    @Test
    void cancelledImport_writesNothing() throws IOException {
        Path file = Files.write(from.resolve("a.glb"), GltfFixtures.binary(SCENE, GltfFixtures.SQUARE));
        Progress stop = new Progress() {
            @Override
            public void report(int done, int total) {}

            @Override
            public boolean isCanceled() {
                return true;
            }
        };
        assertThatExceptionOfType(CancellationException.class).isThrownBy(() -> SceneImporter.read(file, to, LightUnits.CANDELA, stop));
        assertThat(to.getParent()).isEmptyDirectory();
    }

    private PlacedShape objMaterial(String lines) throws Exception {
        Files.writeString(to.resolveSibling("m.mtl"), "newmtl a\n" + lines);
        return imported(Files.writeString(to.resolveSibling("m.obj"), "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n"))
                .placedShapes().getFirst();
    }

    private static void assertNear(Vec3 actual, Vec3 expected) {
        assertThat(actual.minus(expected).maxAbs()).as("%s, expected %s", actual, expected).isLessThan(1e-6);
    }

    @Test
    void hugeOffsetOfATexture_isLeftOutWithANote() throws Exception {
        Files.write(folder.resolve("t.png"), Files.readAllBytes(Path.of("textures/checker.png")));
        Files.writeString(folder.resolve("a.mtl"), "newmtl red\nmap_Kd -o 1e9 0 0 t.png\n");
        ImportedScene scene = read(Files.writeString(folder.resolve("a.obj"),
                "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nusemtl red\nf 1/1 2/1 3/1\n"));
        assertThat(scene.notes()).containsEntry("offsets (-o) of textures that are too large, left out", 1);
    }

    private ImportedScene read(Path file) throws IOException, MeshException {
        return SceneImporter.read(file, to, LightUnits.CANDELA, Progress.NONE);
    }

    private Scene imported(Path file) throws IOException, MeshException, JenException {
        read(file).write();
        return JenReader.read(to).scene();
    }
}
