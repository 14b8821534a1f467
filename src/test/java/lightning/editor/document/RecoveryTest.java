package lightning.editor.document;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIOException;

import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import lightning.base.work.Wait;
import lightning.format.jen.JenLimits;
import lightning.sample.Slow;
import lightning.scene.Scene;
import lightning.scene.Texture;
import lightning.scene.TextureMap;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class RecoveryTest {
    /** No process has this number: it is beyond what any system hands out. */
    private static final String CRASHED = "999999999999-1";

    @TempDir
    private Path folder;

    private Path kept() {
        return folder.resolve("kept");
    }

    private OpenDocument edited() throws Exception {
        OpenDocument document = OpenDocument.open(Files.writeString(folder.resolve("desk.jen"), Desk.TEXT));
        document.apply(Desk.dial("intensity").set(document.scene(), "key", 2));
        return document;
    }

    private long filesKept() throws IOException {
        try (Stream<Path> files = Files.list(kept())) {
            return files.count();
        }
    }

    @Test
    void whatACrashedProcessKept_isFoundAsItWas() throws IOException {
        Path file = folder.resolve("a b.jen").toAbsolutePath();
        new Recovery(kept(), CRASHED).keep(file, Desk.TEXT);
        assertThat(new Recovery(kept()).found()).singleElement().satisfies(found -> {
            assertThat(found.file()).isEqualTo(file);
            assertThat(found.text()).isEqualTo(Desk.TEXT);
        });
    }

    @ParameterizedTest
    @ValueSource(strings = {"a\nb.jen", "\n for x.jen", "ü ☂ 100%.jen", "file:a.jen"})
    @DisabledOnOs(OS.WINDOWS)
    void nameOfAnyCharacters_isFoundAsItWas(String name) throws IOException {
        Path file = folder.resolve(name).toAbsolutePath();
        new Recovery(kept(), CRASHED).keep(file, Desk.TEXT);
        assertThat(new Recovery(kept()).found()).singleElement().satisfies(found -> {
            assertThat(found.file()).isEqualTo(file);
            assertThat(found.text()).isEqualTo(Desk.TEXT);
        });
    }

    @Test
    @DisabledOnOs(OS.WINDOWS)
    void whatAnOlderVersionKept_isFound() throws IOException {
        Files.createDirectories(kept());
        Files.writeString(kept().resolve("x.kept.jen"), "# Lightning kept this of process 999999999999-1 for /a b.jen\n" + Desk.TEXT);
        assertThat(new Recovery(kept()).found()).singleElement().satisfies(found -> {
            assertThat(found.file()).isEqualTo(Path.of("/a b.jen"));
            assertThat(found.text()).isEqualTo(Desk.TEXT);
        });
    }

    @Test
    @DisabledOnOs(OS.WINDOWS)
    void whatIsKept_isItsOwnersAlone() throws IOException {
        Files.createDirectories(kept());
        Files.setPosixFilePermissions(kept(), PosixFilePermissions.fromString("rwxr-xr-x"));
        new Recovery(kept(), CRASHED).keep(folder.resolve("a.jen"), Desk.TEXT);
        assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(kept()))).isEqualTo("rwx------");
        Path file = new Recovery(kept()).found().getFirst().kept();
        assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(file))).isEqualTo("rw-------");
    }

    @Test
    void whatALivingProcessKeeps_isItsOwn() throws IOException {
        new Recovery(kept()).keep(folder.resolve("a.jen"), Desk.TEXT);
        assertThat(new Recovery(kept()).found()).isEmpty();
        assertThat(filesKept()).isEqualTo(1);
    }

    @Test
    void sameNumberOfAnOlderProcess_isACrash() throws IOException {
        new Recovery(kept(), ProcessHandle.current().pid() + "-1").keep(folder.resolve("a.jen"), Desk.TEXT);
        assertThat(new Recovery(kept()).found()).hasSize(1);
    }

    @Test
    @Slow
    void textOfTheLargestScene_isFound() throws IOException {
        new Recovery(kept(), CRASHED).keep(folder.resolve("a.jen"), "");
        Path file = new Recovery(kept()).found().getFirst().kept();
        try (var sparse = new RandomAccessFile(file.toFile(), "rw")) {
            sparse.setLength(sparse.length() + JenLimits.FILE_BYTES);
        }
        assertThat(new Recovery(kept()).found()).singleElement()
                .satisfies(found -> assertThat(found.text().length()).isEqualTo(JenLimits.FILE_BYTES));
    }

    @Test
    @Slow
    void textThatNoSceneMayHave_isRefusedBeforeItIsKept() throws IOException {
        var recovery = new Recovery(kept(), CRASHED);
        recovery.keep(folder.resolve("a.jen"), "older");
        String text = "x".repeat(JenLimits.FILE_BYTES + 1);
        assertThatIOException().isThrownBy(() -> recovery.keep(folder.resolve("a.jen"), text))
                .withMessage(folder.resolve("a.jen") + ": the text of a scene may have at most 268435456 bytes, found 268435457");
        assertThat(new Recovery(kept()).found()).extracting(Recovery.Found::text).containsExactly("older");
    }

    @Test
    void keptAgain_replacesTheOlderText() throws IOException {
        var crashed = new Recovery(kept(), CRASHED);
        crashed.keep(folder.resolve("a.jen"), "older");
        crashed.keep(folder.resolve("a.jen"), "newer");
        assertThat(new Recovery(kept()).found()).extracting(Recovery.Found::text).containsExactly("newer");
    }

    @Test
    void forgottenOrDeleted_isNotFoundAgain() throws IOException {
        var crashed = new Recovery(kept(), CRASHED);
        crashed.keep(folder.resolve("a.jen"), "a");
        crashed.keep(folder.resolve("b.jen"), "b");
        crashed.forget(folder.resolve("a.jen"));
        new Recovery(kept()).found().getFirst().delete();
        assertThat(filesKept()).isZero();
    }

    @Test
    void strayFilesAndNoFolder_areNoTrouble() throws IOException {
        assertThat(new Recovery(kept()).found()).isEmpty();
        Files.createDirectories(kept());
        Files.writeString(kept().resolve("x.kept.jen"), "something else");
        Files.write(kept().resolve("y.kept.jen"), new byte[] {(byte) 0xFF});
        Files.createDirectory(kept().resolve("z.kept.jen"));
        for (String path : List.of("file:", "file:relative", "file://host/a.jen", "file:/a%ZZ", "a\0b", "", "http://a")) {
            Files.writeString(kept().resolve(path.hashCode() + ".kept.jen"),
                    "# Lightning kept this of process 999999999999-1 for " + path + "\n");
        }
        assertThat(new Recovery(kept()).found()).isEmpty();
    }

    @Test
    void autosave_keepsTheLatestEditSoonAfterTheFirst() throws Exception {
        OpenDocument document = edited();
        var recovery = new Recovery(kept(), CRASHED);
        try (var autosave = new Autosave(recovery, Duration.ofMillis(20), e -> {})) {
            autosave.changed(document);
            document.apply(Desk.dial("intensity").set(document.scene(), "key", 3));
            autosave.changed(document);
            String latest = document.text(document.content());
            Wait.until(() -> recovery.found().stream().anyMatch(f -> f.text().equals(latest)));
        }
    }

    @Test
    void autosavesDelay_leavesRoomBelowFiveSeconds() {
        assertThat(Autosave.DEFAULT_DELAY).isLessThan(Duration.ofSeconds(4));
    }

    @Test
    void savedDocument_isForgottenUnderItsOldNameToo() throws Exception {
        OpenDocument document = edited();
        var recovery = new Recovery(kept(), CRASHED);
        try (var autosave = new Autosave(recovery, Duration.ZERO, e -> {})) {
            autosave.changed(document);
            Wait.until(() -> !recovery.found().isEmpty());
            Saves.saveAs(document, folder.resolve("other.jen"));
            autosave.changed(document);
            Wait.until(() -> recovery.found().isEmpty());
        }
    }

    @Test
    void folderThatCannotBeMade_isToldOnce() throws Exception {
        OpenDocument document = edited();
        Path blocked = Files.writeString(folder.resolve("blocked"), "a file");
        var troubles = new LinkedBlockingQueue<Throwable>();
        var told = new CountDownLatch(1);
        try (var autosave = new Autosave(new Recovery(blocked), Duration.ZERO, e -> {
            troubles.add(e);
            told.countDown();
        })) {
            autosave.changed(document);
            assertThat(told.await(Wait.MOST_SECONDS, TimeUnit.SECONDS)).isTrue();
        }
        assertThat(troubles).hasSize(1);
    }

    @Test
    void errorOfAnyKind_isToldAndTheNextEditIsKept() throws Exception {
        OpenDocument document = edited();
        var troubles = new LinkedBlockingQueue<Throwable>();
        var recovery = new Recovery(kept(), CRASHED);
        try (var autosave = new Autosave(recovery, Duration.ZERO, troubles::add)) {
            // A scene that no text can say: files cannot name its texture.
            Scene scene = document.scene();
            var texture = new TextureMap("a\nb.png", 1, 1, new Texture(1, 1, new float[3]));
            document.apply(new Change.To(scene.withMaterial(scene.materials().getFirst().withTexture(Optional.of(texture)))));
            autosave.changed(document);
            assertThat(troubles.poll(Wait.MOST_SECONDS, TimeUnit.SECONDS)).isInstanceOf(RuntimeException.class);
            document.history().undo();
            autosave.changed(document);
            Wait.until(() -> !recovery.found().isEmpty());
        }
    }
}
