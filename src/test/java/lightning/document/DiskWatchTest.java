package lightning.document;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.attribute.FileTime;
import java.time.Duration;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import lightning.base.file.FileState;
import lightning.base.work.Await;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class DiskWatchTest {
    @TempDir
    private Path folder;

    private final LinkedBlockingQueue<DiskStatus> statuses = new LinkedBlockingQueue<>();
    private Path file;
    private FileState known;
    private DiskWatch watch;

    @BeforeEach
    void watch() throws IOException {
        file = Files.writeString(folder.resolve("desk.jen"), DeskScene.TEXT);
        known = FileState.of(file);
        watch = new DiskWatch(new OpenSceneRegistry(folder.resolve("open")), Duration.ofMillis(5), statuses::add);
        watch.watch(file, known);
    }

    /** Closes the watch first, as its thread creates and deletes a file in the folder. */
    @AfterEach
    void close() throws Exception {
        watch.close();
        Await.untilThreadEnded("lightning-disk");
    }

    private DiskStatus await(Predicate<DiskStatus> condition) throws InterruptedException {
        while (true) {
            DiskStatus news = statuses.poll(Await.TIMEOUT_SECONDS, TimeUnit.SECONDS);
            assertThat(news).as("expected event").isNotNull();
            if (condition.test(news)) {
                return news;
            }
        }
    }

    @Test
    void untouchedFile_isUnchanged() throws InterruptedException {
        DiskStatus first = await(_ -> true);
        assertThat(first.isChanged() || first.isDeleted() || first.isOpenElsewhere()).isFalse();
    }

    @Test
    void externalChanges_areDetected() throws Exception {
        Files.writeString(file, "his");
        FileState his = FileState.of(file);
        assertThat(await(news -> news.current().equals(his)).isChanged()).isTrue();
        Files.writeString(file, "his second");
        FileState second = FileState.of(file);
        assertThat(await(news -> news.current().equals(second)).known()).isEqualTo(known);
    }

    @Test
    void ownSave_isNotAChange() throws Exception {
        Files.writeString(file, "mine");
        FileState mine = FileState.of(file);
        watch.watch(file, mine);
        assertThat(await(news -> news.known().equals(mine)).isChanged()).isFalse();
    }

    @Test
    void touchedFile_isNotChanged() throws Exception {
        await(_ -> true);
        Files.setLastModifiedTime(file, FileTime.fromMillis(1_000_000));
        assertThat(await(news -> news.current().modified().toMillis() == 1_000_000).isChanged()).isFalse();
    }

    @Test
    void deletedFile_isDeletedUntilRestored() throws Exception {
        Files.delete(file);
        await(DiskStatus::isDeleted);
        // Moved into place atomically, as a check during the write would see an incomplete file.
        Files.move(Files.writeString(folder.resolve("again"), DeskScene.TEXT), file, StandardCopyOption.ATOMIC_MOVE);
        assertThat(await(news -> !news.isDeleted()).isChanged()).isFalse();
    }

    @Test
    void secondEditor_isDetectedUntilClosed() throws Exception {
        try (var other = new OpenSceneRegistry(folder.resolve("open"))) {
            other.register(file);
            await(DiskStatus::isOpenElsewhere);
        }
        await(news -> !news.isOpenElsewhere());
    }

    @Test
    void uncreatableFolder_doesNotPreventWatching() throws Exception {
        Path blocked = Files.writeString(folder.resolve("blocked"), "a file");
        var news = new LinkedBlockingQueue<DiskStatus>();
        try (var without = new DiskWatch(new OpenSceneRegistry(blocked), Duration.ofMillis(5), news::add)) {
            without.watch(file, FileState.MISSING);
            assertThat(news.poll(Await.TIMEOUT_SECONDS, TimeUnit.SECONDS)).matches(DiskStatus::isChanged);
        }
    }

    @Test
    void closedWatch_reportsNothingAndRemovesItsFile() throws Exception {
        await(_ -> true);
        watch.close();
        watch.checkNow();
        Await.until(() -> {
            try (var files = Files.list(folder.resolve("open"))) {
                return files.findAny().isEmpty();
            }
        });
    }
}
