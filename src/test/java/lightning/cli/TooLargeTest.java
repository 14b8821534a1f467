package lightning.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.function.Predicate;
import lightning.base.work.Progress;
import lightning.format.jen.JenException;
import lightning.format.jen.JenReader;
import lightning.render.relight.MemoryNeed;
import lightning.render.relight.PictureTooLarge;
import lightning.render.relight.Renderer;
import lightning.render.relight.tile.MirrorStorage;
import lightning.render.relight.tile.Options;
import lightning.scene.Scene;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A picture of 16384 × 16384 pixels with 64 samples each, which no memory holds: every command refuses it before it works. */
class TooLargeTest {
    private static final String SENTENCE = "lightning: the picture needs about ";

    @TempDir
    private Path folder;

    private Path scene(String sampling) throws IOException {
        return Files.writeString(folder.resolve("big.jen"),
                Cli.SCENE.replace("size 48 32  depth 2", "size 16384 16384  depth 2  " + sampling));
    }

    private Path finest() throws IOException {
        return scene("antialias every  samples 8");
    }

    @Test
    void render_namesASizeWithItsOption() throws IOException {
        Cli.run("render", finest(), "-o", folder.resolve("a.png")).isRefusedSaying(SENTENCE, "GB; it would fit with a size of ",
                " (--size ");
        assertThat(folder.resolve("a.png")).doesNotExist();
    }

    @ParameterizedTest
    @ValueSource(strings = {"effects", "tour"})
    void commandsWithoutStorage_doNotNameIt(String command) throws IOException {
        Cli refused = Cli.run(command, finest(), "--size", "16384x16384");
        refused.isRefusedSaying(SENTENCE, " (--size ");
        assertThat(refused.err()).doesNotContain("--storage");
    }

    @Test
    void bench_measuresNothing() throws IOException {
        Cli.run("bench", finest(), "-o", folder.resolve("out"), "--size", "16384x16384").isRefusedSaying(SENTENCE);
    }

    @Test
    void relight_isRefusedToo() throws IOException {
        Cli.run("relight", finest(), "-o", folder.resolve("a.png"), "--set", "lamp.intensity=2").isRefusedSaying(SENTENCE);
    }

    @Test
    void storage_isNamedWhereTheCommandHasIt() {
        PictureTooLarge refusal = refusal();
        assertThat(complaint(refusal, _ -> true)).contains("mirrors kept as shapes (--storage shapes)");
        assertThat(complaint(refusal, option -> option.equals("--size"))).contains("(--size ").doesNotContain("shapes");
    }

    /** Of a picture that would fit if its mirrors were kept as shapes. */
    private static PictureTooLarge refusal() {
        try {
            Scene scene = JenReader.read(Cli.SCENE.replace("48 32  depth 2", "320 200  depth 10")
                    .replace("shininess 20", "shininess 20  reflective 0.6 0.6 0.6"), "a.jen", Path.of("")).scene();
            MemoryNeed.check(scene,
                    Options.DEFAULT.withMemory((taken(scene, MirrorStorage.FULL_ROWS) + taken(scene, MirrorStorage.HIT_SHAPES)) / 2));
        } catch (PictureTooLarge e) {
            return e;
        } catch (JenException e) {
            throw new AssertionError(e);
        }
        throw new AssertionError("it fits");
    }

    private static long taken(Scene scene, MirrorStorage storage) {
        try (Renderer renderer = new Renderer(Options.DEFAULT.withStorage(storage))) {
            renderer.render(scene, Progress.NONE);
            return MemoryNeed.of(renderer.cache());
        }
    }

    private static String complaint(PictureTooLarge refusal, Predicate<String> options) {
        var err = new ByteArrayOutputStream();
        assertThat(Complaint.report(Console.of(System.out, new PrintStream(err, true, StandardCharsets.UTF_8)), refusal, options))
                .isEqualTo(2);
        return err.toString(StandardCharsets.UTF_8);
    }
}
