package lightning.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Commands whose output would replace a file that they read. */
class InputFilesTest {
    private static final String MESSAGE = "is read by this command and would be replaced";

    @TempDir
    Path folder;
    private Path scene;

    @BeforeEach
    void write() throws Exception {
        scene = folder.resolve("in.jen");
        Files.copy(Path.of("textures/checker.png"), folder.resolve("tex.png"));
        Files.copy(Path.of("textures/checker.png"), folder.resolve("gobo.png"));
        Files.copy(Path.of("textures/evening_sky.hdr"), folder.resolve("sky.hdr"));
        Files.writeString(folder.resolve("part.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        Files.writeString(folder.resolve("look.cube"), "LUT_3D_SIZE 2\n" + "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 0 1\n1 0 1\n0 1 1\n1 1 1\n");
        Files.writeString(scene, "jen 1\npicture { size 8 6 }\nworld { environment \"sky.hdr\" }\nmaterial m { texture \"tex.png\" }\n"
                + "sphere s { material m }\nmesh p { file \"part.obj\" }\nlight k spot { at 0 3 3 gobo \"gobo.png\" }\n"
                + "shot { frames 0 1 rate 24 }\n");
    }

    private TreeMap<String, List<Byte>> contents() throws Exception {
        var contents = new TreeMap<String, List<Byte>>();
        try (Stream<Path> files = Files.list(folder)) {
            for (Path file : files.filter(Files::isRegularFile).toList()) {
                List<Byte> bytes = new ArrayList<>();
                for (byte b : Files.readAllBytes(file)) {
                    bytes.add(b);
                }
                contents.put(file.getFileName().toString(), bytes);
            }
        }
        return contents;
    }

    /** Runs a command that must change nothing; words that end in a file of the folder are paths. */
    private void assertRefused(String command) throws Exception {
        var before = contents();
        Object[] words =
                Stream.of(command.split(" ")).map(word -> word.startsWith("@") ? folder.resolve(word.substring(1)).toString() : word)
                        .toArray();
        CliResult.run(words).assertRejected(MESSAGE);
        assertThat(contents()).isEqualTo(before);
    }

    @ParameterizedTest
    @ValueSource(strings = {"render @in.jen -o @tex.png", "render @in.jen -o @gobo.png", "render @in.jen -o @sky.hdr",
        "render @in.jen -o @tex.png --traditional", "relight @in.jen -o @tex.png --set k.intensity=2",
        "relight @in.jen -o @a%d.png --set k.intensity=2 --cryptomatte @link.exr",
        "shot render @in.jen -o @tex.png", "shot relight @in.jen -o @tex.png --set k.intensity=2",
        "compare @tex.png @gobo.png -o @gobo.png", "export @in.jen -o @link.pov", "export-lights @in.jen -o @link.json",
        "render @in.jen -o @new.png --cryptomatte @link.exr"})
    void outputThatIsRead_isRefused(String command) throws Exception {
        for (String link : List.of("link.exr", "link.pov", "link.json", "tex-0001.png")) {
            Files.createLink(folder.resolve(link), folder.resolve("sky.hdr"));
        }
        assertRefused(command);
    }

    @Test
    void lookupTableOfView_isRefused() throws Exception {
        Files.createLink(folder.resolve("look.png"), folder.resolve("look.cube"));
        assertRefused("render @in.jen -o @look.png --view @look.cube");
    }

    @Test
    void linksAndOtherSpellings_areTheSameFile() throws Exception {
        Files.createSymbolicLink(folder.resolve("soft.png"), Path.of("tex.png"));
        Files.createDirectory(folder.resolve("sub"));
        assertRefused("render @in.jen -o @soft.png");
        CliResult.run("render", scene, "-o", folder + "/sub/../tex.png").assertRejected(MESSAGE);
        CliResult.run("render", folder + "/sub/../in.jen", "-o", folder + "/tex.png").assertRejected(MESSAGE);
    }

    @Test
    void sceneItself_isNoImage_butCanBeSaved() throws Exception {
        CliResult.run("render", scene, "-o", scene).assertRejected("in.jen");
        CliResult.run("relight", scene, "-o", folder.resolve("a.png"), "--set", "k.intensity=2", "--no-savings", "--save", scene)
                .assertSuccess();
        assertThat(scene).content().contains("intensity 2");
    }
}
