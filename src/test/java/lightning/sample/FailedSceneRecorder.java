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
 * Leaves the scene of a failed test as a file. In search of the plainest failure a property fails again and again, so
 * that the file holds the plainest scene in the end. Moved into {@link #FOLDER} it is checked by every run.
 */
public final class FailedSceneRecorder {
    /** The scenes that once failed. */
    public static final Path FOLDER = Path.of("src", "test", "resources", "lightning", "numerics");

    private FailedSceneRecorder() {}

    /** The files in {@link #FOLDER}, in the order of their names. */
    public static Stream<Path> storedScenes() throws IOException {
        try (Stream<Path> files = Files.list(FOLDER)) {
            return files.filter(file -> file.toString().endsWith(".jen")).sorted().toList().stream();
        }
    }

    /**
     * Checks a scene; a failure says where it was left and what it is.
     *
     * @param test the folder's name in {@code target/failures}
     */
    public static void check(String test, Scene scene, Consumer<Scene> check) {
        try {
            check.accept(scene);
        } catch (AssertionError | RuntimeException e) {
            String text = JenWriter.write(scene);
            throw new AssertionError(e + "\nthe scene was left in " + save(test, "scene.jen", text) + " and was\n" + text, e);
        }
    }

    /** Leaves a text in {@code target/failures/TEST}. */
    public static Path save(String test, String file, String text) {
        try {
            Path folder = Path.of("target", "failures", test);
            Files.createDirectories(folder);
            return Files.writeString(folder.resolve(file), text);
        } catch (IOException e) {
            throw new UncheckedIOException("the scene of a failed test could not be written", e);
        }
    }
}
