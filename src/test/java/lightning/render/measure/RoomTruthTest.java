package lightning.render.measure;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import lightning.base.math.Rgb;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.format.image.ImageFile;
import lightning.format.jen.JenReader;
import lightning.format.jen.PropertyEdit;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.render.image.Downscale;
import lightning.render.image.Film;
import lightning.sample.Nightly;
import lightning.sample.PythonPrograms;
import lightning.sample.Slow;
import lightning.scene.Scene;
import lightning.scene.SceneElement;
import lightning.scene.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Compares rooms at default settings with pictures of a path tracer, which {@code src/test/rooms/README.md} describes. A pixel of those is the
 * mean of 5×5 pixels here. Errors are of luminance ({@link RelativeErrors}).
 */
@Slow
class RoomTruthTest {
    private static final Path ROOMS = Path.of("src/test/rooms");
    private static final double HIGH = 0.95;

    /**
     * Bounds in percent: of the mean error, of the 95th percentile, and of the bias to either side. Targets are 3 and 8; where a room does not
     * reach them, the bound is the next one that it reaches.
     */
    @ParameterizedTest
    @CsvSource(textBlock = """
            corridor, 4, 11, 1
            courtyard, 3, 8, 1
            living-uniform, 3, 8, 1
            niches, 3, 9, 1
            """)
    void indirectLight_isCloseToTruth(String room, double mean, double high, double bias) throws Exception {
        assertError(room, scene(room), mean, high, bias);
    }

    /** Rooms that take long. {@link #indirectLight_isCloseToTruth} covers others. */
    @Nightly
    @ParameterizedTest
    @CsvSource(textBlock = """
            attic, 3, 8, 1
            bath, 7, 18, 1
            cellar, 9, 25, 1
            living, 4, 11, 1
            """)
    void otherRooms_areCloseToTruth(String room, double mean, double high, double bias) throws Exception {
        indirectLight_isCloseToTruth(room, mean, high, bias);
    }

    /** Without indirect light: lights, whose shadows have edges. */
    @ParameterizedTest
    @CsvSource(textBlock = """
            corridor, 3, 8, 1
            niches, 3, 10, 1
            """)
    void directLight_isCloseToTruth(String room, double mean, double high, double bias) throws Exception {
        Scene scene = scene(room);
        assertError(room + "-direct", scene.withPicture(scene.picture().withIndirect(Optional.empty())), mean, high, bias);
    }

    /** Skies without indirect light. {@link #indirectLight_isCloseToTruth} covers them too. */
    @Nightly
    @ParameterizedTest
    @CsvSource(textBlock = """
            attic, 5, 14, 1
            cellar, 14, 60, 1
            courtyard, 3, 8, 2
            living, 6, 19, 1
            living-uniform, 4, 14, 1
            """)
    void skyWithoutIndirectLight_isCloseToTruth(String room, double mean, double high, double bias) throws Exception {
        directLight_isCloseToTruth(room, mean, high, bias);
    }

    /** The program that made the truth still makes it, within the noise of few samples: 256 instead of 8192. */
    @Test
    void program_repeatsTruth(@TempDir Path folder) throws Exception {
        PythonPrograms.require("mitsuba", "numpy");
        Path picture = folder.resolve("corridor.exr");
        PythonPrograms.output(folder, List.of(Path.of("src/test/python/mitsuba_room.py").toAbsolutePath().toString(),
                ROOMS.resolve("corridor.jen").toAbsolutePath().toString(), picture.toString(), "--samples", "256", "--direct"));
        double[] truth = luminances(ImageFile.read(ROOMS.resolve("truth/corridor-direct.exr")));
        RelativeErrors errors = RelativeErrors.of(luminances(ImageFile.read(picture)), truth);
        assertThat(errors.mean()).isLessThan(0.05);
    }

    private static Scene scene(String room) throws Exception {
        boolean isUniform = room.endsWith("-uniform");
        Scene scene = JenReader.read(ROOMS.resolve(room.replace("-uniform", "") + ".jen")).scene();
        return isUniform ? PropertyEdit.setFile(scene, SceneElement.WORLD, World.ENVIRONMENT.name(), "uniform_sky.hdr", ROOMS) : scene;
    }

    private static void assertError(String truth, Scene scene, double mean, double high, double bias) throws Exception {
        double[] expected = luminances(ImageFile.read(ROOMS.resolve("truth/" + truth + ".exr")));
        double[] found;
        try (WorkerPool workers = new WorkerPool(2)) {
            found = luminances(new Downscale(96, 54).apply(new TraditionalTracer(scene).trace(workers, Progress.NONE).film()));
        }
        RelativeErrors errors = RelativeErrors.of(found, expected);
        double excess = Arrays.stream(found).sum() / Arrays.stream(expected).sum() - 1;
        String summary = String.format(Locale.ROOT, "%s: mean %.2f %%, 95th percentile %.2f %%, bias %.2f %%", truth, 100 * errors.mean(),
                100 * errors.percentile(HIGH), 100 * excess);
        assertThat(100 * errors.mean()).as(summary).isLessThanOrEqualTo(mean);
        assertThat(100 * errors.percentile(HIGH)).as(summary).isLessThanOrEqualTo(high);
        assertThat(100 * Math.abs(excess)).as(summary).isLessThanOrEqualTo(bias);
    }

    private static double[] luminances(Film film) {
        double[] luminances = new double[film.width() * film.height()];
        for (int i = 0; i < luminances.length; i++) {
            int x = i % film.width();
            int y = i / film.width();
            luminances[i] = new Rgb(film.red(x, y), film.green(x, y), film.blue(x, y)).luminance();
        }
        return luminances;
    }
}
