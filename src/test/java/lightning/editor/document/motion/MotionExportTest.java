package lightning.editor.document.motion;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CancellationException;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.editor.document.DeskScene;
import lightning.format.image.ImageFile;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.render.image.ViewTransform;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class MotionExportTest {
    private final RecordedShot recordedShot = RecordedShot.of(10, List.of(light(0), light(4)));

    @TempDir
    private Path folder;

    @Test
    void pictures_areEvenlySpaced() {
        MotionExport export = export(3);
        assertThat(List.of(0, 1, 2)).extracting(i -> DeskScene.light(export.scene(i), "key").position().x())
                .containsExactly(0.0, 2.0, 4.0);
    }

    @Test
    void onePicture_showsStart() {
        assertThat(DeskScene.light(export(1).scene(0), "key").position().x()).isZero();
    }

    @Test
    void fileNames_sortByNumber() {
        assertThat(export(3).file("a", 1)).isEqualTo("a-0002.png");
        assertThat(export(12_345).file("a", 1)).isEqualTo("a-00002.png");
    }

    @Test
    void everyPicture_equalsFullTrace() throws Exception {
        MotionExport export = export(3);
        export.write(folder, "desk", Progress.NONE, _ -> {});
        Scene last = export.scene(2);
        try (var workers = new WorkerPool(1)) {
            ImageFile.write(folder.resolve("full.png"), new TraditionalTracer(last).trace(workers, Progress.NONE).film(),
                    ViewTransform.DEFAULT);
        }
        assertThat(folder.resolve("desk-0003.png")).hasSameBinaryContentAs(folder.resolve("full.png"));
    }

    @Test
    void canceled_keepsFinishedPictures() {
        List<Integer> written = new ArrayList<>();
        Progress stopAfterOne = Progress.cancellation(() -> !written.isEmpty());
        assertThatThrownBy(() -> export(3).write(folder, "desk", stopAfterOne, written::add)).isInstanceOf(CancellationException.class);
        assertThat(written).containsExactly(1);
        assertThat(folder.resolve("desk-0001.png")).exists();
        assertThat(Files.exists(folder.resolve("desk-0002.png"))).isFalse();
    }

    @Test
    void zeroPictures_areRejected() {
        assertThatThrownBy(() -> export(0)).hasMessage("the number of frames must be from 1 to 100000, was 0");
    }

    private static Light light(double x) {
        return Light.of("key", LightType.SPOT).withPosition(new Vec3(x, 5, 2)).withDirection(new Vec3(0, -1, 0));
    }

    private MotionExport export(int pictures) {
        return new MotionExport(DeskScene.scene(), recordedShot, pictures, ViewTransform.DEFAULT);
    }
}
