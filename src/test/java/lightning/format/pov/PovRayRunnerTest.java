package lightning.format.pov;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import lightning.base.file.SearchPath;
import lightning.base.math.Rgb;
import lightning.format.image.ImageFile;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.scene.Camera;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** Runs scripts in place of POV-Ray. */
@DisabledOnOs(OS.WINDOWS)
class PovRayRunnerTest {
    private final PovScene scene = PovScene.of(
            new Scene(PictureSettings.DEFAULT, Camera.DEFAULT, new World(1, Rgb.BLACK), List.of(), List.of(), List.of()), "x");

    @TempDir
    Path folder;

    private PovRayRunner fakeProgram(String commands) throws IOException {
        Path program = Files.writeString(folder.resolve("povray"), "#!/bin/sh\n" + commands + "\n");
        assertThat(program.toFile().setExecutable(true)).isTrue();
        return PovRayRunner.find(SearchPath.of(folder.resolve("no") + File.pathSeparator + folder)).orElseThrow();
    }

    @Test
    void traceTime_isParsedFromOutput() throws Exception {
        PovRayRunner pov = fakeProgram("""
                echo '  Parse Time:       0 hours  0 minutes  9 seconds (9.000 seconds)'
                echo '  Trace Time:       0 hours  1 minutes  2 seconds (62.125 seconds)'""");
        assertThat(pov.traceMs(scene, 30, 20, 2)).isEqualTo(62125);
    }

    @Test
    void command_setsSizeAndDisablesAntialiasing() throws Exception {
        Path arguments = folder.resolve("seen");
        PovRayRunner pov = fakeProgram("echo \"$@\" > " + arguments + "; test -f scene.pov && echo 'Trace Time: (0.500 seconds)'");
        assertThat(pov.traceMs(scene, 30, 20, 2)).isEqualTo(500);
        assertThat(arguments).hasContent("+Iscene.pov +W30 +H20 -A +WT2 -D -F");
    }

    @Test
    void render_returnsTheWrittenImage() throws Exception {
        Film film = Film.black(3, 2);
        film.green(0)[33] = 1;
        Path written = folder.resolve("drawn.png");
        ImageFile.write(written, film, ViewTransform.DEFAULT);
        PovRayRunner pov =
                fakeProgram(
                        "echo \"$@\" > " + folder.resolve("seen") + "; cp " + written + " picture.png; echo 'Trace Time: (0.500 seconds)'");
        assertThat(pov.render(scene, 3, 2, 1).hasSameBits(film)).isTrue();
        assertThat(folder.resolve("seen")).hasContent("+Iscene.pov +W3 +H2 -A +WT1 -D +FN8 +Opicture.png");
    }

    @Test
    void trace_returnsFloatsAndTimeOfItsSampling() throws Exception {
        Film film = Film.black(3, 2);
        film.green(0)[33] = 2.5f;
        Path written = folder.resolve("drawn.exr");
        ImageFile.write(written, film, ViewTransform.DEFAULT);
        PovRayRunner pov = fakeProgram(
                "echo \"$@\" > " + folder.resolve("seen") + "; cp " + written + " picture.exr; echo 'Trace Time: (0.500 seconds)'");
        PovRayRunner.Trace trace = pov.trace(scene, 3, 2, 1, PovSampling.adaptive(0.1, 3));
        assertThat(trace.film().hasSameBits(film)).isTrue();
        assertThat(trace.ms()).isEqualTo(500);
        assertThat(folder.resolve("seen")).hasContent("+Iscene.pov +W3 +H2 +A0.1 +AM2 +R3 +WT1 -D +FE +Opicture.exr");
    }

    @Test
    void failure_reportsTheProgramOutput() throws Exception {
        PovRayRunner pov = fakeProgram("echo 'Parse Error: no such thing'; exit 1");
        assertThatThrownBy(() -> pov.traceMs(scene, 30, 20, 2)).isInstanceOf(IOException.class)
                .hasMessage("POV-Ray reported no trace time; its last output was: Parse Error: no such thing");
    }

    @Test
    void missingProgram_isNotFound() {
        assertThat(PovRayRunner.find(SearchPath.of(folder.toString()))).isEmpty();
        assertThat(PovRayRunner.find(SearchPath.of(""))).isEmpty();
    }
}
