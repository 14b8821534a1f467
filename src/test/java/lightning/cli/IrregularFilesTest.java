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

/** Outputs that cannot be written, and inputs that are not regular files. */
@DisabledOnOs(OS.WINDOWS)
@Slow
class IrregularFilesTest {
    private static final String JAVA = Path.of(System.getProperty("java.home"), "bin", "java").toString();

    @TempDir
    private Path folder;

    @Test
    void unwritableOutput_exitsWithCode2() throws IOException {
        var full = new PrintStream(new OutputStream() {
            @Override
            public void write(int b) throws IOException {
                throw new IOException("No space left on device");
            }
        }, false, StandardCharsets.UTF_8);
        var err = new ByteArrayOutputStream();
        int exit = Lightning.run(full, new PrintStream(err, true, StandardCharsets.UTF_8), "check", CliResult.scene(folder).toString());
        assertThat(exit).isEqualTo(2);
        assertThat(err.toString(StandardCharsets.UTF_8)).hasLineCount(1).contains("cannot write to the standard output");
    }

    @Test
    void pipeAsScene_isRejected() throws Exception {
        CliResult.run("check", pipe("pipe.jen")).assertRejected("pipe.jen: is a pipe or a device");
    }

    @Test
    void deviceAsScene_isRejected() {
        CliResult.run("check", "/dev/zero").assertRejected("/dev/zero: is a pipe or a device");
    }

    private Path pipe(String name) throws Exception {
        Path pipe = folder.resolve(name);
        assertThat(new ProcessBuilder("mkfifo", pipe.toString()).start().waitFor()).isZero();
        return pipe;
    }

    @Test
    void folderAsScene_isRejected() throws IOException {
        CliResult.run("check", Files.createDirectory(folder.resolve("a.jen"))).assertRejected("a.jen: is a folder, expected a .jen file");
    }

    @Test
    void tooLargeScene_isRejectedWithLimit() throws IOException {
        Path file = folder.resolve("large.jen");
        try (var large = new RandomAccessFile(file.toFile(), "rw")) {
            large.setLength(10L << 30);
        }
        CliResult.run("check", file).assertRejected("large.jen:1:1: a scene file may have at most 268435456 bytes, found more");
    }

    @Test
    void pipeAsPicture_isRejected() throws Exception {
        for (String ending : List.of("png", "exr", "pfm")) {
            Path pipe = pipe("p." + ending);
            CliResult.run("compare", pipe, pipe).assertRejected("p." + ending + ": is not a regular file");
        }
    }

    @Test
    void deviceLinkAsPicture_isRejected() throws IOException {
        Path link = Files.createSymbolicLink(folder.resolve("zero.pfm"), Path.of("/dev/zero"));
        CliResult.run("compare", link, link).assertRejected("zero.pfm: is not a regular file");
        // JUnit warns about links out of its folder.
        Files.delete(link);
    }

    @Test
    void hugePicture_isRejectedByHeader() throws IOException {
        Path file = Files.writeString(folder.resolve("huge.pfm"), "PF\n16384 16384\n-1.0\n");
        try (var large = new RandomAccessFile(file.toFile(), "rw")) {
            large.setLength(12L << 28);
        }
        CliResult.run("compare", file, file)
                .assertRejected("huge.pfm: must have at most 67108864 pixels, has 16384×16384");
    }

    @Test
    void unterminatedHeader_isRejected() throws IOException {
        Path file = folder.resolve("zeros.pfm");
        try (var large = new RandomAccessFile(file.toFile(), "rw")) {
            large.setLength(10L << 30);
        }
        CliResult.run("compare", file, file).assertRejected("zeros.pfm: ");
    }

    @Test
    void deviceAsBaseline_isRejectedFirst() throws IOException {
        CliResult.run("bench", CliResult.scene(folder), "-o", folder.resolve("out"), "--baseline", "/dev/zero")
                .assertRejected("/dev/zero: expected a results file of 'lightning bench', found no regular file");
    }

    @Test
    void baselineWithoutLevel_isRejectedFirst() throws IOException {
        String json = Files.readString(Path.of("benchmarks/results/figures.json"));
        String level = "\"level\" : \"";
        int index = json.indexOf(level);
        assertThat(index).isPositive();
        String broken = json.substring(0, index) + "\"level\" : null" + json.substring(json.indexOf('"', index + level.length()) + 1);
        Path file = Files.writeString(folder.resolve("old.json"), broken);
        CliResult.run("bench", CliResult.scene(folder), "-o", folder.resolve("out"), "--baseline", file)
                .assertRejected("old.json", "expected a results file of 'lightning bench'", "missing level");
    }

    @Test
    void invalidFileName_isRejected() {
        CliResult.run("check", "a\0b.jen").assertRejected("not a valid file name", "LC_ALL=C.UTF-8");
    }

    @Test
    void longArgument_isShortenedInError() throws IOException {
        String word = "x".repeat(3000);
        Path scene = CliResult.scene(folder);
        for (List<Object> line : List.<List<Object>>of(List.of("check", word + ".jen"), List.of("shot", word),
                List.of("render", scene, "-o", "a.png", "--" + word),
                List.of("render", scene, "-o", "a.png", "--size=" + word), List.of("render", scene, "-o", word + ".png"),
                List.of("relight", scene, "-o", "a.png", "--set", word + ".intensity=2", "--then"),
                List.of("relight", scene, "-o", "a.png", "--case", word, "--then"), List.of("check", "a\0" + word))) {
            CliResult refused = CliResult.run(line.toArray());
            refused.assertRejected("xxx");
            assertThat(refused.err().length()).as(refused.err()).isLessThan(1000);
        }
    }

    /** Limits files to one block of the shell, 512 or 1024 bytes. */
    @Test
    void growingFile_isRejectedByName() throws Exception {
        Path scene = CliResult.scene(folder);
        for (String name : List.of("out.png", "out.exr", "out.pfm")) {
            Path out = folder.resolve(name);
            Process process = new ProcessBuilder("sh", "-c", "ulimit -f 1; exec \"$@\"", "sh", JAVA, "-XX:-UsePerfData", "--add-modules",
                    "jdk.incubator.vector", "-cp", System.getProperty("java.class.path"), "lightning.Main", "render", scene.toString(),
                    "-o",
                    out.toString(), "--size", "100x100").redirectErrorStream(true).start();
            String output = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
            assertThat(process.waitFor()).as(output).isEqualTo(2);
            assertThat(output).contains("lightning: " + out + ": File too large");
            assertThat(out).doesNotExist();
        }
    }
}
