package lightning.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import lightning.format.gltf.GltfFixtures;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Commands import and export-lights. */
class ImportCommandTest {
    private static final String TRIANGLE = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nl 1 2\n";
    @TempDir
    private Path folder;

    @Test
    void changedModel_replacesItsFilesIfAsked() throws Exception {
        Path model = Files.writeString(Files.createDirectory(folder.resolve("in")).resolve("a.obj"), TRIANGLE);
        Path scene = folder.resolve("a.jen");
        Path copy = folder.resolve("a.obj");
        CliResult.run("import", model, "-o", scene).assertSuccess();
        String changed = Files.readString(Files.writeString(model, TRIANGLE + "# again\n"));
        CliResult.run("import", model, "-o", scene).assertRejected(
                copy + ": already exists with other content; --replace replaces it, or import into another folder");
        assertThat(copy).hasContent(TRIANGLE);
        assertThat(CliResult.run("import", model, "-o", scene, "--replace").assertSuccess().err()).contains(copy + ": replaced");
        assertThat(copy).hasContent(changed);
        assertThat(CliResult.run("import", model, "-o", scene, "--replace").assertSuccess().err()).doesNotContain("replaced");
    }

    @Test
    void importedFile_passesCheck() throws Exception {
        CliResult done = CliResult.run("import", Files.writeString(folder.resolve("a.obj"), TRIANGLE), "-o", folder.resolve("a.jen"))
                .assertSuccess();
        assertThat(done.out()).contains("a.jen: written; 1 object, 0 materials, 1 light");
        assertThat(done.err()).contains("left out or approximated: lines (1)");
        CliResult.run("check", folder.resolve("a.jen")).assertSuccess();
    }

    @Test
    void lighting_replacesLights() throws Exception {
        Path model = Files.writeString(folder.resolve("a.obj"), TRIANGLE);
        CliResult.run("import", model, "-o", folder.resolve("a.jen"), "--lighting", "studio").assertSuccess();
        assertThat(Files.readString(folder.resolve("a.jen"))).contains("light key rect", "antialias edges", "group backdrop");
        CliResult.run("import", model, "-o", folder.resolve("a.jen"), "--lighting", "moon").assertRejected("--lighting");
    }

    /** Box from −1 to 1 around a camera at its center, whose front is left out if it is open. */
    private static String room(boolean closed) {
        String nff = """
                v
                from 0 0 0.5
                at 0 0 -1
                up 0 1 0
                angle 60
                hither 0.01
                resolution 32 32
                l 0 0.5 0
                f 1 1 1 1 0 0 0 1
                p 4\n-1 -1 -1\n1 -1 -1\n1 1 -1\n-1 1 -1
                p 4\n-1 -1 -1\n-1 -1 1\n-1 1 1\n-1 1 -1
                p 4\n1 -1 -1\n1 -1 1\n1 1 1\n1 1 -1
                p 4\n-1 -1 -1\n1 -1 -1\n1 -1 1\n-1 -1 1
                p 4\n-1 1 -1\n1 1 -1\n1 1 1\n-1 1 1
                """;
        return closed ? nff + "p 4\n-1 -1 1\n1 -1 1\n1 1 1\n-1 1 1\n" : nff;
    }

    @Test
    void indirectLight_isOn_unlessChosenOtherwise() throws Exception {
        Path closed = Files.writeString(folder.resolve("closed.nff"), room(true));
        Path open = Files.writeString(folder.resolve("open.nff"), room(false));
        Path scene = folder.resolve("a.jen");
        assertThat(CliResult.run("import", open, "-o", scene).assertSuccess().err()).doesNotContain("indirect");
        assertThat(Files.readString(scene)).contains("indirect");
        CliResult.run("import", closed, "-o", scene, "--indirect", "off").assertSuccess();
        assertThat(Files.readString(scene)).doesNotContain("indirect");
        CliResult.run("import", open, "-o", scene, "--indirect", "auto").assertSuccess();
        assertThat(Files.readString(scene)).doesNotContain("indirect");
        assertThat(CliResult.run("import", closed, "-o", scene, "--indirect", "auto").assertSuccess().err())
                .contains("the camera is in a closed room, so indirect light is on");
        assertThat(Files.readString(scene)).contains("indirect");
    }

    @Test
    void lights_areExportedIntoCopy() throws Exception {
        Path scene = CliResult.scene(folder);
        Path gltf = Files.write(folder.resolve("a.gltf"), GltfFixtures.text(GltfFixtures.SQUARE_JSON, GltfFixtures.SQUARE));
        CliResult done = CliResult.run("export-lights", scene, "--into", gltf, "-o", folder.resolve("b.gltf")).assertSuccess();
        assertThat(done.out()).contains("b.gltf: written; 3 lights");
        assertThat(done.err()).contains("not exported exactly: lights without inverse-square falloff");
        assertThat(Files.readString(folder.resolve("b.gltf"))).contains("KHR_lights_punctual", "\"lamp\"", "\"sun\"", "\"stage\"");
        CliResult.run("export-lights", scene, "--into", gltf, "-o", gltf).assertRejected("is the file to copy; choose another");
        CliResult.run("export-lights", scene, "--into", scene, "-o", folder.resolve("c.gltf")).assertRejected("a.jen: line 1, column");
        CliResult.run("export-lights", scene, "-o", folder.resolve("c.gltf")).assertRejected("the output name must end in .json");
    }

    @Test
    void lightUnits_arePicturedStoredAndExported() throws Exception {
        Path gltf = Files.write(folder.resolve("lit.gltf"), GltfFixtures.text(GltfFixtures.LIT_JSON, GltfFixtures.SQUARE));
        CliResult done = CliResult.run("import", gltf, "-o", folder.resolve("a.jen"), "--light-pictures").assertSuccess();
        assertThat(done.out()).contains("a.candela.png: written; light units taken as candela and lux", "a.unitless.png", "a.watts.png");
        assertThat(done.err()).contains("light units taken as candela and lux; --light-pictures shows each choice");
        assertThat(ImageIO.read(folder.resolve("a.watts.png").toFile())).satisfies(picture -> {
            assertThat(picture.getWidth()).isEqualTo(320);
            assertThat(picture.getHeight()).isEqualTo(240);
        });
        CliResult.run("import", gltf, "-o", folder.resolve("a.jen"), "--light-units", "watts").assertSuccess();
        CliResult back =
                CliResult.run("export-lights", folder.resolve("a.jen"), "--into", gltf, "-o", folder.resolve("b.gltf")).assertSuccess();
        assertThat(back.out()).contains("1 light, in watts");
        assertThat(Files.readString(folder.resolve("b.gltf"))).containsPattern("\"intensity\" : (100\\.0|99\\.9999999|100\\.0000000)");
    }

    @Test
    void invalidInput_isRejected() throws Exception {
        Path wrong = Files.writeString(folder.resolve("a.obj"), TRIANGLE.replace("1 2 3", "1 2 4"));
        CliResult.run("import", wrong, "-o", folder.resolve("a.jen")).assertRejected("a.obj: line 4: a corner must reference one of 3");
        CliResult.run("import", folder.resolve("b.obj"), "-o", folder.resolve("a.jen")).assertRejected("b.obj: file not found");
        CliResult.run("import", folder, "-o", folder.resolve("a.jen")).assertRejected("is a folder");
        CliResult.run("import", wrong, "-o", folder.resolve("a.png")).assertRejected("a scene's file name must end in .jen");
        CliResult.run("import", wrong, "-o", folder.resolve("a.jen"), "--light-units", "lumen").assertRejected("--light-units");
        CliResult.run("import", wrong, "-o", folder.resolve("a.jen"), "--subdivision=5")
                .assertRejected("--subdivision must be from 0 to 4, was 5");
        Path gltf = Files.write(folder.resolve("a.gltf"), GltfFixtures.text(GltfFixtures.SQUARE_JSON, GltfFixtures.SQUARE));
        CliResult.run("import", gltf, "-o", folder.resolve("a.jen"), "--variant", "night")
                .assertRejected("must have the variant 'night' of its materials, has none");
        CliResult.run("import", wrong, "-o", folder.resolve("a.jen"), "--camera", "top")
                .assertRejected("to have the camera 'top'");
        CliResult.run("import", wrong, "-o", folder.resolve("a.jen"), "--frame", "1e9")
                .assertRejected("--frame must be from -100000000 to 100000000, was 1.0E9");
        assertThat(folder.resolve("a.jen")).doesNotExist();
    }
}
