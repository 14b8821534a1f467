package lightning.bench.accuracy;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import lightning.format.jen.JenException;
import lightning.format.jen.JenReader;
import lightning.sample.IndirectScenes;
import lightning.scene.Scene;

/** Scenes of the project. */
public final class SceneFiles {
    private static final Path FOLDER = Path.of("scenes");

    private SceneFiles() {}

    /** Returns the names of all scenes, without {@code .jen}. */
    public static List<String> names() {
        try (Stream<Path> files = Files.list(FOLDER)) {
            return files.map(f -> f.getFileName().toString()).filter(n -> n.endsWith(".jen"))
                    .map(n -> n.substring(0, n.length() - 4)).sorted().toList();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Returns a scene without indirect light and anti-aliasing, as most parts of the benchmark measure it. */
    public static Scene read(String name) {
        return IndirectScenes.withoutEdges(IndirectScenes.without(readAll(name)));
    }

    /** Returns a scene as its file describes it. */
    static Scene readAll(String name) {
        try {
            return JenReader.read(FOLDER.resolve(name + ".jen")).scene();
        } catch (IOException | JenException e) {
            throw new AssertionError(name, e);
        }
    }

    /** Returns a scene at {@code size} × {@code size} pixels. */
    public static Scene read(String name, int size) {
        Scene scene = read(name);
        return scene.withPicture(scene.picture().withSize(size, size));
    }
}
