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
import lightning.cli.output.Console;
import lightning.cli.output.ErrorReporter;
import lightning.format.jen.JenException;
import lightning.format.jen.JenReader;
import lightning.render.RenderOptions;
import lightning.render.relight.MemoryEstimate;
import lightning.render.relight.PictureTooLargeException;
import lightning.render.relight.Renderer;
import lightning.render.relight.paper.MirrorStorage;
import lightning.scene.Scene;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Image of 16384 × 16384 pixels with 64 samples each: every command rejects it before it starts to work. */
class PictureTooLargeTest {
    private static final String SENTENCE = "lightning: the picture needs about ";

    @TempDir
    private Path folder;

    private Path scene(String sampling) throws IOException {
        return Files.writeString(folder.resolve("big.jen"),
                CliResult.SCENE.replace("size 48 32  depth 2", "size 16384 16384  depth 2  " + sampling));
    }

    private Path finestSampling() throws IOException {
        return scene("antialias every  samples 8");
    }

    @Test
    void render_suggestsSizeOption() throws IOException {
        CliResult.run("render", finestSampling(), "-o", folder.resolve("a.png")).assertRejected(SENTENCE,
                "GB is available; it would fit with a size of ",
                " (--size ");
        assertThat(folder.resolve("a.png")).doesNotExist();
    }

    @ParameterizedTest
    @ValueSource(strings = {"effects", "tour"})
    void commandsWithoutStorage_doNotSuggestIt(String command) throws IOException {
        CliResult refused = CliResult.run(command, finestSampling(), "--size", "16384x16384");
        refused.assertRejected(SENTENCE, " (--size ");
        assertThat(refused.err()).doesNotContain("--storage");
    }

    @Test
    void bench_measuresNothing() throws IOException {
        CliResult.run("bench", finestSampling(), "-o", folder.resolve("out"), "--size", "16384x16384").assertRejected(SENTENCE);
    }

    @Test
    void relight_isRejected() throws IOException {
        CliResult.run("relight", finestSampling(), "-o", folder.resolve("a.png"), "--set", "lamp.intensity=2").assertRejected(SENTENCE);
    }

    @Test
    void storage_isSuggestedIfSupported() {
        PictureTooLargeException refusal = refusal();
        assertThat(errorText(refusal, _ -> true)).contains("mirrors stored as shapes (--storage shapes)");
        assertThat(errorText(refusal, option -> option.equals("--size"))).contains("(--size ").doesNotContain("shapes");
    }

    /** Returns the rejection of an image that would fit if reflections were cached as shapes. */
    private static PictureTooLargeException refusal() {
        try {
            Scene scene = JenReader.read(CliResult.SCENE.replace("48 32  depth 2", "320 200  depth 10")
                    .replace("shininess 20", "shininess 20  reflective 0.6 0.6 0.6"), "a.jen", Path.of("")).scene();
            MemoryEstimate.check(scene,
                    RenderOptions.DEFAULT
                            .withMemory((usedBytes(scene, MirrorStorage.FULL_ROWS) + usedBytes(scene, MirrorStorage.HIT_SHAPES)) / 2));
        } catch (PictureTooLargeException e) {
            return e;
        } catch (JenException e) {
            throw new AssertionError(e);
        }
        throw new AssertionError("it fits");
    }

    private static long usedBytes(Scene scene, MirrorStorage storage) {
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT.withStorage(storage))) {
            renderer.render(scene, Progress.NONE);
            return MemoryEstimate.usedBytes(renderer.cache());
        }
    }

    private static String errorText(PictureTooLargeException refusal, Predicate<String> options) {
        var err = new ByteArrayOutputStream();
        assertThat(ErrorReporter.report(Console.of(System.out, new PrintStream(err, true, StandardCharsets.UTF_8)), refusal, options))
                .isEqualTo(2);
        return err.toString(StandardCharsets.UTF_8);
    }
}
