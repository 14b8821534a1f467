package lightning.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import lightning.format.gltf.Gltf;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** import and export-lights, as their users see them. */
class ImportCommandTest {
    private static final String TRIANGLE = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nl 1 2\n";
    @TempDir
    private Path folder;

    @Test
    void file_becomesASceneThatCanBeChecked() throws Exception {
        Cli done = Cli.run("import", Files.writeString(folder.resolve("a.obj"), TRIANGLE), "-o", folder.resolve("a.jen")).isDone();
        assertThat(done.out()).contains("a.jen: written; 1 shape, 0 materials, 1 light");
        assertThat(done.err()).contains("left out or not the same: lines (1)");
        Cli.run("check", folder.resolve("a.jen")).isDone();
    }

    @Test
    void lights_areTakenBackIntoACopy() throws Exception {
        Path scene = Cli.scene(folder);
        Path gltf = Files.write(folder.resolve("a.gltf"), Gltf.text(Gltf.SQUARE_JSON, Gltf.SQUARE));
        Cli done = Cli.run("export-lights", scene, "--into", gltf, "-o", folder.resolve("b.gltf")).isDone();
        assertThat(done.out()).contains("b.gltf: written; 3 lights");
        assertThat(done.err()).contains("not the same there: lights that do not fall off with the square of the distance");
        assertThat(Files.readString(folder.resolve("b.gltf"))).contains("KHR_lights_punctual", "\"lamp\"", "\"sun\"", "\"stage\"");
        Cli.run("export-lights", scene, "--into", gltf, "-o", gltf).isRefusedSaying("is the file to copy, which stays as it is");
        Cli.run("export-lights", scene, "--into", scene, "-o", folder.resolve("c.gltf")).isRefusedSaying("a.jen: line 1, column");
        Cli.run("export-lights", scene, "-o", folder.resolve("c.gltf")).isRefusedSaying("the file's name must end in .json");
    }

    @Test
    void lightUnits_areShownInPictures_keptAndTakenBack() throws Exception {
        Path gltf = Files.write(folder.resolve("lit.gltf"), Gltf.text(Gltf.LIT_JSON, Gltf.SQUARE));
        Cli done = Cli.run("import", gltf, "-o", folder.resolve("a.jen"), "--light-pictures").isDone();
        assertThat(done.out()).contains("a.candela.png: written; numbers taken as candela and lux", "a.unitless.png", "a.watts.png");
        assertThat(done.err()).contains("the numbers of its lights were taken as candela and lux; --light-pictures shows each choice");
        assertThat(ImageIO.read(folder.resolve("a.watts.png").toFile())).satisfies(picture -> {
            assertThat(picture.getWidth()).isEqualTo(320);
            assertThat(picture.getHeight()).isEqualTo(240);
        });
        Cli.run("import", gltf, "-o", folder.resolve("a.jen"), "--light-units", "watts").isDone();
        Cli back = Cli.run("export-lights", folder.resolve("a.jen"), "--into", gltf, "-o", folder.resolve("b.gltf")).isDone();
        assertThat(back.out()).contains("1 light, in watts");
        assertThat(Files.readString(folder.resolve("b.gltf"))).containsPattern("\"intensity\" : (100\\.0|99\\.9999999|100\\.0000000)");
    }

    @Test
    void badInput_isRefused() throws Exception {
        Path wrong = Files.writeString(folder.resolve("a.obj"), TRIANGLE.replace("1 2 3", "1 2 4"));
        Cli.run("import", wrong, "-o", folder.resolve("a.jen")).isRefusedSaying("a.obj: line 4: a corner must name one of 3 vertices");
        Cli.run("import", folder.resolve("b.obj"), "-o", folder.resolve("a.jen")).isRefusedSaying("b.obj: there is no such file");
        Cli.run("import", folder, "-o", folder.resolve("a.jen")).isRefusedSaying("is a folder");
        Cli.run("import", wrong, "-o", folder.resolve("a.png")).isRefusedSaying("a scene's name must end in .jen");
        Cli.run("import", wrong, "-o", folder.resolve("a.jen"), "--light-units", "lumen").isRefusedSaying("--light-units");
        assertThat(folder.resolve("a.jen")).doesNotExist();
    }
}
