import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import java.util.zip.CRC32C;
import lightning.base.work.Progress;
import lightning.format.jen.JenReader;
import lightning.render.RenderOptions;
import lightning.render.image.Film;
import lightning.render.relight.Renderer;
import lightning.render.relight.UpdateResult;
import lightning.render.relight.paper.Accuracy;
import lightning.render.relight.paper.MirrorStorage;
import lightning.render.relight.paper.ReflectionMode;
import lightning.scene.Scene;

/**
 * Replays stored edit sessions for {@code benchmarks/films}. Prints a line for each scene of each session, in order: a checksum of the
 * updated film, the rows touched and the shadow rays cast. Uses only names that all builds share.
 */
final class Films {
    public static void main(String[] args) throws Exception {
        List<Path> sessions = sorted(Path.of(args[0]));
        for (int i = 0; i < sessions.size(); i++) {
            RenderOptions options =
                    new RenderOptions(i % 5 == 4 ? Accuracy.RATIO : Accuracy.EXACT,
                            i % 3 == 2 ? ReflectionMode.STALE : ReflectionMode.CURRENT,
                            i % 2 == 1 ? MirrorStorage.HIT_SHAPES : MirrorStorage.FULL_ROWS, 2);
            try (var renderer = new Renderer(options)) {
                for (Path file : sorted(sessions.get(i)).stream().filter(f -> f.toString().endsWith(".jen")).toList()) {
                    Scene scene = JenReader.read(file).scene();
                    UpdateResult update = renderer.render(scene, Progress.NONE);
                    System.out.printf("%s/%s %08x %d %d%n", sessions.get(i).getFileName(), file.getFileName(), checksum(renderer.film()),
                            update.rowsTouched(), update.rays().shadow());
                }
            }
        }
    }

    private static List<Path> sorted(Path folder) throws Exception {
        try (Stream<Path> entries = Files.list(folder)) {
            return entries.sorted().toList();
        }
    }

    private static long checksum(Film film) {
        var sum = new CRC32C();
        for (float value : film.toScanlines()) {
            int bits = Float.floatToIntBits(value);
            for (int shift = 0; shift < 32; shift += 8) {
                sum.update(bits >>> shift);
            }
        }
        return sum.getValue();
    }
}
