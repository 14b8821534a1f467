package lightning.shot.movie;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import lightning.base.file.AtomicFile;
import lightning.base.file.SearchPath;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Tests videos encoded by ffmpeg; without it, only the error message. */
class MovieWriterTest {
    @TempDir
    Path folder;

    static boolean hasFfmpeg() {
        return Ffmpeg.find().isPresent();
    }

    private static Film gray(int width, int height, float light) {
        float[] rgb = new float[3 * width * height];
        Arrays.fill(rgb, light);
        return Film.ofScanlines(width, height, rgb);
    }

    private void write(Ffmpeg ffmpeg, Path file, double rate, Film... films) throws IOException {
        AtomicFile.of(file).writeToPath(temporary -> {
            try (var movie = new MovieWriter(ffmpeg, MovieFormat.of(file).orElseThrow(), rate, ViewTransform.DEFAULT, temporary)) {
                for (Film film : films) {
                    movie.add(film);
                }
                movie.finish();
            }
        });
    }

    private static String output(String... command) throws Exception {
        Process process = new ProcessBuilder(command).redirectError(ProcessBuilder.Redirect.DISCARD).start();
        String out = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertThat(process.waitFor()).isZero();
        return out.strip();
    }

    private List<Path> files() throws IOException {
        try (Stream<Path> all = Files.list(folder)) {
            return all.toList();
        }
    }

    @ParameterizedTest
    @EnumSource
    @EnabledIf("hasFfmpeg")
    void movie_hasFramesRateAndEvenSize(MovieFormat kind) throws Exception {
        Path file = folder.resolve("a" + kind.ending());
        write(Ffmpeg.require(), file, 12.5, gray(33, 17, 0), gray(33, 17, 0.2f), gray(33, 17, 1));
        assertThat(output("ffprobe", "-v", "error", "-count_frames", "-select_streams", "v", "-show_entries",
                "stream=width,height,r_frame_rate,nb_read_frames,pix_fmt", "-of", "csv=p=0", file.toString()))
                .isEqualTo("34,18,yuv420p,25/2,3");
        assertThat(files()).containsExactly(file);
    }

    @Test
    @EnabledIf("hasFfmpeg")
    void frames_matchDisplay() throws Exception {
        Path file = folder.resolve("a.mp4");
        write(Ffmpeg.require(), file, 24, gray(16, 16, 0), gray(16, 16, 0.2f), gray(16, 16, 1));
        Path raw = folder.resolve("raw");
        output("ffmpeg", "-v", "error", "-i", file.toString(), "-f", "rawvideo", "-pix_fmt", "rgb24", raw.toString());
        byte[] pixels = Files.readAllBytes(raw);
        for (int i = 0; i < 3; i++) {
            int expected = ViewTransform.DEFAULT.encode(new float[] {0, 0.2f, 1}[i]);
            // A video stores brightness in 219 steps, and loses more in its encoder.
            assertThat(pixels[i * 3 * 256] & 0xFF).isBetween(expected - 3, expected + 3);
        }
    }

    @Test
    @EnabledIf("hasFfmpeg")
    void failedMovie_isReportedAndKeepsOldFile() throws Exception {
        Path file = Files.writeString(folder.resolve("a.mp4"), "old");
        Path script = Files.writeString(folder.resolve("ffmpeg"), "#!/bin/sh\necho 'no codec here' >&2\nexit 3\n");
        Files.setPosixFilePermissions(script, PosixFilePermissions.fromString("rwxr-xr-x"));
        assertThatThrownBy(() -> write(new Ffmpeg(script), file, 24, gray(400, 400, 0), gray(400, 400, 0))).isInstanceOf(IOException.class)
                .hasMessage("ffmpeg failed: no codec here");
        assertThat(Files.readString(file)).isEqualTo("old");
        assertThat(files()).containsExactlyInAnyOrder(file, script);
    }

    @Test
    void missingFfmpeg_isNamed() {
        assertThat(Ffmpeg.findIn(SearchPath.of(folder.toString()))).isEmpty();
        assertThat(Ffmpeg.missingMessage()).contains("needs ffmpeg, which is not installed");
    }
}
