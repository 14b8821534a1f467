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
import lightning.editor.document.Desk;
import lightning.render.relight.tile.Options;
import lightning.render.shading.ReferenceTracer;
import lightning.scene.Scene;
import lightning.scene.shot.Shot;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Frames on disk are as good as frames in memory, and what the disk loses is traced again. */
class LocalKeeperTest {
    private static final Scene SCENE = Desk.scene();
    private static final Take FIRST = new Take(SCENE, Shot.DEFAULT);
    private static final Take BRIGHTER = new Take(Desk.done(Desk.dial("intensity").set(SCENE, "key", 2)), Shot.DEFAULT);
    private static final long ALL = Long.MAX_VALUE;

    @TempDir
    Path place;

    private List<Path> files(String stem) throws IOException {
        try (Stream<Path> all = Files.walk(place)) {
            return all.filter(f -> f.getFileName().toString().startsWith(stem)).sorted().toList();
        }
    }

    private static void assertExact(FrameUpdate update, Take take) {
        assertThat(update.film().sameBits(new ReferenceTracer(take.at(update.frame())).trace())).isTrue();
    }

    private LocalKeeper onDisk() throws IOException {
        return new LocalKeeper(Options.DEFAULT.withThreads(1), 0, place, ALL);
    }

    @Test
    void edit_ofAFrameOnDiskCastsNoRay() throws Exception {
        try (LocalKeeper keeper = onDisk()) {
            assertThat(keeper.bring(1, FIRST, Progress.NONE).traced()).isTrue();
            FrameUpdate relit = keeper.bring(1, BRIGHTER, Progress.NONE);
            assertThat(relit.traced()).isFalse();
            assertThat(relit.rays()).isZero();
            assertExact(relit, BRIGHTER);
            assertThat(keeper.film(1).orElseThrow().sameBits(relit.film())).isTrue();
            assertThat(keeper.bytes().onDisk()).isEqualTo(1);
            assertThat(keeper.problem()).isEmpty();
        }
        assertThat(files("lightning")).isEmpty();
    }

    @Test
    void edit_thatLeavesRowsAloneWritesColorsAlone() throws Exception {
        try (LocalKeeper keeper = onDisk()) {
            keeper.bring(1, FIRST, Progress.NONE);
            List<Path> rows = files("rows");
            List<Path> colors = files("colors");
            keeper.bring(1, BRIGHTER, Progress.NONE);
            assertThat(files("rows")).isEqualTo(rows);
            assertThat(files("colors")).hasSize(1).doesNotContainAnyElementsOf(colors);
        }
    }

    @Test
    void damagedFile_isTracedAgain() throws Exception {
        try (LocalKeeper keeper = onDisk()) {
            keeper.bring(1, FIRST, Progress.NONE);
            try (FileChannel file = FileChannel.open(files("rows").getFirst(), StandardOpenOption.WRITE)) {
                file.write(ByteBuffer.wrap(new byte[] {77}), file.size() / 2);
            }
            FrameUpdate update = keeper.bring(1, BRIGHTER, Progress.NONE);
            assertThat(update.traced()).isTrue();
            assertExact(update, BRIGHTER);
            assertThat(keeper.problem()).hasValueSatisfying(p -> assertThat(p).contains("could not be read"));
        }
    }

    @Test
    void fileThatIsCutOffOrGone_isTracedAgain() throws Exception {
        try (LocalKeeper keeper = onDisk()) {
            keeper.bring(1, FIRST, Progress.NONE);
            keeper.bring(2, FIRST, Progress.NONE);
            try (FileChannel file = FileChannel.open(files("colors").getFirst(), StandardOpenOption.WRITE)) {
                file.truncate(file.size() / 2);
            }
            Files.delete(files("rows").getLast());
            assertThat(keeper.bring(1, BRIGHTER, Progress.NONE).traced()).isTrue();
            assertThat(keeper.bring(2, BRIGHTER, Progress.NONE).traced()).isTrue();
            assertThat(keeper.bring(2, FIRST, Progress.NONE).traced()).isFalse();
        }
    }

    @Test
    void diskWithoutRoom_keepsTheFilmsRightAndSaysSo() throws Exception {
        try (LocalKeeper keeper = new LocalKeeper(Options.DEFAULT.withThreads(1), 0, place, 0)) {
            keeper.bring(1, FIRST, Progress.NONE);
            FrameUpdate update = keeper.bring(1, BRIGHTER, Progress.NONE);
            assertThat(update.traced()).isTrue();
            assertExact(update, BRIGHTER);
            assertThat(keeper.film(1)).isEmpty();
            assertThat(keeper.problem()).isPresent();
            assertThat(files("rows")).isEmpty();
        }
    }

    @Test
    void framesNearTheFocus_stayInMemory() throws Exception {
        long each;
        try (LocalKeeper keeper = new LocalKeeper(Options.DEFAULT.withThreads(1), ALL)) {
            keeper.bring(1, FIRST, Progress.NONE);
            each = keeper.bytes().memory();
        }
        try (LocalKeeper keeper = new LocalKeeper(Options.DEFAULT.withThreads(1), 2 * each)) {
            keeper.focus(3);
            for (int frame = 1; frame <= 5; frame++) {
                keeper.bring(frame, FIRST, Progress.NONE);
            }
            assertThat(keeper.bytes().inMemory()).isEqualTo(2);
            assertThat(keeper.bring(3, BRIGHTER, Progress.NONE).traced()).isFalse();
            assertThat(keeper.bring(1, BRIGHTER, Progress.NONE).traced()).isTrue();
        }
    }

    @Test
    void firmKeeperWithoutRoom_refusesWhatComesAndKeepsWhatItHas() throws Exception {
        long each;
        try (LocalKeeper keeper = new LocalKeeper(Options.DEFAULT.withThreads(1), ALL)) {
            keeper.bring(1, FIRST, Progress.NONE);
            each = keeper.bytes().memory();
        }
        // Room that a forecast may take for enough, and room that is none.
        for (long left : new long[] {each - 1, each / 10}) {
            try (LocalKeeper keeper = LocalKeeper.firm(Options.DEFAULT.withThreads(1), each + left, place, 0)) {
                keeper.focus(2);
                keeper.bring(1, FIRST, Progress.NONE);
                assertThatThrownBy(() -> keeper.bring(2, FIRST, Progress.NONE)).isInstanceOf(FrameRefusedException.class)
                        .hasMessageMatching("the frame takes about .* MB, and there is room for .* MB more");
                assertThat(keeper.film(2)).isEmpty();
                assertThat(keeper.bytes()).isEqualTo(new KeptBytes(1, each, 0, 0));
                FrameUpdate relit = keeper.bring(1, BRIGHTER, Progress.NONE);
                assertThat(relit.traced()).isFalse();
                assertExact(relit, BRIGHTER);
                keeper.forget(1);
                assertExact(keeper.bring(2, BRIGHTER, Progress.NONE), BRIGHTER);
            }
        }
    }

    @Test
    void firmKeeper_takesMemoryAndDiskTogether() throws Exception {
        try (LocalKeeper keeper = LocalKeeper.firm(Options.DEFAULT.withThreads(1), 0, place, ALL)) {
            for (int frame = 1; frame <= 3; frame++) {
                keeper.bring(frame, FIRST, Progress.NONE);
            }
            assertThat(keeper.bytes().onDisk()).isEqualTo(3);
        }
    }

    @Test
    void cancelledFrame_isAsBefore() throws Exception {
        try (LocalKeeper keeper = onDisk()) {
            FrameUpdate first = keeper.bring(1, FIRST, Progress.NONE);
            Progress stopped = new Progress() {
                @Override
                public void tiles(int done, int total) {}

                @Override
                public boolean isCancelled() {
                    return true;
                }
            };
            assertThatThrownBy(() -> keeper.bring(1, BRIGHTER, stopped)).isInstanceOf(CancellationException.class);
            assertThat(keeper.film(1).orElseThrow().sameBits(first.film())).isTrue();
            assertThat(keeper.bring(1, BRIGHTER, Progress.NONE).traced()).isFalse();
        }
    }

    @Test
    void shotThatDoesNotFit_isToldWithWhatWould() {
        ShotNeed need = ShotNeed.of(FIRST, 1, 100, Options.DEFAULT);
        assertThatThrownBy(() -> need.check(2 * need.each(), 3 * need.each())).isInstanceOf(ShotTooLarge.class)
                .hasMessageContainingAll("100 frames", "in memory", "on disk; 5 frames would fit, or a size of ");
        need.check(need.all(), 0);
        assertThat(need.inMemory(0)).isZero();
    }
}
