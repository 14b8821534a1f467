package lightning.render.relight;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Arrays;
import lightning.base.work.Progress;
import lightning.document.DeskScene;
import lightning.render.RenderOptions;
import lightning.render.cache.PictureFile;
import lightning.render.cache.PixelCache;
import lightning.render.relight.paper.Accuracy;
import lightning.render.relight.paper.MirrorStorage;
import lightning.render.relight.paper.ReflectionMode;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.sample.EditSession;
import lightning.sample.MixedEngineChoice;
import lightning.sample.Slow;
import lightning.scene.Scene;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests that another process, which has only the scene and the file of its picture, continues without a difference. */
class PictureFileTest {
    private static final RenderOptions OPTIONS = new RenderOptions(Accuracy.EXACT, ReflectionMode.CURRENT, MirrorStorage.FULL_ROWS, 1);

    @Provide
    Arbitrary<EditSession> sessions() {
        return Arbitraries.oneOf(EditSession.sessions(), EditSession.mixedSessions(), EditSession.fogSessions(),
                EditSession.indirectObjectSessions(), EditSession.environmentSessions());
    }

    @Property(edgeCases = EdgeCasesMode.NONE)
    @Slow
    void pictureFromFile_equalsReferenceAfterEveryEdit(@ForAll("sessions") EditSession session, @ForAll long engines) throws IOException {
        RenderOptions options = OPTIONS.withEngines(new MixedEngineChoice(engines));
        Path file = Files.createTempFile("lightning", ".picture");
        try (Renderer renderer = new Renderer(options)) {
            for (int step : session.steps()) {
                Scene scene = session.scenes().get(step);
                UpdateResult update = renderer.render(scene, Progress.NONE);
                SessionAssert.assertSameBits(renderer.film(), new ReferenceTracer(scene).trace(), "picture-file", session, step,
                        update.plan().description());
                if (PictureFile.canWrite(renderer.cache())) {
                    write(renderer.cache(), file);
                    renderer.restore(read(file, renderer.scene(), options));
                    UpdateResult nothing = renderer.render(scene, Progress.NONE);
                    assertThat(nothing.rays().total()).isZero();
                }
            }
        } finally {
            Files.delete(file);
        }
    }

    private static void write(PixelCache cache, Path file) throws IOException {
        try (FileChannel channel = FileChannel.open(file, StandardOpenOption.WRITE, StandardOpenOption.TRUNCATE_EXISTING)) {
            PictureFile.write(cache, channel);
        }
    }

    /** Reads a picture with a geometry of its own, as another process does. */
    private static PixelCache read(Path file, Scene scene, RenderOptions options) throws IOException {
        try (Renderer other = new Renderer(options)) {
            return PictureFile.read(file, other.prepare(scene), scene);
        }
    }

    @Test
    void lightThatIsOff_isTracedWhenItIsSwitchedOn(@TempDir Path folder) throws IOException {
        Path file = Files.createFile(folder.resolve("off.picture"));
        Scene on = DeskScene.scene();
        Scene off = on.withLights(on.lights().stream().map(light -> light.withOn(false)).toList());
        try (Renderer renderer = new Renderer(OPTIONS)) {
            renderer.render(on, Progress.NONE);
            renderer.render(off, Progress.NONE);
            write(renderer.cache(), file);
            renderer.restore(read(file, off, OPTIONS));
            renderer.render(on, Progress.NONE);
            assertThat(renderer.film().hasSameBits(new ReferenceTracer(on).trace())).isTrue();
        }
    }

    @Test
    void damagedFile_isRefused(@TempDir Path folder) throws IOException {
        Path file = Files.createFile(folder.resolve("damaged.picture"));
        Scene scene = DeskScene.scene();
        try (Renderer renderer = new Renderer(OPTIONS)) {
            renderer.render(scene, Progress.NONE);
            write(renderer.cache(), file);
        }
        byte[] bytes = Files.readAllBytes(file);
        for (int length : new int[] {0, 7, 15, 16, 100, bytes.length / 2, bytes.length - 1}) {
            Files.write(file, Arrays.copyOf(bytes, length));
            assertThatThrownBy(() -> read(file, scene, OPTIONS)).as("%d bytes", length).isInstanceOf(IOException.class);
        }
        for (int at : new int[] {0, bytes.length / 3, bytes.length - 17, bytes.length - 1}) {
            byte[] changed = bytes.clone();
            changed[at] ^= 4;
            Files.write(file, changed);
            assertThatThrownBy(() -> read(file, scene, OPTIONS)).as("byte %d", at).isInstanceOf(IOException.class);
        }
    }
}
