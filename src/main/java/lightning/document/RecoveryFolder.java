package lightning.document;

import java.io.IOException;
import java.io.InputStream;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemNotFoundException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import lightning.base.file.AtomicFile;
import lightning.base.file.FileState;
import lightning.base.file.PrivateFolder;
import lightning.base.file.ProcessIdentity;
import lightning.base.file.TemporaryFolder;
import lightning.base.text.Messages;
import lightning.base.text.Quote;
import lightning.format.jen.asset.JenLimits;

/**
 * Crash recovery folder with one file per open document: a header line with the process, the scene's path and the state of the scene file
 * that was edited, followed by the scene text. Only the owner can read the files.
 *
 * <p>A file of a process that has ended is left from a crash.
 */
public final class RecoveryFolder {
    private static final String HEADER = "# Lightning kept this of process ";
    private static final String FILE_SEPARATOR = " for ";
    private static final String STATE_SEPARATOR = " over ";
    private static final String EXTENSION = ".kept.jen";
    /** Exceeds the header of any path. */
    private static final int MAX_HEADER_BYTES = 1 << 16;

    private final Path folder;
    private final String process;

    /** @param folder folder, created when the first scene is stored */
    public RecoveryFolder(Path folder) {
        this(folder, ProcessIdentity.current().toString());
    }

    public RecoveryFolder(Path folder, String process) {
        this.folder = folder;
        this.process = process;
    }

    /**
     * Unsaved scene of a crashed process.
     *
     * @param recoveryFile file in the recovery folder
     * @param text         unsaved content of the scene file
     * @param time         time of the last edit
     * @param disk         scene file, absolute, with its state when it was last read or written by that process, and its state now
     */
    public record RecoverableScene(Path recoveryFile, String text, Instant time, DiskStatus disk) {
        /** Returns the scene file. */
        public Path file() {
            return disk.file();
        }

        /** Returns whether the scene is new and has no file yet. */
        public boolean isNew() {
            return NewScene.isPlaceholder(file());
        }

        /** Deletes the recovery file and the looks. */
        public void delete() throws IOException {
            Files.deleteIfExists(recoveryFile);
            deleteIfExists(looksFolder());
        }

        /** Returns the folder with the looks of a scene without a file; it may not exist. */
        Path looksFolder() {
            return looksFolderOf(recoveryFile);
        }
    }

    /**
     * Stores the text of a scene, replacing an older one for the same file.
     *
     * @param known state of the scene file when it was last read or written
     * @throws IOException if it cannot be written, or exceeds {@link JenLimits#FILE_BYTES} bytes; the older one is then unchanged
     */
    public void store(Path file, FileState known, String text) throws IOException {
        PrivateFolder.restrict(folder);
        byte[] header = (HEADER + process + FILE_SEPARATOR + file.toAbsolutePath().toUri() + STATE_SEPARATOR + known.toText() + "\n")
                .getBytes(StandardCharsets.UTF_8);
        byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
        if (bytes.length > JenLimits.FILE_BYTES) {
            throw new IOException(Quote.path(file) + ": "
                    + Messages.tr("expected at most {0} bytes of scene text, found {1}", JenLimits.FILE_BYTES, bytes.length));
        }
        AtomicFile.of(recoveryFile(file)).forOwnerOnly().write((AtomicFile.Content) out -> {
            out.write(header);
            out.write(bytes);
        });
    }

    /** Deletes this process's recovery file of a scene that was saved or closed on purpose, and its looks. */
    public void delete(Path file) throws IOException {
        Files.deleteIfExists(recoveryFile(file));
        deleteIfExists(looksFolder(file));
    }

    /** Adopts the recovery file of a crashed process, and its looks. The file exists at every moment and no other process finds it. */
    public void adopt(RecoverableScene recoverable) throws IOException {
        store(recoverable.file(), recoverable.disk().known(), recoverable.text());
        Files.setLastModifiedTime(recoveryFile(recoverable.file()), FileTime.from(recoverable.time()));
        if (Files.exists(recoverable.looksFolder())) {
            deleteIfExists(looksFolder(recoverable.file()));
            Files.move(recoverable.looksFolder(), looksFolder(recoverable.file()));
        }
        recoverable.delete();
    }

    private static void deleteIfExists(Path looks) throws IOException {
        if (Files.exists(looks)) {
            TemporaryFolder.delete(looks);
        }
    }

    /** Returns this process's folder for the looks of a scene without a file; it may not exist. */
    public Path looksFolder(Path file) {
        return looksFolderOf(recoveryFile(file));
    }

    private static Path looksFolderOf(Path recoveryFile) {
        String name = recoveryFile.getFileName().toString();
        return recoveryFile.resolveSibling(name.substring(0, name.length() - EXTENSION.length()) + ".looks");
    }

    /** Returns the scenes of crashed processes, newest first. Skips unreadable files. */
    public List<RecoverableScene> list() throws IOException {
        List<RecoverableScene> scenes = new ArrayList<>();
        if (Files.isDirectory(folder)) {
            try (Stream<Path> files = Files.list(folder)) {
                for (Path recoveryFile : files.filter(RecoveryFolder::isRecoveryFile).toList()) {
                    read(recoveryFile).ifPresent(scenes::add);
                }
            }
        }
        scenes.sort(Comparator.comparing(RecoverableScene::time).reversed());
        return scenes;
    }

    /** Reads the header first, as the text may be large. */
    private Optional<RecoverableScene> read(Path recoveryFile) {
        try {
            String header = readHeader(recoveryFile);
            int separator = header.indexOf(FILE_SEPARATOR, HEADER.length());
            if (!header.startsWith(HEADER) || separator < 0) {
                return Optional.empty();
            }
            String written = header.substring(separator + FILE_SEPARATOR.length());
            Path file = path(written);
            boolean hasNoName = !file.isAbsolute() || file.getFileName() == null;
            if (hasNoName || isAlive(header.substring(HEADER.length(), separator))) {
                return Optional.empty();
            }
            int length = header.getBytes(StandardCharsets.UTF_8).length + 1;
            if (Files.size(recoveryFile) - length > JenLimits.FILE_BYTES) {
                return Optional.empty();
            }
            Instant time = Files.getLastModifiedTime(recoveryFile).toInstant();
            return Optional.of(new RecoverableScene(recoveryFile, Files.readString(recoveryFile).substring(header.length() + 1), time,
                    diskStatus(file, written, time)));
        } catch (IOException | IllegalArgumentException | FileSystemNotFoundException e) {
            return Optional.empty();
        }
    }

    /** Compares the scene file with its state when it was edited. Older versions stored no state; a file that is older counts as unchanged. */
    private static DiskStatus diskStatus(Path file, String written, Instant time) throws IOException {
        FileState current = FileState.of(file);
        FileState known = Optional.of(written.indexOf(STATE_SEPARATOR)).filter(at -> isUri(written) && at >= 0)
                .flatMap(at -> FileState.parse(written.substring(at + STATE_SEPARATOR.length())))
                .orElse(current.modified().toInstant().isAfter(time) ? FileState.MISSING : current);
        return new DiskStatus(file, known, current, false);
    }

    /** Returns the first line without its end; empty if it exceeds {@link #MAX_HEADER_BYTES}. */
    private static String readHeader(Path recoveryFile) throws IOException {
        try (InputStream in = Files.newInputStream(recoveryFile)) {
            String start = new String(in.readNBytes(MAX_HEADER_BYTES), StandardCharsets.UTF_8);
            return start.substring(0, Math.max(0, start.indexOf('\n')));
        }
    }

    private static boolean isRecoveryFile(Path file) {
        return file.getFileName().toString().endsWith(EXTENSION) && Files.isRegularFile(file);
    }

    /** Parses a path stored as a URI, which has no spaces and line ends; older versions stored the plain path. */
    private static Path path(String written) {
        return isUri(written) ? Path.of(URI.create(written.split(STATE_SEPARATOR, 2)[0])) : Path.of(written);
    }

    private static boolean isUri(String written) {
        return written.startsWith("file:");
    }

    private Path recoveryFile(Path file) {
        String path = file.toAbsolutePath().toString();
        return folder.resolve(process + "-" + Integer.toHexString(path.hashCode()) + EXTENSION);
    }

    private static boolean isAlive(String owner) {
        return ProcessIdentity.parse(owner).filter(ProcessIdentity::isRunning).isPresent();
    }
}
