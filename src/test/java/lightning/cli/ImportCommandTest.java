package lightning.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** import, as its users see it. */
class ImportCommandTest {
    private static final String TRIANGLE = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nl 1 2\n";
    @TempDir
    private Path folder;

    @Test
    void file_becomesASceneThatCanBeChecked() throws Exception {
        Cli done = Cli.run("import", Files.writeString(folder.resolve("a.obj"), TRIANGLE), "-o", folder.resolve("a.jen")).isDone();
        assertThat(done.out()).contains("a.jen: written; 1 shapes, 0 materials, 1 lights");
        assertThat(done.err()).contains("left out or not the same: lines (1)");
        Cli.run("check", folder.resolve("a.jen")).isDone();
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
