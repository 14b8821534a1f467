package lightning.format.exchange;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import lightning.base.file.TemporaryFolder;
import lightning.base.work.Progress;
import lightning.format.exchange.assembly.ImportedScene;
import lightning.format.exchange.assembly.LightUnits;
import lightning.format.jen.JenException;
import lightning.format.jen.JenReader;
import lightning.format.mesh.MeshException;
import lightning.sample.PythonPrograms;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Files that name others outside their folder, or pipes: in no format are those read. */
@Timeout(value = 60, unit = TimeUnit.SECONDS)
class OutsideFilesTest {
    private static final String MATERIAL = """
            def Material "m" {
              token outputs:surface.connect = </m/s.outputs:surface>
              def Shader "s" {
                uniform token info:id = "UsdPreviewSurface"
                color3f inputs:diffuseColor.connect = </m/t.outputs:rgb>
                token outputs:surface
              }
              def Shader "t" {
                uniform token info:id = "UsdUVTexture"
                asset inputs:file = @%s@
                float3 outputs:rgb
              }
            }
            def Sphere "b" ( prepend apiSchemas = ["MaterialBindingAPI"] ) {
              rel material:binding = </m>
            }
            """;

    @TempDir
    private Path folder;
    private Path secret;
    private Path input;
    private Path output;

    @BeforeEach
    void write() throws IOException {
        secret = Files.createDirectory(folder.resolve("secret"));
        input = Files.createDirectory(folder.resolve("in"));
        output = Files.createDirectory(folder.resolve("out"));
        Files.copy(Path.of("textures/checker.png"), secret.resolve("a.png"));
        Files.copy(Path.of("textures/evening_sky.hdr"), secret.resolve("a.hdr"));
        Files.copy(Path.of("textures/downlight.ies"), secret.resolve("a.ies"));
        Files.writeString(secret.resolve("a.mtl"), "newmtl m\nKd 0.5 0.25 0.125\nmap_Kd a.png\n");
        Files.writeString(secret.resolve("a.usda"), "#usda 1.0\ndef Cube \"hidden\" {}\n");
        Files.writeString(secret.resolve("a.mtlx"), """
                <materialx><standard_surface name="S" type="surfaceshader"/><surfacematerial name="hidden" type="material">
                <input name="surfaceshader" type="surfaceshader" nodename="S"/></surfacematerial></materialx>
                """);
    }

    private ImportedScene imported(String name, String text) throws Exception {
        Path file = Files.writeString(input.resolve(name), text);
        return SceneImporter.read(file, output.resolve("scene.jen"), LightUnits.CANDELA, Progress.NONE);
    }

    /** Writes a scene and checks that it has nothing of the secret files. */
    private ImportedScene assertNothingIsRead(String name, String text) throws Exception {
        ImportedScene scene = imported(name, text);
        scene.write();
        try (Stream<Path> written = Files.walk(output)) {
            for (Path file : written.filter(Files::isRegularFile).toList()) {
                for (String other : List.of("a.png", "a.hdr", "a.ies")) {
                    assertThat(Files.mismatch(file, secret.resolve(other))).as("%s in %s", other, file).isNotEqualTo(-1);
                }
            }
        }
        assertThat(Files.readString(output.resolve("scene.jen"))).doesNotContain("hidden").doesNotContain("texture")
                .doesNotContain("profile ");
        return scene;
    }

    private Stream<String> outsidePaths(String name) {
        return Stream.of("../secret/" + name, secret.resolve(name).toString(), "./sub/../../secret/" + name);
    }

    @Test
    void usd_namesFilesOutside_inANote() throws Exception {
        PythonPrograms.require("pxr");
        Files.createSymbolicLink(input.resolve("link.png"), secret.resolve("a.png"));
        List<String> stages = Stream
                .of(outsidePaths("a.png").map(path -> MATERIAL.replace("%s", path)), Stream.of(MATERIAL.replace("%s", "link.png")),
                        outsidePaths("a.usda").flatMap(path -> Stream.of("def Xform \"x\" ( references = @" + path + "@</hidden> ) {}\n",
                                "def Xform \"x\" ( payload = @" + path + "@</hidden> ) {}\n")),
                        outsidePaths("a.mtlx").map(path -> "def Scope \"x\" ( references = @" + path + "@</MaterialX/Materials> ) {}\n"),
                        outsidePaths("a.hdr").map(path -> "def DomeLight \"x\" {\n asset inputs:texture:file = @" + path + "@\n}\n"),
                        outsidePaths("a.ies").map(path -> "def SphereLight \"x\" ( prepend apiSchemas = [\"ShapingAPI\"] ) {\n"
                                + " asset inputs:shaping:ies:file = @" + path + "@\n}\n"))
                .flatMap(s -> s).map(text -> "#usda 1.0\ndef Sphere \"shown\" {}\n" + text).toList();
        for (String stage : stages) {
            ImportedScene scene = assertNothingIsRead("a.usda", stage);
            assertThat(scene.notes().keySet()).as(stage).anyMatch(note -> note.startsWith("files outside the stage's folder"));
            TemporaryFolder.delete(output);
            Files.createDirectory(output);
        }
        ImportedScene scene = assertNothingIsRead("a.usda", "#usda 1.0\n( subLayers = [@../secret/a.usda@] )\ndef Sphere \"shown\" {}\n"
                .replace("( sub", "(\n sub").replace("] )", "]\n)"));
        assertThat(scene.notes().keySet()).anyMatch(note -> note.endsWith("such as ../secret/a.usda"));
    }

    @Test
    void usd_readsFilesOfNamedFolders() throws Exception {
        String python = PythonPrograms.require("pxr");
        Path file = Files.writeString(input.resolve("a.usda"), "#usda 1.0\ndef \"x\" ( references = @../secret/a.usda@</hidden> ) {}\n"
                + MATERIAL.replace("%s", secret.resolve("a.png").toString()));
        Path described = Files.createDirectory(folder.resolve("described"));
        var builder = new ProcessBuilder(python, "-B", "src/main/python/lightning_usd/reader.py", file.toString(), described.toString());
        builder.environment().put("LIGHTNING_USD_FOLDERS", "/nowhere" + System.getProperty("path.separator") + secret);
        assertThat(builder.start().waitFor()).isZero();
        assertThat(described.resolve("stage.json")).content().contains("cube")
                .contains(secret.resolve("a.png").toRealPath().toString()).doesNotContain("outside");
    }

    @Test
    @DisabledOnOs(OS.WINDOWS)
    void usd_doesNotWaitForPipes() throws Exception {
        PythonPrograms.require("pxr");
        for (String name : List.of("p.usda", "p.mtlx", "p.png")) {
            assertThat(new ProcessBuilder("mkfifo", input.resolve(name).toString()).start().waitFor()).isZero();
        }
        for (String text : List.of("(\n subLayers = [@p.usda@]\n)\n", "def Xform \"x\" ( references = @p.usda@</a> ) {}\n",
                "def Xform \"x\" ( payload = @./p.usda@</a> ) {}\n", "def Xform \"x\" ( references = @p.mtlx@</MaterialX> ) {}\n",
                MATERIAL.replace("%s", "p.png"))) {
            ImportedScene scene = imported("a.usda", "#usda 1.0\n" + text + "def Sphere \"shown\" {}\n");
            assertThat(scene.notes().keySet()).as(text).anyMatch(note -> note.startsWith("pipes, devices and folders in place of files"));
            assertThat(scene.scene().placedShapes()).isNotEmpty();
        }
    }

    @Test
    void obj_leavesFilesOutsideOut() throws Exception {
        for (String path : outsidePaths("a.mtl").toList()) {
            assertNothingIsRead("a.obj", "mtllib " + path + "\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m\nf 1 2 3\n");
            TemporaryFolder.delete(output);
            Files.createDirectory(output);
        }
        for (String path : outsidePaths("a.png").toList()) {
            Files.writeString(input.resolve("b.mtl"), "newmtl m\nKd 0.5 0.25 0.125\nmap_Kd " + path + "\n");
            assertNothingIsRead("a.obj", "mtllib b.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m\nf 1 2 3\n");
            TemporaryFolder.delete(output);
            Files.createDirectory(output);
        }
    }

    private static String gltf(String list, String path) {
        String data = "\"uri\":\"data:application/octet-stream;base64," + "AAAA".repeat(12) + "\"";
        String entry = list.equals("buffers") ? "\"buffers\":[{\"byteLength\":36,\"uri\":\"" + path + "\"}]"
                : "\"buffers\":[{\"byteLength\":36," + data + "}],\"images\":[{\"uri\":\"" + path + "\"}]";
        return "{\"asset\":{\"version\":\"2.0\"},\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0}],\"meshes\":[{\"primitives\":[{"
                + "\"attributes\":{\"POSITION\":0},\"material\":0}]}],\"materials\":[{\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":0}}}],"
                + "\"textures\":[{\"source\":0}],\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"}],"
                + "\"bufferViews\":[{\"buffer\":0,\"byteLength\":36}]," + entry + "}";
    }

    @Test
    void gltf_rejectsBuffersOutside() {
        for (String path : outsidePaths("a.png").toList()) {
            assertThatExceptionOfType(MeshException.class).isThrownBy(() -> imported("a.gltf", gltf("buffers", path)))
                    .withMessageContaining("must be data or a file in the folder of this one");
        }
    }

    @Test
    void gltf_leavesImagesOutsideOut() throws Exception {
        for (String path : outsidePaths("a.png").toList()) {
            assertThat(imported("a.gltf", gltf("images", path)).notes()).as(path).containsEntry("textures that are missing", 1);
            assertNothingIsRead("a.gltf", gltf("images", path));
            TemporaryFolder.delete(output);
            Files.createDirectory(output);
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"material m { texture \"%s\" }\nsphere s { material m }", "light l spot { gobo \"%s\" }\nsphere s { }",
        "world { environment \"%s\" }\nsphere s { }", "light l spot { profile \"%s\" }\nsphere s { }", "mesh s { file \"%s\" }"})
    void scene_lacksFilesOutside(String text) {
        for (String path : outsidePaths("a.png").toList()) {
            assertThatExceptionOfType(JenException.class)
                    .isThrownBy(
                            () -> JenReader.read(Files.writeString(input.resolve("a.jen"), "jen 1\n" + text.replace("%s", path) + "\n"))
                                    .requireAllFiles());
        }
    }
}
