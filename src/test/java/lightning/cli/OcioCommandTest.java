package lightning.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import lightning.sample.PythonPrograms;
import lightning.sample.Slow;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

@Slow
class OcioCommandTest {
    private static final String VIEW = "sRGB - Display/Un-tone-mapped";

    @TempDir
    private Path folder;

    @Test
    void list_hasDisplaysViewsAndDefault() {
        PythonPrograms.require("PyOpenColorIO");
        assertThat(CliResult.run("ocio", "ocio://default").assertSuccess().out()).contains("sRGB - Display", "  Un-tone-mapped",
                " (default)");
    }

    @Test
    void bake_writesTableAndPrintsError() {
        PythonPrograms.require("PyOpenColorIO");
        Path cube = folder.resolve("look.cube");
        CliResult result = CliResult.run("ocio", "ocio://default", "--bake", VIEW, "-o", cube).assertSuccess();
        assertThat(result.out()).contains("its error in steps of 8 bits is 0.", " on average");
        assertThat(cube).content().contains("# LIGHTNING_SHAPER log2:", "# Error in steps of 8 bits", "LUT_3D_SIZE 65");
    }

    @Test
    void viewAndItsTable_showTheSamePicture() throws Exception {
        PythonPrograms.require("PyOpenColorIO");
        Path scene = CliResult.scene(folder);
        Path cube = folder.resolve("look.cube");
        CliResult.run("ocio", "ocio://default", "--bake", VIEW, "-o", cube).assertSuccess();
        CliResult direct =
                CliResult.run("render", scene, "-o", folder.resolve("a.png"), "--view", "ocio://default#" + VIEW).assertSuccess();
        CliResult.run("render", scene, "-o", folder.resolve("b.png"), "--view", cube).assertSuccess();
        assertThat(folder.resolve("b.png")).hasSameBinaryContentAs(folder.resolve("a.png"));
        assertThat(direct.err()).contains("its error in steps of 8 bits is");
        CliResult.run("render", scene, "-o", folder.resolve("c.png"), "--view", "filmic+" + cube)
                .assertRejected("look.cube is made for log2:", "replaces the transform; use it without filmic+");
    }

    @Test
    void unknownView_leavesOldPicture() throws Exception {
        PythonPrograms.require("PyOpenColorIO");
        Path scene = CliResult.scene(folder);
        Path picture = Files.writeString(folder.resolve("a.png"), "old");
        CliResult.run("render", scene, "-o", picture, "--view", "ocio://default#sRGB - Display/Untone-mapped")
                .assertRejected("display 'sRGB - Display' has no view 'Untone-mapped', did you mean 'Un-tone-mapped'?");
        assertThat(picture).hasContent("old");
    }

    @Test
    void unknownView_leavesOldTable() throws Exception {
        PythonPrograms.require("PyOpenColorIO");
        Path cube = Files.writeString(folder.resolve("look.cube"), "old");
        CliResult.run("ocio", "ocio://default", "--bake", "sRGB - Display/x", "-o", cube).assertRejected("has no view 'x'");
        assertThat(cube).hasContent("old");
    }

    @Test
    void missingConfiguration_isOneSentence() {
        Assumptions.assumeTrue(System.getenv("OCIO") == null);
        CliResult.run("ocio").assertRejected("OpenColorIO: expected a configuration, found none");
    }

    @Test
    void bakeWithoutOutput_isRejected() {
        CliResult.run("ocio", "ocio://default", "--bake", VIEW).assertRejected("expected --bake DISPLAY/VIEW and -o look.cube together");
        CliResult.run("ocio", "ocio://default", "--bake", VIEW, "-o", folder.resolve("a.png")).assertRejected("a LUT is written to .cube");
    }
}
