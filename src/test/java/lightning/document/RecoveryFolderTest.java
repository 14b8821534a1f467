package lightning.document;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIOException;

import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import lightning.base.file.FileState;
import lightning.base.work.Await;
import lightning.format.jen.asset.JenLimits;
import lightning.sample.Slow;
import lightning.scene.Scene;
import lightning.scene.asset.Texture;
import lightning.scene.asset.TextureMap;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class RecoveryFolderTest {
    /** Process id beyond the range of any system. */
    private static final String CRASHED = "999999999999-1";

    @TempDir
    private Path folder;

    private Path recoveryFile() {
        return folder.resolve("kept");
    }

    private OpenDocument editedDocument() throws Exception {
        OpenDocument document = OpenDocument.open(Files.writeString(folder.resolve("desk.jen"), DeskScene.TEXT));
        document.apply(DeskScene.parameter("intensity").set(document.scene(), "key", 2));
        return document;
    }

    private long fileCount() throws IOException {
        try (Stream<Path> files = Files.list(recoveryFile())) {
            return files.count();
        }
    }

    @Test
    void textOfCrashedProcess_isListedUnchanged() throws IOException {
        Path file = folder.resolve("a b.jen").toAbsolutePath();
        new RecoveryFolder(recoveryFile(), CRASHED).store(file, FileState.MISSING, DeskScene.TEXT);
        assertThat(new RecoveryFolder(recoveryFile()).list()).singleElement().satisfies(found -> {
            assertThat(found.file()).isEqualTo(file);
            assertThat(found.text()).isEqualTo(DeskScene.TEXT);
        });
    }

    @ParameterizedTest
    @ValueSource(strings = {"a\nb.jen", "\n for x.jen", "ü ☂ 100%.jen", "file:a.jen"})
    @DisabledOnOs(OS.WINDOWS)
    void anyFileName_isListedUnchanged(String name) throws IOException {
        Path file = folder.resolve(name).toAbsolutePath();
        new RecoveryFolder(recoveryFile(), CRASHED).store(file, FileState.MISSING, DeskScene.TEXT);
        assertThat(new RecoveryFolder(recoveryFile()).list()).singleElement().satisfies(found -> {
            assertThat(found.file()).isEqualTo(file);
            assertThat(found.text()).isEqualTo(DeskScene.TEXT);
        });
    }

    @Test
    @DisabledOnOs(OS.WINDOWS)
    void fileOfOlderVersion_isListed() throws IOException {
        Files.createDirectories(recoveryFile());
        Files.writeString(recoveryFile().resolve("x.kept.jen"),
                "# Lightning kept this of process 999999999999-1 for /a b.jen\n" + DeskScene.TEXT);
        assertThat(new RecoveryFolder(recoveryFile()).list()).singleElement().satisfies(found -> {
            assertThat(found.file()).isEqualTo(Path.of("/a b.jen"));
            assertThat(found.text()).isEqualTo(DeskScene.TEXT);
        });
    }

    @Test
    @DisabledOnOs(OS.WINDOWS)
    void storedFile_isPrivateToOwner() throws IOException {
        Files.createDirectories(recoveryFile());
        Files.setPosixFilePermissions(recoveryFile(), PosixFilePermissions.fromString("rwxr-xr-x"));
        new RecoveryFolder(recoveryFile(), CRASHED).store(folder.resolve("a.jen"), FileState.MISSING, DeskScene.TEXT);
        assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(recoveryFile()))).isEqualTo("rwx------");
        Path file = new RecoveryFolder(recoveryFile()).list().getFirst().recoveryFile();
        assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(file))).isEqualTo("rw-------");
    }

    @Test
    void changeOfTheSceneFile_isListed() throws IOException {
        Path file = Files.writeString(folder.resolve("a.jen"), "jen 1");
        new RecoveryFolder(recoveryFile(), CRASHED).store(file, FileState.of(file), DeskScene.TEXT);
        assertThat(new RecoveryFolder(recoveryFile()).list().getFirst().disk().isChanged()).isFalse();
        Files.writeString(file, "jen 1\n");
        assertThat(new RecoveryFolder(recoveryFile()).list().getFirst().disk().isChanged()).isTrue();
        Files.delete(file);
        assertThat(new RecoveryFolder(recoveryFile()).list().getFirst().disk().isDeleted()).isTrue();
    }

    @Test
    void adoptedFile_keepsTimeAndStateOfTheCrashedProcess() throws IOException {
        Path file = Files.writeString(folder.resolve("a.jen"), "jen 1");
        new RecoveryFolder(recoveryFile(), CRASHED).store(file, FileState.of(file), DeskScene.TEXT);
        Instant time = Instant.parse("2001-02-03T04:05:06Z");
        Files.setLastModifiedTime(new RecoveryFolder(recoveryFile()).list().getFirst().recoveryFile(), FileTime.from(time));
        Files.writeString(file, "jen 1\n");
        new RecoveryFolder(recoveryFile(), "999999999998-1").adopt(new RecoveryFolder(recoveryFile()).list().getFirst());
        assertThat(new RecoveryFolder(recoveryFile()).list()).singleElement().satisfies(found -> {
            assertThat(found.time()).isEqualTo(time);
            assertThat(found.disk().isChanged()).isTrue();
        });
    }

    /** Older versions stored no state of the scene file. */
    @ParameterizedTest
    @CsvSource({"2001-02-03T04:05:07Z, true", "2001-02-03T04:05:05Z, false"})
    void fileOfOlderVersion_isChangedIfTheSceneFileIsNewer(String modified, boolean changed) throws IOException {
        Path file = Files.writeString(folder.resolve("a.jen"), "jen 1");
        Files.createDirectories(recoveryFile());
        Path recovery = Files.writeString(recoveryFile().resolve("x.kept.jen"),
                "# Lightning kept this of process 999999999999-1 for " + file.toUri() + "\n" + DeskScene.TEXT);
        Files.setLastModifiedTime(recovery, FileTime.from(Instant.parse("2001-02-03T04:05:06Z")));
        Files.setLastModifiedTime(file, FileTime.from(Instant.parse(modified)));
        assertThat(new RecoveryFolder(recoveryFile()).list().getFirst().disk().isChanged()).isEqualTo(changed);
    }

    @Test
    void looksOfCrashedProcess_areAdopted_andDeletedWithTheFile() throws IOException {
        Path file = folder.resolve("untitled.jen").toAbsolutePath();
        var crashed = new RecoveryFolder(recoveryFile(), CRASHED);
        crashed.store(file, FileState.MISSING, DeskScene.TEXT);
        Files.createDirectories(crashed.looksFolder(file));
        Files.writeString(crashed.looksFolder(file).resolve("day.jen"), "jen 1");
        var recovery = new RecoveryFolder(recoveryFile());
        recovery.adopt(recovery.list().getFirst());
        assertThat(recovery.looksFolder(file).resolve("day.jen")).hasContent("jen 1");
        assertThat(crashed.looksFolder(file)).doesNotExist();
        recovery.delete(file);
        assertThat(recovery.looksFolder(file)).doesNotExist();
    }

    @Test
    void fileOfRunningProcess_isNotListed() throws IOException {
        new RecoveryFolder(recoveryFile()).store(folder.resolve("a.jen"), FileState.MISSING, DeskScene.TEXT);
        assertThat(new RecoveryFolder(recoveryFile()).list()).isEmpty();
        assertThat(fileCount()).isEqualTo(1);
    }

    @Test
    void reusedProcessId_isACrash() throws IOException {
        new RecoveryFolder(recoveryFile(), ProcessHandle.current().pid() + "-1").store(folder.resolve("a.jen"), FileState.MISSING,
                DeskScene.TEXT);
        assertThat(new RecoveryFolder(recoveryFile()).list()).hasSize(1);
    }

    @Test
    @Slow
    void largestText_isListed() throws IOException {
        new RecoveryFolder(recoveryFile(), CRASHED).store(folder.resolve("a.jen"), FileState.MISSING, "");
        Path file = new RecoveryFolder(recoveryFile()).list().getFirst().recoveryFile();
        try (var sparse = new RandomAccessFile(file.toFile(), "rw")) {
            sparse.setLength(sparse.length() + JenLimits.FILE_BYTES);
        }
        assertThat(new RecoveryFolder(recoveryFile()).list()).singleElement()
                .satisfies(found -> assertThat(found.text().length()).isEqualTo(JenLimits.FILE_BYTES));
    }

    @Test
    @Slow
    void tooLargeText_isRejected() throws IOException {
        var recovery = new RecoveryFolder(recoveryFile(), CRASHED);
        recovery.store(folder.resolve("a.jen"), FileState.MISSING, "older");
        String text = "x".repeat(JenLimits.FILE_BYTES + 1);
        assertThatIOException().isThrownBy(() -> recovery.store(folder.resolve("a.jen"), FileState.MISSING, text))
                .withMessage(folder.resolve("a.jen") + ": expected at most 268435456 bytes of scene text, found 268435457");
        assertThat(new RecoveryFolder(recoveryFile()).list()).extracting(RecoveryFolder.RecoverableScene::text).containsExactly("older");
    }

    @Test
    void storeAgain_replacesOlderText() throws IOException {
        var crashed = new RecoveryFolder(recoveryFile(), CRASHED);
        crashed.store(folder.resolve("a.jen"), FileState.MISSING, "older");
        crashed.store(folder.resolve("a.jen"), FileState.MISSING, "newer");
        assertThat(new RecoveryFolder(recoveryFile()).list()).extracting(RecoveryFolder.RecoverableScene::text).containsExactly("newer");
    }

    @Test
    void deletedFile_isNotListed() throws IOException {
        var crashed = new RecoveryFolder(recoveryFile(), CRASHED);
        crashed.store(folder.resolve("a.jen"), FileState.MISSING, "a");
        crashed.store(folder.resolve("b.jen"), FileState.MISSING, "b");
        crashed.delete(folder.resolve("a.jen"));
        new RecoveryFolder(recoveryFile()).list().getFirst().delete();
        assertThat(fileCount()).isZero();
    }

    @Test
    void strayFilesAndMissingFolder_areIgnored() throws IOException {
        assertThat(new RecoveryFolder(recoveryFile()).list()).isEmpty();
        Files.createDirectories(recoveryFile());
        Files.writeString(recoveryFile().resolve("x.kept.jen"), "something else");
        Files.write(recoveryFile().resolve("y.kept.jen"), new byte[] {(byte) 0xFF});
        Files.createDirectory(recoveryFile().resolve("z.kept.jen"));
        for (String path : List.of("file:", "file:relative", "file://host/a.jen", "file:/a%ZZ", "a\0b", "", "http://a")) {
            Files.writeString(recoveryFile().resolve(path.hashCode() + ".kept.jen"),
                    "# Lightning kept this of process 999999999999-1 for " + path + "\n");
        }
        assertThat(new RecoveryFolder(recoveryFile()).list()).isEmpty();
    }

    @Test
    void autosave_storesLatestEditSoonAfterFirst() throws Exception {
        OpenDocument document = editedDocument();
        var recovery = new RecoveryFolder(recoveryFile(), CRASHED);
        try (var autosave = new Autosave(recovery, Duration.ofMillis(20), e -> {})) {
            autosave.documentChanged(document);
            document.apply(DeskScene.parameter("intensity").set(document.scene(), "key", 3));
            autosave.documentChanged(document);
            String latest = document.text(document.content());
            Await.until(() -> recovery.list().stream().anyMatch(f -> f.text().equals(latest)));
        }
    }

    @Test
    void autosaveDelay_isWellBelowFiveSeconds() {
        assertThat(Autosave.DEFAULT_DELAY).isLessThan(Duration.ofSeconds(4));
    }

    @Test
    void savedDocument_isDeletedUnderOldName() throws Exception {
        OpenDocument document = editedDocument();
        var recovery = new RecoveryFolder(recoveryFile(), CRASHED);
        try (var autosave = new Autosave(recovery, Duration.ZERO, e -> {})) {
            autosave.documentChanged(document);
            Await.until(() -> !recovery.list().isEmpty());
            TestSaves.saveAs(document, folder.resolve("other.jen"));
            autosave.documentChanged(document);
            Await.until(() -> recovery.list().isEmpty());
        }
    }

    @Test
    void uncreatableFolder_isReportedOnce() throws Exception {
        OpenDocument document = editedDocument();
        Path blocked = Files.writeString(folder.resolve("blocked"), "a file");
        var troubles = new LinkedBlockingQueue<Throwable>();
        var told = new CountDownLatch(1);
        try (var autosave = new Autosave(new RecoveryFolder(blocked), Duration.ZERO, e -> {
            troubles.add(e);
            told.countDown();
        })) {
            autosave.documentChanged(document);
            assertThat(told.await(Await.TIMEOUT_SECONDS, TimeUnit.SECONDS)).isTrue();
        }
        assertThat(troubles).hasSize(1);
    }

    @Test
    void anyError_isReportedAndNextEditIsStored() throws Exception {
        OpenDocument document = editedDocument();
        var troubles = new LinkedBlockingQueue<Throwable>();
        var recovery = new RecoveryFolder(recoveryFile(), CRASHED);
        try (var autosave = new Autosave(recovery, Duration.ZERO, troubles::add)) {
            // A scene that cannot be written: its texture has no valid file name.
            Scene scene = document.scene();
            var texture = new TextureMap("a\nb.png", 1, 1, new Texture(1, 1, new float[3]));
            document.apply(new EditOutcome.Applied(scene.withMaterial(scene.materials().getFirst().withTexture(Optional.of(texture)))));
            autosave.documentChanged(document);
            assertThat(troubles.poll(Await.TIMEOUT_SECONDS, TimeUnit.SECONDS)).isInstanceOf(RuntimeException.class);
            document.history().undo();
            autosave.documentChanged(document);
            Await.until(() -> !recovery.list().isEmpty());
        }
    }
}
