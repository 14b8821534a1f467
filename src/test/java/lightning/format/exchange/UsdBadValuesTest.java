package lightning.format.exchange;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import lightning.base.work.Progress;
import lightning.format.exchange.assembly.ImportedScene;
import lightning.format.exchange.assembly.LightUnits;
import lightning.format.mesh.MeshException;
import lightning.sample.PythonPrograms;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Stages with single bad values: a note names the prim, and the rest is imported. */
class UsdBadValuesTest {
    @TempDir
    private Path folder;

    @BeforeEach
    void requireUsd() {
        PythonPrograms.require("pxr");
    }

    private ImportedScene imported(String text) throws Exception {
        return SceneImporter.read(Files.writeString(folder.resolve("a.usda"), "#usda 1.0\n" + text + "def Cube \"rest\" {}\n"),
                folder.resolve("a.jen"), LightUnits.CANDELA, Progress.NONE);
    }

    private void assertNoted(String text, String... notes) throws Exception {
        ImportedScene scene = imported(text);
        assertThat(scene.scene().stage().hasNode("rest")).as("%s: %s", text, scene.notes()).isTrue();
        assertThat(scene.notes().keySet()).as(text).containsAll(List.of(notes));
        assertThat(scene.notes().keySet().toString()).doesNotContain("Traceback").doesNotContain("Error").doesNotContain("argument");
    }

    @Test
    void valuesOfAnotherType_areNoted() throws Exception {
        assertNoted("def SphereLight \"l\" {\n string inputs:intensity = \"abc\"\n string inputs:color = \"red\"\n}\n",
                "/l: inputs:intensity: expected a number, found 'abc'", "/l: inputs:color: expected 3 finite numbers, found 'red'");
        assertNoted("def Camera \"c\" {\n string focalLength = \"x\"\n}\n", "/c: focalLength: expected a number, found 'x'");
        assertNoted("def Sphere \"s\" {\n string radius = \"a\"\n}\n", "/s: radius: expected a number, found 'a'");
        assertNoted("def Mesh \"m\" {\n string faceVertexCounts = \"a\"\n string points = \"b\"\n string faceVertexIndices = \"c\"\n}\n");
        assertNoted("def PointInstancer \"p\" {\n string protoIndices = \"a\"\n rel prototypes = </rest>\n}\n");
        assertNoted("def DomeLight \"d\" {\n string inputs:texture:file = \"a\"\n}\n");
    }

    @Test
    void numbersThatAreNone_areNoted() throws Exception {
        String matrix = "((%s,0,0,0),(0,1,0,0),(0,0,1,0),(0,0,0,1))";
        String order = " uniform token[] xformOpOrder = [\"xformOp:transform\"]\n";
        assertNoted("def Sphere \"s\" {\n matrix4d xformOp:transform = " + matrix.replace("%s", "nan") + "\n" + order + "}\n",
                "/s: its transform has infinite or missing numbers, imported without it");
        assertNoted("def Sphere \"s\" {\n matrix4d xformOp:transform.timeSamples = {\n 1: " + matrix.replace("%s", "1") + ",\n 3: "
                + matrix.replace("%s", "inf") + ",\n}\n" + order + "}\n",
                "/s: its animation has infinite or missing numbers, imported without it");
        assertNoted("def SphereLight \"l\" {\n float inputs:intensity = nan\n color3f inputs:color = (nan, 1, 1)\n}\n",
                "/l: inputs:intensity: expected a finite number, found nan",
                "/l: inputs:color: expected 3 finite numbers, found (nan, 1, 1)");
        assertNoted("def Xform \"x\" {\n matrix4d xformOp:transform = " + matrix.replace("%s", "nan") + "\n" + order
                + " def SphereLight \"l\" {}\n def Camera \"c\" {}\n}\n", "/x/l: its transform has infinite or missing numbers, left out",
                "/x/c: its transform has infinite or missing numbers, left out");
        for (String number : List.of("nan", "inf", "-inf", "1e39")) {
            assertNoted("""
                    def Material "m" {
                      token outputs:surface.connect = </m/s.outputs:surface>
                      def Shader "s" {
                        uniform token info:id = "UsdPreviewSurface"
                        color3f inputs:diffuseColor = (X, 1, 1)
                        float inputs:roughness = X
                        float inputs:ior = X
                        float inputs:opacity = X
                        token outputs:surface
                      }
                    }
                    def Sphere "b" ( prepend apiSchemas = ["MaterialBindingAPI"] ) {
                      rel material:binding = </m>
                    }
                    """.replace("X", number),
                    "/m/s: inputs:ior: expected a finite number, found " + (number.equals("1e39") ? "inf" : number));
        }
        assertNoted("def Cube \"c\" {\n double size = nan\n}\n", "/c: size: expected a finite number, found nan");
    }

    @Test
    void emptyValueOfMaterialX_isNoted() throws Exception {
        Files.writeString(folder.resolve("e.mtlx"), "<materialx version=\"1.38\"><standard_surface name=\"S\" type=\"surfaceshader\">"
                + "<input name=\"base\" type=\"float\" value=\"\"/><input name=\"base_color\" type=\"color3\" value=\"1, 0, 0\"/></standard_surface>"
                + "<surfacematerial name=\"M\" type=\"material\"><input name=\"surfaceshader\" type=\"surfaceshader\" nodename=\"S\"/></surfacematerial>"
                + "</materialx>");
        ImportedScene scene = imported("def Xform \"w\" {\n def Sphere \"b\" ( prepend apiSchemas = [\"MaterialBindingAPI\"] ) {\n"
                + " rel material:binding = </w/mx/Materials/M>\n }\n def Scope \"mx\" ( references = @e.mtlx@</MaterialX> ) {}\n}\n");
        assertThat(scene.notes().keySet()).contains("S.base of a MaterialX file: expected a value of type float, found ''");
        assertThat(scene.scene().materials()).singleElement().satisfies(m -> assertThat(m.base().g()).isLessThan(m.base().r()));
    }

    @Test
    void longChain_isCutOff() throws Exception {
        ImportedScene scene = imported("def Xform \"n\" {\n".repeat(3000) + "def Sphere \"deep\" {}\n" + "}\n".repeat(3000));
        assertThat(scene.notes().keySet()).contains("objects nested more than 500 deep");
        assertThat(scene.scene().stage().hasNode("rest")).isTrue();
    }

    @Test
    void longChainOfMaterialX_isNoted() throws Exception {
        var nodes = new StringBuilder();
        for (int i = 0; i < 3000; i++) {
            nodes.append("<multiply name=\"n").append(i).append("\" type=\"color3\"><input name=\"in1\" type=\"color3\" nodename=\"n")
                    .append(i + 1).append("\"/></multiply>");
        }
        Files.writeString(folder.resolve("e.mtlx"), "<materialx version=\"1.38\">" + nodes
                + "<standard_surface name=\"S\" type=\"surfaceshader\">"
                + "<input name=\"base_color\" type=\"color3\" nodename=\"n0\"/></standard_surface>"
                + "<surfacematerial name=\"M\" type=\"material\"><input name=\"surfaceshader\" type=\"surfaceshader\" nodename=\"S\"/></surfacematerial>"
                + "</materialx>");
        assertNoted("def Scope \"mx\" ( references = @e.mtlx@</MaterialX> ) {}\n",
                "MaterialX file e.mtlx: its nodes refer to too many others one after another, left out");
    }

    @Test
    void longChainOfInstancers_isNoted() throws Exception {
        var chain = new StringBuilder();
        for (int i = 0; i < 3000; i++) {
            chain.append("def PointInstancer \"p").append(i).append("\" {\n rel prototypes = </p").append(i + 1)
                    .append(">\n int[] protoIndices = [0]\n point3f[] positions = [(0, 0, 0)]\n}\n");
        }
        ImportedScene scene = imported(chain.append("def Sphere \"p3000\" {}\n").toString());
        assertThat(scene.notes().keySet()).anyMatch(note -> note.endsWith(": has too many others inside each other, left out"));
        assertThat(scene.scene().stage().hasNode("rest")).isTrue();
    }

    @Test
    void longChainOfReferences_isOneSentence() {
        var chain = new StringBuilder();
        for (int i = 0; i < 3000; i++) {
            chain.append("def Xform \"p").append(i).append("\" ( references = </p").append(i + 1).append("> ) {}\n");
        }
        assertThatExceptionOfType(MeshException.class).isThrownBy(() -> imported(chain.append("def Xform \"p3000\" {}\n").toString()))
                .withMessageEndingWith("has references to references, more than 500 one after another");
    }

    @Test
    void transformOfAnotherType_isLeftOut() throws Exception {
        assertNoted("def Xform \"bad\" {\nstring xformOp:translate = \"x\"\nuniform token[] xformOpOrder = [\"xformOp:translate\"]\n}\n",
                "/bad: its transform has values of another type, imported without it");
    }

    @Test
    void bytesThatAreNoText_areOneSentence() throws Exception {
        Path file = Files.write(folder.resolve("a.usda"), "#usda 1.0\ndef \u00ff\n".getBytes(StandardCharsets.ISO_8859_1));
        assertThatExceptionOfType(MeshException.class)
                .isThrownBy(() -> SceneImporter.read(file, folder.resolve("a.jen"), LightUnits.CANDELA, Progress.NONE))
                .withMessageContaining("a.usda: cannot be read by usd-core: ").withMessageContaining("a.usda:2")
                .withMessageNotContaining("Unicode");
    }

    @Test
    void fullTemporaryFolder_isOneSentence() throws Exception {
        String output = PythonPrograms.script(folder, List.of("-c", """
                import errno, pathlib, sys
                sys.path.insert(0, sys.argv[1])
                import output, reader, os
                def full(self, values):
                    raise OSError(errno.ENOSPC, "No space left on device")
                output.Output.array = full
                stage = pathlib.Path("full.usda")
                stage.write_text("#usda 1.0\\ndef Cube \\"c\\" {}\\n")
                os.mkdir("described")
                print(reader.main([str(stage.absolute()), "described"]))
                print(pathlib.Path("described/error.txt").read_text())
                """, Path.of("src/main/python/lightning_usd").toAbsolutePath().toString()));
        assertThat(output).contains("2\n").contains("needs more space than the temporary folder has");
    }
}
