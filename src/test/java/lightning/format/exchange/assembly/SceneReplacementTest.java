package lightning.format.exchange.assembly;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatIOException;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import lightning.base.work.Progress;
import lightning.format.exchange.SceneImporter;
import lightning.format.gltf.GltfFixtures;
import lightning.format.jen.JenReader;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Imports over an earlier import, interrupted between any two changes of files. */
class SceneReplacementTest {
    private static final class Interruption extends RuntimeException {
        private static final long serialVersionUID = 1;
    }

    @TempDir
    private Path folder;
    private Path model;
    private Path target;
    private Path scene;

    @BeforeEach
    void importFirstVersion() throws Exception {
        model = Files.createDirectory(folder.resolve("in")).resolve("a.gltf");
        target = Files.createDirectory(folder.resolve("out"));
        scene = target.resolve("a.jen");
        writeModel("square", 1);
        imported().write();
        assertThat(width(target)).isEqualTo(1);
    }

    /** Writes a model of two files, whose part has another name in each version, so that scenes do not fit to other versions. */
    private void writeModel(String part, float width) throws IOException {
        Files.writeString(model, GltfFixtures.SQUARE_JSON.replace("'name': 'square'", "'name': '" + part + "'")
                .replace("'buffers': [{", "'buffers': [{'uri': 'a.bin', ").replace('\'', '"'));
        byte[] data = GltfFixtures.SQUARE.clone();
        ByteBuffer positions = ByteBuffer.wrap(data).order(ByteOrder.LITTLE_ENDIAN);
        positions.putFloat(3 * Float.BYTES, width).putFloat(6 * Float.BYTES, width);
        Files.write(model.resolveSibling("a.bin"), data);
    }

    private ImportedScene imported() throws Exception {
        return SceneImporter.read(model, scene, LightUnits.CANDELA, Progress.NONE);
    }

    /** Returns the width of the mesh that the scene file of a folder shows. */
    private static float width(Path folder) throws Exception {
        Shape floor = JenReader.read(folder.resolve("a.jen")).scene().stage().shapes().getFirst();
        return ((Solid.TriangleMesh) floor.solid()).mesh().positions()[3];
    }

    private static void copyFolder(Path from, Path to) {
        try (Stream<Path> files = Files.walk(from)) {
            for (Path file : files.toList()) {
                Files.copy(file, to.resolve(from.relativize(file).toString()));
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static SceneReplacement.Observer afterStep(Runnable action) {
        return new SceneReplacement.Observer() {
            @Override
            public void afterStep() {
                action.run();
            }
        };
    }

    private static List<String> files(Path folder) throws IOException {
        try (Stream<Path> files = Files.walk(folder)) {
            return files.filter(Files::isRegularFile).map(file -> folder.relativize(file).toString()).sorted().toList();
        }
    }

    @Test
    void processKilledAfterAnyStep_leavesReadableScene() throws Exception {
        writeModel("wide square", 2);
        List<Path> states = new ArrayList<>();
        imported().writeReplacing(afterStep(() -> {
            states.add(folder.resolve("state" + states.size()));
            copyFolder(target, states.getLast());
        }));
        List<Float> widths = new ArrayList<>();
        for (Path state : states) {
            widths.add(width(state));
        }
        assertThat(widths).containsExactly(1f, 1f, 2f, 2f, 2f, 2f);
        assertThat(width(target)).isEqualTo(2);
        assertThat(files(target)).containsExactly("a.bin", "a.gltf", "a.jen");
    }

    @Test
    void failureAfterAnyStep_leavesReadableScene() throws Exception {
        for (int steps = 1; steps <= 6; steps++) {
            int last = steps;
            float before = width(target);
            writeModel("square " + steps, 1 + steps);
            int[] count = {0};
            assertThatExceptionOfType(Interruption.class).isThrownBy(() -> imported().writeReplacing(afterStep(() -> {
                if (++count[0] == last) {
                    throw new Interruption();
                }
            })));
            assertThat(width(target)).isEqualTo(steps < 3 ? before : 1 + steps);
        }
        writeModel("last", 9);
        imported().writeReplacing();
        assertThat(width(target)).isEqualTo(9);
        assertThat(Files.readString(scene)).contains("\"a.gltf\"");
    }

    @Test
    void failureBeforeSceneIsNew_leavesNoFolder() throws Exception {
        writeModel("wide square", 2);
        assertThatExceptionOfType(Interruption.class).isThrownBy(() -> imported().writeReplacing(afterStep(() -> {
            throw new Interruption();
        })));
        assertThat(files(target)).containsExactly("a.bin", "a.gltf", "a.jen");
    }

    /** Lets writes succeed until the disk is full, for every number of them. */
    @Test
    void fullDisk_leavesNoFolder() throws Exception {
        writeModel("wide square", 2);
        int[] count = {0};
        int room = -1;
        boolean isFull = true;
        while (isFull) {
            room++;
            int last = room;
            count[0] = 0;
            ImportedScene replaced = imported();
            isFull = !isWritten(() -> replaced.writeReplacing(new SceneReplacement.Observer() {
                @Override
                public void beforeWrite(Path file) throws IOException {
                    if (++count[0] > last) {
                        throw new FileSystemException(file.toString(), null, "No space left on device");
                    }
                }
            }));
            assertThat(width(target)).as("room for %s files", room).isEqualTo(isFull ? 1 : 2);
            assertThat(files(target)).containsExactly("a.bin", "a.gltf", "a.jen");
        }
        assertThat(room).as("two files, and the scene before and after").isEqualTo(4);
    }

    private static boolean isWritten(ThrowingCallable write) throws Exception {
        try {
            write.call();
            return true;
        } catch (FileSystemException e) {
            return false;
        } catch (Throwable e) {
            throw new AssertionError(e);
        }
    }

    @Test
    void folderOfKilledImport_isRemovedByNextOne() throws Exception {
        writeModel("wide square", 2);
        List<Path> states = new ArrayList<>();
        imported().writeReplacing(afterStep(() -> {
            states.add(folder.resolve("killed" + states.size()));
            copyFolder(target, states.getLast());
        }));
        for (Path state : states) {
            assertThat(state.resolve("a.import")).exists();
            scene = state.resolve("a.jen");
            imported().writeReplacing();
            assertThat(files(state)).containsExactly("a.bin", "a.gltf", "a.jen");
        }
    }

    @Test
    void folderOfUserOrOfAnotherScene_stays() throws Exception {
        Files.writeString(Files.createDirectory(target.resolve("a.import")).resolve("mine.txt"), "mine");
        Files.writeString(Files.createDirectory(target.resolve("a.import2")).resolve("in-use"), "");
        Path empty = Files.createDirectory(target.resolve("a.import3"));
        Files.setLastModifiedTime(empty, FileTime.from(Instant.now().minusSeconds(120)));
        Files.writeString(target.resolve("look.jen"), "mesh \"a.import2/a.gltf\"");
        writeModel("wide square", 2);
        imported().writeReplacing();
        assertThat(files(target)).containsExactly("a.bin", "a.gltf", "a.import/mine.txt", "a.import2/in-use", "a.jen", "look.jen");
        assertThat(empty).as("left between two steps").doesNotExist();
    }

    @Test
    void readOnlyFile_changesNothing() throws Exception {
        writeModel("wide square", 2);
        assertThat(target.resolve("a.gltf").toFile().setWritable(false)).isTrue();
        assertThatIOException().isThrownBy(() -> imported().writeReplacing()).withMessageContaining("read-only");
        assertThat(width(target)).isEqualTo(1);
        assertThat(files(target)).containsExactly("a.bin", "a.gltf", "a.jen");
    }
}
