package lightning.format.exchange;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import lightning.base.work.Progress;
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
                "/l: inputs:intensity: expected a number, found 'abc'", "/l: inputs:color: expected 3 numbers, found 'red'");
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
                "/l: inputs:intensity: expected a number, found none", "/l: inputs:color: expected 3 numbers, found (nan, 1, 1)");
        assertNoted("def Cube \"c\" {\n double size = nan\n}\n", "/c: size: expected a number, found none");
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
    void fullTemporaryFolder_isOneSentence() throws Exception {
        String output = PythonPrograms.output(folder, List.of("-c", """
                import errno, pathlib, sys
                sys.path.insert(0, sys.argv[1])
                import output, reader, os
                def full(self, values):
                    raise OSError(errno.ENOSPC, "No space left on device")
                output.Output.array = full
                stage = pathlib.Path("full.usda")
                stage.write_text("#usda 1.0\\ndef Cube \\"c\\" {}\\n")
                os.mkdir("described")
                print(reader.main(os.getppid(), str(stage.absolute()), "described", 0))
                print(pathlib.Path("described/error.txt").read_text())
                """, Path.of("src/main/python/lightning_usd").toAbsolutePath().toString()));
        assertThat(output).contains("2\n").contains("needs more space than the temporary folder has");
    }
}
