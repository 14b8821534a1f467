package lightning.sample;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.function.Consumer;
import java.util.stream.Stream;
import lightning.format.jen.JenWriter;
import lightning.scene.Scene;

/**
 * Stores the scene of a failed test as a file. Shrinking repeats the failure, so the file ends with the simplest scene. Files moved to
 * {@link #FOLDER} are checked by every run.
 */
public final class FailedSceneRecorder {
    /** Scenes that once failed. */
    public static final Path FOLDER = Path.of("src", "test", "resources", "lightning", "numerics");

    private FailedSceneRecorder() {}

    /** Returns the files in {@link #FOLDER}, sorted by name. */
    public static Stream<Path> storedScenes() throws IOException {
        try (Stream<Path> files = Files.list(FOLDER)) {
            return files.filter(file -> file.toString().endsWith(".jen")).sorted().toList().stream();
        }
    }

    /**
     * Checks a scene; a failure reports the scene and its file.
     *
     * @param test the folder's name in {@code target/failures}
     */
    public static void check(String test, Scene scene, Consumer<Scene> check) {
        try {
            check.accept(scene);
        } catch (AssertionError | RuntimeException e) {
            String text = JenWriter.write(scene);
            throw new AssertionError(e + "\nthe scene was saved in " + save(test, "scene.jen", text) + " and was\n" + text, e);
        }
    }

    /** Stores a text in {@code target/failures/TEST}. */
    public static Path save(String test, String file, String text) {
        try {
            Path folder = Path.of("target", "failures", test);
            Files.createDirectories(folder);
            return Files.writeString(folder.resolve(file), text);
        } catch (IOException e) {
            throw new UncheckedIOException("cannot write the scene of a failed test", e);
        }
    }
}
