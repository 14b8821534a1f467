package lightning.editor.document;

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
import lightning.base.work.Wait;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class DiskWatchTest {
    @TempDir
    private Path folder;

    private final LinkedBlockingQueue<DiskNews> heard = new LinkedBlockingQueue<>();
    private Path file;
    private FileState known;
    private DiskWatch watch;

    @BeforeEach
    void watch() throws IOException {
        file = Files.writeString(folder.resolve("desk.jen"), Desk.TEXT);
        known = FileState.of(file);
        watch = new DiskWatch(new Presence(folder.resolve("open")), Duration.ofMillis(5), heard::add);
        watch.watch(file, known);
    }

    /** The watching thread makes and removes its file in the folder. */
    @AfterEach
    void close() throws Exception {
        watch.close();
        Wait.untilEnded("lightning-disk");
    }

    private DiskNews await(Predicate<DiskNews> what) throws InterruptedException {
        while (true) {
            DiskNews news = heard.poll(Wait.MOST_SECONDS, TimeUnit.SECONDS);
            assertThat(news).as("what is waited for").isNotNull();
            if (what.test(news)) {
                return news;
            }
        }
    }

    @Test
    void untouchedFile_isAsItWas() throws InterruptedException {
        DiskNews first = await(_ -> true);
        assertThat(first.isChanged() || first.isGone() || first.elsewhere()).isFalse();
    }

    @Test
    void anothersText_isSeenAndTheNextToo() throws Exception {
        Files.writeString(file, "his");
        FileState his = FileState.of(file);
        assertThat(await(news -> news.seen().equals(his)).isChanged()).isTrue();
        Files.writeString(file, "his second");
        FileState second = FileState.of(file);
        assertThat(await(news -> news.seen().equals(second)).known()).isEqualTo(known);
    }

    @Test
    void ownText_isNoNews() throws Exception {
        Files.writeString(file, "mine");
        FileState mine = FileState.of(file);
        watch.watch(file, mine);
        assertThat(await(news -> news.known().equals(mine)).isChanged()).isFalse();
    }

    @Test
    void touchedFile_isNotChanged() throws Exception {
        await(_ -> true);
        Files.setLastModifiedTime(file, FileTime.fromMillis(1_000_000));
        assertThat(await(news -> news.seen().modified().toMillis() == 1_000_000).isChanged()).isFalse();
    }

    @Test
    void deletedFile_isGoneUntilItIsBack() throws Exception {
        Files.delete(file);
        await(DiskNews::isGone);
        // Whole at once: a look between the file and its text would see another.
        Files.move(Files.writeString(folder.resolve("again"), Desk.TEXT), file, StandardCopyOption.ATOMIC_MOVE);
        assertThat(await(news -> !news.isGone()).isChanged()).isFalse();
    }

    @Test
    void secondEditor_isSeenToComeAndGo() throws Exception {
        try (var other = new Presence(folder.resolve("open"))) {
            other.open(file);
            await(DiskNews::elsewhere);
        }
        await(news -> !news.elsewhere());
    }

    @Test
    void folderThatCannotBeMade_doesNotKeepTheFileFromBeingWatched() throws Exception {
        Path blocked = Files.writeString(folder.resolve("blocked"), "a file");
        var news = new LinkedBlockingQueue<DiskNews>();
        try (var without = new DiskWatch(new Presence(blocked), Duration.ofMillis(5), news::add)) {
            without.watch(file, FileState.NONE);
            assertThat(news.poll(Wait.MOST_SECONDS, TimeUnit.SECONDS)).matches(DiskNews::isChanged);
        }
    }

    @Test
    void closedWatch_saysNothingMoreAndLeavesNoTrace() throws Exception {
        await(_ -> true);
        watch.close();
        watch.look();
        Wait.until(() -> {
            try (var files = Files.list(folder.resolve("open"))) {
                return files.findAny().isEmpty();
            }
        });
    }
}
