package lightning.format.pov;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import lightning.base.math.Rgb;
import lightning.format.picture.PictureFile;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.scene.Camera;
import lightning.scene.Picture;
import lightning.scene.Scene;
import lightning.scene.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** With scripts in place of POV-Ray. */
@DisabledOnOs(OS.WINDOWS)
class PovRayTest {
    private final PovScene scene = PovScene.of(
            new Scene(Picture.DEFAULT, Camera.DEFAULT, new World(1, Rgb.BLACK), List.of(), List.of(), List.of()), "x");

    @TempDir
    Path folder;

    private PovRay saying(String commands) throws IOException {
        Path program = Files.writeString(folder.resolve("povray"), "#!/bin/sh\n" + commands + "\n");
        assertThat(program.toFile().setExecutable(true)).isTrue();
        return PovRay.find(folder.resolve("no") + File.pathSeparator + folder).orElseThrow();
    }

    @Test
    void traceTime_isTheOneThatItTells() throws Exception {
        PovRay pov = saying("""
                echo '  Parse Time:       0 hours  0 minutes  9 seconds (9.000 seconds)'
                echo '  Trace Time:       0 hours  1 minutes  2 seconds (62.125 seconds)'""");
        assertThat(pov.traceMs(scene, 30, 20, 2)).isEqualTo(62125);
    }

    @Test
    void command_asksForTheSamePictureWithoutAntiAliasing() throws Exception {
        Path seen = folder.resolve("seen");
        PovRay pov = saying("echo \"$@\" > " + seen + "; test -f scene.pov && echo 'Trace Time: (0.500 seconds)'");
        assertThat(pov.traceMs(scene, 30, 20, 2)).isEqualTo(500);
        assertThat(seen).hasContent("+Iscene.pov +W30 +H20 -A +WT2 -D -F");
    }

    @Test
    void picture_isTheOneThatItWrites() throws Exception {
        Film film = Film.black(3, 2);
        film.green(0)[33] = 1;
        Path drawn = folder.resolve("drawn.png");
        PictureFile.write(drawn, film, ViewTransform.DEFAULT);
        PovRay pov =
                saying("echo \"$@\" > " + folder.resolve("seen") + "; cp " + drawn + " picture.png; echo 'Trace Time: (0.500 seconds)'");
        assertThat(pov.picture(scene, 3, 2, 1).sameBits(film)).isTrue();
        assertThat(folder.resolve("seen")).hasContent("+Iscene.pov +W3 +H2 -A +WT1 -D +FN8 +Opicture.png");
    }

    @Test
    void failure_isToldInItsOwnWords() throws Exception {
        PovRay pov = saying("echo 'Parse Error: no such thing'; exit 1");
        assertThatThrownBy(() -> pov.traceMs(scene, 30, 20, 2)).isInstanceOf(IOException.class)
                .hasMessage("POV-Ray told no trace time; it ended with: Parse Error: no such thing");
    }

    @Test
    void noProgram_isNotFound() {
        assertThat(PovRay.find(folder.toString())).isEmpty();
        assertThat(PovRay.find("")).isEmpty();
    }
}
