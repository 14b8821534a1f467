package lightning.base.file;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatIOException;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assumptions.assumeThatCode;

import java.io.IOException;
import java.net.StandardProtocolFamily;
import java.net.UnixDomainSocketAddress;
import java.nio.channels.ServerSocketChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import lightning.base.text.PrintableText;
import lightning.base.text.Quote;
import lightning.sample.Slow;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** Checks of modes apply to systems with POSIX permissions. */
@DisabledOnOs(OS.WINDOWS)
class AtomicFileTest {
    @TempDir
    Path folder;

    @Test
    void unprintableName_isEscapedInErrors() throws IOException {
        Path directory = Files.createDirectory(folder.resolve("a\n\u001B[2J"));
        assertThatThrownBy(() -> AtomicFile.of(directory).check()).hasMessage(Quote.path(directory) + ": expected a file, found a folder");
        assertThatThrownBy(() -> AtomicFile.of(directory.resolve("no/b.jen")).check()).hasMessageStartingWith("\"")
                .satisfies(e -> assertThat(e.getMessage()).matches(PrintableText::isPrintable, "is visible"));
    }

    @Test
    void newFile_holdsTheContent() throws IOException {
        AtomicFile.write(folder.resolve("a"), out -> out.write(new byte[] {1, 2, 3}));
        assertThat(folder.resolve("a")).hasBinaryContent(new byte[] {1, 2, 3});
        assertThat(names()).containsExactly("a");
    }

    @Test
    void closedStream_isAccepted() throws IOException {
        AtomicFile.write(folder.resolve("a"), out -> {
            out.write(7);
            out.close();
        });
        assertThat(folder.resolve("a")).hasBinaryContent(new byte[] {7});
    }

    @Test
    void failedWrite_leavesOnlyTheOldFile() throws IOException {
        Path file = Files.writeString(folder.resolve("a"), "old");
        assertThatThrownBy(() -> AtomicFile.write(file, out -> {
            out.write(new byte[100_000]);
            throw new IOException("disk full");
        })).isInstanceOf(IOException.class).hasMessage("disk full");
        assertThat(file).hasContent("old");
        assertThat(names()).containsExactly("a");
    }

    @Test
    void replacedFile_keepsOldContentUntilComplete() throws IOException {
        Path file = Files.writeString(folder.resolve("a"), "old");
        AtomicFile.write(file, out -> {
            out.write(new byte[100_000]);
            assertThat(file).hasContent("old");
        });
        assertThat(file).hasSize(100_000);
    }

    @Test
    void replacedFile_keepsItsPermissions() throws IOException {
        Path file = Files.writeString(folder.resolve("a"), "old");
        setMode(file, "rw-r-----");
        AtomicFile.write(file, out -> out.write(1));
        assertThat(mode(file)).isEqualTo("rw-r-----");
    }

    @Test
    void symbolicLink_isPreserved() throws IOException {
        Path file = Files.writeString(folder.resolve("a"), "old");
        Path link = Files.createSymbolicLink(folder.resolve("b"), file);
        AtomicFile.write(link, out -> out.write('x'));
        assertThat(link).isSymbolicLink();
        assertThat(file).hasContent("x");
    }

    @Test
    void folder_isRejected() {
        assertThatThrownBy(() -> AtomicFile.write(folder, out -> {})).isInstanceOf(IOException.class)
                .hasMessageContaining("expected a file, found a folder");
    }

    @Test
    void linkToMissingFile_isPreserved() throws IOException {
        Path link = Files.createSymbolicLink(folder.resolve("b"), Path.of("a"));
        AtomicFile.write(link, out -> out.write('x'));
        assertThat(link).isSymbolicLink();
        assertThat(folder.resolve("a")).hasContent("x");
    }

    @Test
    void circularLink_isRejected() throws IOException {
        Path link = Files.createSymbolicLink(folder.resolve("b"), Path.of("b"));
        assertThatIOException().isThrownBy(() -> AtomicFile.write(link, out -> {}))
                .withMessage(link + ": circular symbolic link");
    }

    @Test
    void irregularFile_isRejectedUnchanged() throws IOException {
        // A socket represents all special files: a real device would be lost if this failed for an administrator.
        Path socket = folder.resolve("s");
        Path link = Files.createSymbolicLink(folder.resolve("b"), socket);
        try (var server = ServerSocketChannel.open(StandardProtocolFamily.UNIX)) {
            server.bind(UnixDomainSocketAddress.of(socket));
            assertThatIOException().isThrownBy(() -> AtomicFile.write(link, out -> {}))
                    .withMessage(link + ": expected a file, found a device, a pipe or a socket");
            assertThatIOException().isThrownBy(() -> AtomicFile.of(socket).check());
            assertThat(Files.isRegularFile(socket)).isFalse();
            assertThat(link).isSymbolicLink();
        }
    }

    @Test
    void missingFolder_isNamedInError() {
        Path file = folder.resolve("no/a");
        assertThatIOException().isThrownBy(() -> AtomicFile.write(file, out -> {}))
                .withMessage(file + ": folder not found: " + folder.resolve("no"));
    }

    @Test
    void readOnlyFile_isReplacedOnlyIfAllowed() throws IOException {
        Path file = Files.writeString(folder.resolve("a"), "old");
        setMode(file, "r--r-----");
        assertThatExceptionOfType(ReadOnlyFileException.class).isThrownBy(() -> AtomicFile.of(file).check());
        assertThatExceptionOfType(ReadOnlyFileException.class).isThrownBy(() -> AtomicFile.write(file, out -> out.write('x')))
                .withMessage(file + ": is read-only; allow writing it, or choose another name");
        assertThat(file).hasContent("old");
        AtomicFile.of(file).allowReadOnly().write(out -> out.write('x'));
        assertThat(file).hasContent("x");
        assertThat(mode(file)).isEqualTo("r--r-----");
    }

    @Test
    void newFile_hasDefaultMode() throws IOException {
        Path other = Files.createFile(folder.resolve("other"));
        AtomicFile.write(folder.resolve("a"), out -> out.write(1));
        assertThat(mode(folder.resolve("a"))).isEqualTo(mode(other));
        assertThat(names()).containsExactlyInAnyOrder("a", "other");
    }

    @Test
    void foreignOwnerAndGroup_arePreserved() throws IOException {
        Path file = Files.writeString(folder.resolve("a"), "old");
        assumeThatCode(() -> {
            Files.setAttribute(file, "unix:gid", 1);
            Files.setAttribute(file, "unix:uid", 1);
        }).as("only an administrator gives files away").doesNotThrowAnyException();
        AtomicFile.write(file, out -> out.write('x'));
        assertThat(Files.getAttribute(file, "unix:gid")).isEqualTo(1);
        assertThat(Files.getAttribute(file, "unix:uid")).isEqualTo(1);
    }

    @Test
    void fileBeingWritten_isPrivate() throws IOException {
        Path file = Files.writeString(folder.resolve("a"), "old");
        setMode(file, "rw-rw-rw-");
        AtomicFile.write(file, out -> {
            out.write(new byte[100_000]);
            assertThat(names()).hasSize(2);
            assertThat(mode(folder.resolve(temporary()))).isEqualTo("rw-------");
        });
        assertThat(mode(file)).isEqualTo("rw-rw-rw-");
    }

    @Test
    void ownerOnlyFile_isPrivate() throws IOException {
        Path file = Files.writeString(folder.resolve("a"), "old");
        setMode(file, "rw-r--r--");
        AtomicFile.of(file).forOwnerOnly().write(out -> out.write('x'));
        assertThat(mode(file)).isEqualTo("rw-------");
    }

    @Test
    void longestAllowedName_canBeWritten() throws IOException {
        Path file = folder.resolve("x".repeat(255));
        AtomicFile.write(file, out -> out.write('x'));
        assertThat(file).hasContent("x");
    }

    @Test
    void tooLongName_isReportedUnchanged() throws IOException {
        Path file = folder.resolve("x".repeat(256));
        assertThatExceptionOfType(FileSystemException.class).isThrownBy(() -> AtomicFile.write(file, out -> {}))
                .satisfies(e -> assertThat(e.getFile()).isEqualTo(file.toString()))
                .satisfies(e -> assertThat(e.getReason()).isNotBlank())
                .withMessageNotContaining(".tmp");
        assertThat(names()).isEmpty();
    }

    @Test
    void expectedContent_isReplaced() throws IOException {
        Path file = Files.writeString(folder.resolve("a"), "old");
        FileState state = AtomicFile.of(file).ifUnchanged(FileState.of(file)).write(new byte[] {1});
        assertThat(state).isEqualTo(FileState.of(file));
        AtomicFile.of(file).ifUnchanged(state).write(new byte[] {2});
        assertThat(file).hasBinaryContent(new byte[] {2});
    }

    @Test
    void unexpectedContent_isNotReplaced() throws IOException {
        Path file = Files.writeString(folder.resolve("a"), "old");
        FileState state = FileState.of(file);
        Files.writeString(file, "his");
        // As if written within the clock's resolution, or by a program that preserves times.
        Files.setLastModifiedTime(file, state.modified());
        assertThatExceptionOfType(ChangedFileException.class)
                .isThrownBy(() -> AtomicFile.of(file).ifUnchanged(state).write(new byte[] {1}))
                .withMessageStartingWith(file + ": was changed by another program");
        assertThat(file).hasContent("his");
        assertThat(names()).containsExactly("a");
    }

    @Test
    void contentChangedDuringWrite_isNotReplaced() throws IOException {
        Path file = folder.resolve("a");
        assertThatExceptionOfType(ChangedFileException.class)
                .isThrownBy(() -> AtomicFile.of(file).ifUnchanged(FileState.MISSING).write(_ -> Files.writeString(file, "his")));
        assertThat(file).hasContent("his");
    }

    @Test
    void savesOfTwoThreads_replaceTheSameStateOnce() throws Exception {
        Path file = folder.resolve("a");
        try (ExecutorService threads = Executors.newFixedThreadPool(2)) {
            for (int pair = 0; pair < 200; pair++) {
                FileState state = FileState.of(Files.writeString(file, "state " + pair));
                List<Future<Boolean>> saves =
                        List.of(threads.submit(() -> saves(file, state, "a")), threads.submit(() -> saves(file, state, "b")));
                assertThat(saves.get(0).get()).isNotEqualTo(saves.get(1).get());
                assertThat(file).hasContent(saves.get(0).get() ? "a" : "b");
            }
        }
        assertThat(names()).containsExactly("a");
    }

    private static boolean saves(Path file, FileState state, String text) throws IOException {
        try {
            AtomicFile.of(file).ifUnchanged(state).write(text.getBytes(StandardCharsets.UTF_8));
            return true;
        } catch (ChangedFileException e) {
            return false;
        }
    }

    /** Each process says which of the states it replaced. */
    @Slow
    @Test
    void savesOfTwoProcesses_replaceTheSameStateOnce() throws Exception {
        Path file = folder.resolve("a");
        try (SavingProcess first = new SavingProcess(file); SavingProcess second = new SavingProcess(file)) {
            for (int pair = 0; pair < 200; pair++) {
                Files.writeString(file, "state " + pair);
                first.prepare();
                second.prepare();
                first.save(pair + " a");
                second.save(pair + " b");
                boolean isFirst = first.hasSaved();
                assertThat(second.hasSaved()).isNotEqualTo(isFirst);
                assertThat(file).hasContent(pair + (isFirst ? " a" : " b"));
            }
        }
        assertThat(names()).containsExactly("a");
    }

    /** A process that was killed while it replaced a file leaves its lock file. */
    @Test
    void leftLockFile_isUsedAgain() throws IOException {
        Path file = Files.writeString(folder.resolve("a"), "old");
        Files.createFile(folder.resolve(".lightning-replace.lock"));
        AtomicFile.of(file).ifUnchanged(FileState.of(file)).write(new byte[] {1});
        assertThat(names()).containsExactly("a");
    }

    @Test
    void touchedFile_isUnchanged() throws IOException {
        Path file = Files.writeString(folder.resolve("a"), "old");
        FileState state = FileState.of(file);
        Files.setLastModifiedTime(file, FileTime.fromMillis(1_000_000));
        AtomicFile.of(file).ifUnchanged(state).write(new byte[] {1});
        assertThat(file).hasBinaryContent(new byte[] {1});
    }

    @Test
    void deletedFile_isWrittenAgain() throws IOException {
        Path file = Files.writeString(folder.resolve("a"), "old");
        FileState state = FileState.of(file);
        Files.delete(file);
        AtomicFile.of(file).ifUnchanged(state).write(new byte[] {1});
        assertThat(file).hasBinaryContent(new byte[] {1});
    }

    @Test
    void foreignTemporaryFiles_areNotRemoved() throws IOException {
        List<Path> others = List.of(
                oldFile(".lightning-notes.tmp", Duration.ofDays(99)),
                oldFile(".lightning-00000000-0000-4000-8000-000000000001.tmp.jen", Duration.ofDays(99)),
                oldFile("my.lightning-00000000-0000-4000-8000-000000000001.tmp", Duration.ofDays(99)),
                oldFile(".bird.jen.00000000-0000-4000-8000-000000000001.tmp", Duration.ofDays(99)));
        Path inFolder = Files.createDirectory(folder.resolve(".lightning-00000000-0000-4000-8000-000000000003.tmp"));
        Files.setLastModifiedTime(inFolder, FileTime.fromMillis(0));
        AtomicFile.write(folder.resolve("a"), out -> out.write(1));
        assertThat(others).allSatisfy(file -> assertThat(file).exists());
        assertThat(inFolder).exists();
    }

    @Test
    void privateFolder_isOwnerOnly() throws IOException {
        Path created = folder.resolve("x/y");
        PrivateFolder.create(created);
        assertThat(mode(created)).isEqualTo("rwx------");
        assertThat(mode(created.getParent())).isEqualTo("rwx------");
        setMode(created, "rwxr-xr-x");
        PrivateFolder.create(created);
        assertThat(mode(created)).isEqualTo("rwxr-xr-x");
        PrivateFolder.restrict(created);
        assertThat(mode(created)).isEqualTo("rwx------");
    }

    private Path oldFile(String name, Duration ago) throws IOException {
        Path file = Files.writeString(folder.resolve(name), "half");
        return Files.setLastModifiedTime(file, FileTime.from(Instant.now().minus(ago)));
    }

    private static String mode(Path file) throws IOException {
        return PosixFilePermissions.toString(Files.getPosixFilePermissions(file));
    }

    private static void setMode(Path file, String mode) throws IOException {
        Files.setPosixFilePermissions(file, PosixFilePermissions.fromString(mode));
    }

    /** No file can be created there, although the folder looks writable. */
    @Test
    @EnabledOnOs(OS.LINUX)
    void newFileInAFolderThatRefusesFiles_isNamedInTheMessage() {
        Path file = Path.of("/proc/scene.jen");
        assertThatIOException().isThrownBy(() -> AtomicFile.of(file).write(new byte[1])).satisfies(
                e -> assertThat(FileErrorMessage.of(e)).startsWith("/proc/scene.jen: ").doesNotContain(".tmp"));
    }

    /** Returns the name of the temporary file being written. */
    private String temporary() throws IOException {
        return names().stream().filter(name -> name.startsWith(".")).findFirst().orElseThrow();
    }

    private List<String> names() throws IOException {
        try (var files = Files.list(folder)) {
            return files.map(p -> p.getFileName().toString()).toList();
        }
    }
}
