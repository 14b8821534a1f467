package lightning.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.io.RandomAccessFile;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import lightning.sample.Slow;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** Outputs that cannot be written, and inputs that are no ordinary files. */
@DisabledOnOs(OS.WINDOWS)
@Slow
class OddFilesTest {
    private static final String JAVA = Path.of(System.getProperty("java.home"), "bin", "java").toString();

    @TempDir
    private Path folder;

    @Test
    void resultsThatCannotBeWritten_areAComplaintWithExitCode2() throws IOException {
        var full = new PrintStream(new OutputStream() {
            @Override
            public void write(int b) throws IOException {
                throw new IOException("No space left on device");
            }
        }, false, StandardCharsets.UTF_8);
        var err = new ByteArrayOutputStream();
        int exit = Lightning.run(full, new PrintStream(err, true, StandardCharsets.UTF_8), "check", Cli.scene(folder).toString());
        assertThat(exit).isEqualTo(2);
        assertThat(err.toString(StandardCharsets.UTF_8)).hasLineCount(1).contains("could not be written to the standard output");
    }

    @Test
    void pipeAsScene_isRefusedAtOnce() throws Exception {
        Cli.run("check", pipe("pipe.jen")).isRefusedSaying("pipe.jen: is no file but a pipe or a device");
    }

    @Test
    void deviceAsScene_isRefusedAtOnce() {
        Cli.run("check", "/dev/zero").isRefusedSaying("/dev/zero: is no file but a pipe or a device");
    }

    private Path pipe(String name) throws Exception {
        Path pipe = folder.resolve(name);
        assertThat(new ProcessBuilder("mkfifo", pipe.toString()).start().waitFor()).isZero();
        return pipe;
    }

    @Test
    void folderAsScene_isRefused() throws IOException {
        Cli.run("check", Files.createDirectory(folder.resolve("a.jen"))).isRefusedSaying("a.jen: is a folder, expected a .jen file");
    }

    @Test
    void sceneLargerThanItsLimit_isRefusedWithTheLimit() throws IOException {
        Path file = folder.resolve("large.jen");
        try (var large = new RandomAccessFile(file.toFile(), "rw")) {
            large.setLength(10L << 30);
        }
        Cli.run("check", file).isRefusedSaying("large.jen:1:1: a scene file may have at most 268435456 bytes, found more");
    }

    @Test
    void pipeAsPictureToCompare_isRefusedAtOnce() throws Exception {
        for (String ending : List.of("png", "xpm", "pfm")) {
            Path pipe = pipe("p." + ending);
            Cli.run("compare", pipe, pipe).isRefusedSaying("p." + ending + ": is no file");
        }
    }

    @Test
    void linkToADeviceAsPictureToCompare_isRefusedAtOnce() throws IOException {
        Path link = Files.createSymbolicLink(folder.resolve("zero.pfm"), Path.of("/dev/zero"));
        Cli.run("compare", link, link).isRefusedSaying("zero.pfm: is no file");
    }

    @Test
    void hugePictureToCompare_isRefusedByItsHeader() throws IOException {
        Path file = Files.writeString(folder.resolve("huge.pfm"), "PF\n16384 16384\n-1.0\n");
        try (var large = new RandomAccessFile(file.toFile(), "rw")) {
            large.setLength(12L << 28);
        }
        Cli.run("compare", file, file)
                .isRefusedSaying("huge.pfm: has 16384 × 16384 pixels; expected 1 to 16384 in each direction and at most 67108864");
    }

    @Test
    void fileWithoutAnEndOfItsHeader_isRefusedAsPicture() throws IOException {
        Path file = folder.resolve("zeros.pfm");
        try (var large = new RandomAccessFile(file.toFile(), "rw")) {
            large.setLength(10L << 30);
        }
        Cli.run("compare", file, file).isRefusedSaying("zeros.pfm: ");
    }

    @Test
    void deviceAsBaseline_isRefusedBeforeAnythingIsMeasured() throws IOException {
        Cli.run("bench", Cli.scene(folder), "-o", folder.resolve("out"), "--baseline", "/dev/zero")
                .isRefusedSaying("/dev/zero: is no file, expected results of 'lightning bench'");
    }

    @Test
    void baselineWithoutALevel_isRefusedBeforeAnythingIsMeasured() throws IOException {
        String known = Files.readString(Path.of("benchmarks/results/figures.json"));
        String level = "\"level\" : \"";
        int at = known.indexOf(level);
        assertThat(at).isPositive();
        String broken = known.substring(0, at) + "\"level\" : null" + known.substring(known.indexOf('"', at + level.length()) + 1);
        Path file = Files.writeString(folder.resolve("old.json"), broken);
        Cli.run("bench", Cli.scene(folder), "-o", folder.resolve("out"), "--baseline", file)
                .isRefusedSaying("old.json", "no results of 'lightning bench'", "a level is missing");
    }

    @Test
    void nameThatCannotBeAFiles_isRefusedInASentence() {
        Cli.run("check", "a\0b.jen").isRefusedSaying("cannot be a file's name here", "LC_ALL=C.UTF-8");
    }

    @Test
    void wordOfAnyLength_isRefusedInAShortSentence() throws IOException {
        String word = "x".repeat(3000);
        Path scene = Cli.scene(folder);
        for (List<Object> line : List.<List<Object>>of(List.of("check", word + ".jen"), List.of("shot", word),
                List.of("render", scene, "-o", "a.png", "--" + word),
                List.of("render", scene, "-o", "a.png", "--size=" + word), List.of("render", scene, "-o", word + ".png"),
                List.of("relight", scene, "-o", "a.png", "--set", word + ".intensity=2", "--then"),
                List.of("relight", scene, "-o", "a.png", "--case", word, "--then"), List.of("check", "a\0" + word))) {
            Cli refused = Cli.run(line.toArray());
            refused.isRefusedSaying("xxx");
            assertThat(refused.err().length()).as(refused.err()).isLessThan(1000);
        }
    }

    /** No file may grow beyond a block of the shell, 512 or 1024 bytes. */
    @Test
    void fileThatGrowsTooLarge_isNamed() throws Exception {
        Path scene = Cli.scene(folder);
        for (String name : List.of("out.png", "out.exr", "out.pfm")) {
            Path out = folder.resolve(name);
            Process process = new ProcessBuilder("sh", "-c", "ulimit -f 1; exec \"$@\"", "sh", JAVA, "-XX:-UsePerfData", "--add-modules",
                    "jdk.incubator.vector", "-cp", System.getProperty("java.class.path"), "lightning.Main", "render", scene.toString(),
                    "-o",
                    out.toString(), "--size", "100x100").redirectErrorStream(true).start();
            String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
            assertThat(process.waitFor()).as(said).isEqualTo(2);
            assertThat(said).contains("lightning: " + out + ": File too large");
            assertThat(out).doesNotExist();
        }
    }
}
