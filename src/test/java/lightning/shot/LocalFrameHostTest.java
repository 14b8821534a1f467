package lightning.shot;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.stream.Stream;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.document.DeskScene;
import lightning.render.RenderOptions;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.sample.IndirectScenes;
import lightning.scene.Scene;
import lightning.scene.shot.Shot;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Checks that frames on disk equal frames in memory, and that frames lost by the disk are traced again. */
class LocalFrameHostTest {
    private static final Scene SCENE = DeskScene.scene();
    private static final ShotRevision FIRST = new ShotRevision(SCENE, Shot.DEFAULT);
    private static final ShotRevision BRIGHTER =
            new ShotRevision(DeskScene.sceneOf(DeskScene.parameter("intensity").set(SCENE, "key", 2)), Shot.DEFAULT);
    private static final long UNLIMITED = Long.MAX_VALUE;

    @TempDir
    Path place;

    private List<Path> files(String stem) throws IOException {
        try (Stream<Path> all = Files.walk(place)) {
            return all.filter(f -> f.getFileName().toString().startsWith(stem)).sorted().toList();
        }
    }

    private static void assertExact(FrameUpdate update, ShotRevision revision) {
        assertThat(update.film().hasSameBits(new ReferenceTracer(revision.sceneAt(update.frame())).trace())).isTrue();
    }

    private LocalFrameHost hostOnDisk() throws IOException {
        return new LocalFrameHost(RenderOptions.DEFAULT.withThreads(1), 0, place, UNLIMITED);
    }

    @Test
    void editOfFrameOnDisk_castsNoRays() throws Exception {
        try (LocalFrameHost host = hostOnDisk()) {
            assertThat(host.update(1, FIRST, Progress.NONE).traced()).isTrue();
            FrameUpdate relit = host.update(1, BRIGHTER, Progress.NONE);
            assertThat(relit.traced()).isFalse();
            assertThat(relit.rays()).isZero();
            assertExact(relit, BRIGHTER);
            assertThat(host.film(1).orElseThrow().hasSameBits(relit.film())).isTrue();
            assertThat(host.usage().diskFrames()).isEqualTo(1);
            assertThat(host.problem()).isEmpty();
        }
        assertThat(files("lightning")).isEmpty();
    }

    @Test
    void editWithoutRowChanges_writesOnlyColors() throws Exception {
        try (LocalFrameHost host = hostOnDisk()) {
            host.update(1, FIRST, Progress.NONE);
            List<Path> rows = files("rows");
            List<Path> colors = files("colors");
            host.update(1, BRIGHTER, Progress.NONE);
            assertThat(files("rows")).isEqualTo(rows);
            assertThat(files("colors")).hasSize(1).doesNotContainAnyElementsOf(colors);
        }
    }

    @Test
    void damagedFile_isRetraced() throws Exception {
        try (LocalFrameHost host = hostOnDisk()) {
            host.update(1, FIRST, Progress.NONE);
            try (FileChannel file = FileChannel.open(files("rows").getFirst(), StandardOpenOption.WRITE)) {
                file.write(ByteBuffer.wrap(new byte[] {77}), file.size() / 2);
            }
            FrameUpdate update = host.update(1, BRIGHTER, Progress.NONE);
            assertThat(update.traced()).isTrue();
            assertExact(update, BRIGHTER);
            assertThat(host.problem()).hasValueSatisfying(p -> assertThat(p).contains("cannot read a cached frame"));
        }
    }

    @Test
    void truncatedOrMissingFile_isRetraced() throws Exception {
        try (LocalFrameHost host = hostOnDisk()) {
            host.update(1, FIRST, Progress.NONE);
            host.update(2, FIRST, Progress.NONE);
            try (FileChannel file = FileChannel.open(files("colors").getFirst(), StandardOpenOption.WRITE)) {
                file.truncate(file.size() / 2);
            }
            Files.delete(files("rows").getLast());
            assertThat(host.update(1, BRIGHTER, Progress.NONE).traced()).isTrue();
            assertThat(host.update(2, BRIGHTER, Progress.NONE).traced()).isTrue();
            assertThat(host.update(2, FIRST, Progress.NONE).traced()).isFalse();
        }
    }

    @Test
    void fullDisk_keepsFilmsCorrectAndIsReported() throws Exception {
        try (LocalFrameHost host = new LocalFrameHost(RenderOptions.DEFAULT.withThreads(1), 0, place, 0)) {
            host.update(1, FIRST, Progress.NONE);
            FrameUpdate update = host.update(1, BRIGHTER, Progress.NONE);
            assertThat(update.traced()).isTrue();
            assertExact(update, BRIGHTER);
            assertThat(host.film(1)).isEmpty();
            assertThat(host.problem()).isPresent();
            assertThat(files("rows")).isEmpty();
        }
    }

    @Test
    void editOfFrameWithIndirectLightOnDisk_castsNoRays() throws Exception {
        var first = new ShotRevision(IndirectScenes.with(FIRST.scene()), Shot.DEFAULT);
        var brighter = new ShotRevision(IndirectScenes.with(BRIGHTER.scene()), Shot.DEFAULT);
        try (LocalFrameHost host = hostOnDisk(); WorkerPool workers = new WorkerPool(1)) {
            host.update(1, first, Progress.NONE);
            List<Path> rows = files("rows");
            assertThat(host.usage().diskFrames()).isEqualTo(1);
            FrameUpdate update = host.update(1, brighter, Progress.NONE);
            assertThat(update.traced()).isFalse();
            assertThat(update.rays()).isZero();
            assertThat(update.film().hasSameBits(new TraditionalTracer(brighter.sceneAt(1)).trace(workers, Progress.NONE).film())).isTrue();
            assertThat(host.film(1).orElseThrow().hasSameBits(update.film())).isTrue();
            assertThat(files("rows")).isEqualTo(rows);
            assertThat(host.problem()).isEmpty();
        }
    }

    @Test
    void frameWithIndirectLightInMemory_isUpdated() throws Exception {
        var first = new ShotRevision(IndirectScenes.with(FIRST.scene()), Shot.DEFAULT);
        var brighter = new ShotRevision(IndirectScenes.with(BRIGHTER.scene()), Shot.DEFAULT);
        try (LocalFrameHost host = new LocalFrameHost(RenderOptions.DEFAULT.withThreads(1), UNLIMITED, place, UNLIMITED);
                WorkerPool workers = new WorkerPool(1)) {
            host.update(1, first, Progress.NONE);
            FrameUpdate update = host.update(1, brighter, Progress.NONE);
            assertThat(update.traced()).isFalse();
            assertThat(update.rays()).isZero();
            assertThat(update.film().hasSameBits(new TraditionalTracer(brighter.sceneAt(1)).trace(workers, Progress.NONE).film())).isTrue();
        }
    }

    @Test
    void pinnedFrameWithIndirectLight_isKeptOnDisk() throws Exception {
        var first = new ShotRevision(IndirectScenes.with(FIRST.scene()), Shot.DEFAULT);
        try (LocalFrameHost host = LocalFrameHost.createPinned(RenderOptions.DEFAULT.withThreads(1), 0, place, UNLIMITED)) {
            host.update(1, first, Progress.NONE);
            assertThat(host.usage().diskFrames()).isEqualTo(1);
        }
    }

    @Test
    void framesNearFocus_stayInMemory() throws Exception {
        long each;
        try (LocalFrameHost host = new LocalFrameHost(RenderOptions.DEFAULT.withThreads(1), UNLIMITED)) {
            host.update(1, FIRST, Progress.NONE);
            each = host.usage().memoryBytes();
        }
        try (LocalFrameHost host = new LocalFrameHost(RenderOptions.DEFAULT.withThreads(1), 2 * each)) {
            host.focus(3);
            for (int frame = 1; frame <= 5; frame++) {
                host.update(frame, FIRST, Progress.NONE);
            }
            assertThat(host.usage().memoryFrames()).isEqualTo(2);
            assertThat(host.update(3, BRIGHTER, Progress.NONE).traced()).isFalse();
            assertThat(host.update(1, BRIGHTER, Progress.NONE).traced()).isTrue();
        }
    }

    @Test
    void fullPinnedHost_rejectsNewFrames() throws Exception {
        long each;
        try (LocalFrameHost host = new LocalFrameHost(RenderOptions.DEFAULT.withThreads(1), UNLIMITED)) {
            host.update(1, FIRST, Progress.NONE);
            each = host.usage().memoryBytes();
        }
        // Space that the estimate may accept, and space that is too small.
        for (long remaining : new long[] {each - 1, each / 10}) {
            try (LocalFrameHost host = LocalFrameHost.createPinned(RenderOptions.DEFAULT.withThreads(1), each + remaining, place, 0)) {
                host.focus(2);
                host.update(1, FIRST, Progress.NONE);
                assertThatThrownBy(() -> host.update(2, FIRST, Progress.NONE)).isInstanceOf(FrameRejectedException.class)
                        .hasMessageMatching("the frame needs about .* MB, but only .* MB is free");
                assertThat(host.film(2)).isEmpty();
                assertThat(host.usage()).isEqualTo(new CacheUsage(1, each, 0, 0));
                FrameUpdate relit = host.update(1, BRIGHTER, Progress.NONE);
                assertThat(relit.traced()).isFalse();
                assertExact(relit, BRIGHTER);
                host.drop(1);
                assertExact(host.update(2, BRIGHTER, Progress.NONE), BRIGHTER);
            }
        }
    }

    @Test
    void pinnedHost_usesMemoryAndDisk() throws Exception {
        try (LocalFrameHost host = LocalFrameHost.createPinned(RenderOptions.DEFAULT.withThreads(1), 0, place, UNLIMITED)) {
            for (int frame = 1; frame <= 3; frame++) {
                host.update(frame, FIRST, Progress.NONE);
            }
            assertThat(host.usage().diskFrames()).isEqualTo(3);
        }
    }

    @Test
    void canceledFrame_isUnchanged() throws Exception {
        try (LocalFrameHost host = hostOnDisk()) {
            FrameUpdate first = host.update(1, FIRST, Progress.NONE);
            Progress stopped = new Progress() {
                @Override
                public void report(int done, int total) {}

                @Override
                public boolean isCanceled() {
                    return true;
                }
            };
            assertThatThrownBy(() -> host.update(1, BRIGHTER, stopped)).isInstanceOf(CancellationException.class);
            assertThat(host.film(1).orElseThrow().hasSameBits(first.film())).isTrue();
            assertThat(host.update(1, BRIGHTER, Progress.NONE).traced()).isFalse();
        }
    }

    @Test
    void tooLargeShot_isReportedWithSuggestion() {
        ShotMemoryEstimate need = ShotMemoryEstimate.of(FIRST, 1, 100, RenderOptions.DEFAULT);
        assertThatThrownBy(() -> need.check(2 * need.bytesPerFrame(), 3 * need.bytesPerFrame())).isInstanceOf(ShotTooLargeException.class)
                .hasMessageContainingAll("100 frames", "of memory", "of disk space are free; 5 frames would fit, or a size of ");
        need.check(need.totalBytes(), 0);
        assertThat(need.frameBudget(0)).isZero();
    }
}
