package lightning.base.file;

import static java.util.Objects.requireNonNull;

import java.io.BufferedOutputStream;
import java.io.FilterOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.channels.Channels;
import java.nio.channels.FileChannel;
import java.nio.channels.SeekableByteChannel;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import org.jspecify.annotations.Nullable;

/**
 * Atomic file writer. Writes to a temporary file in the same folder and renames it over the target when complete, so that the target always
 * holds either the old content or the new. The program writes all its files with this class.
 *
 * <p>If the target is a symbolic link, the file that it points to is written and the link stays. Only the owner can access the temporary
 * file. The finished file has owner, group and mode of the file that it replaces, or the system's defaults for new files. Removes temporary
 * files that ended processes left in the folder: see {@link TemporaryFile}.
 */
public final class AtomicFile {
    private final Path target;
    private final boolean ownerOnly;
    private final boolean replacesReadOnly;
    /** State that the target must have to be replaced; null for any. */
    private final @Nullable FileState expected;

    private AtomicFile(Path target, boolean ownerOnly, boolean replacesReadOnly, @Nullable FileState expected) {
        this.target = target;
        this.ownerOnly = ownerOnly;
        this.replacesReadOnly = replacesReadOnly;
        this.expected = expected;
    }

    /** Content written from start to end. */
    @FunctionalInterface
    public interface Content {
        /** Writes everything; the stream is buffered, and closing it is allowed but not needed. */
        void writeTo(OutputStream out) throws IOException;
    }

    /** Content whose beginning is written last. */
    @FunctionalInterface
    public interface RandomAccessContent {
        /** Writes everything; the channel can be positioned, and closing it is not needed. */
        void writeTo(SeekableByteChannel file) throws IOException;
    }

    /** Content written by file name, as an external program does. */
    @FunctionalInterface
    public interface PathContent {
        /** Writes everything into an existing, empty file whose name has no extension. */
        void writeTo(Path temporary) throws IOException;
    }

    /** Returns a writer for a new file or for an existing writable one. */
    public static AtomicFile of(Path target) {
        return new AtomicFile(target, false, false, null);
    }

    /** Writes {@code content} to {@code target} with default settings: {@link #write(Content)}. */
    public static void write(Path target, Content content) throws IOException {
        of(target).write(content);
    }

    /** Restricts the file to its owner, whatever the mode of the old file. */
    public AtomicFile forOwnerOnly() {
        return new AtomicFile(target, true, replacesReadOnly, expected);
    }

    /** Allows replacing a read-only file; the new file is read-only again. */
    public AtomicFile allowReadOnly() {
        return new AtomicFile(target, ownerOnly, true, expected);
    }

    /**
     * Replaces only a file in this state; {@link FileState#MISSING} requires that no file exists. Of several processes that replace the same
     * state at the same time, one succeeds.
     */
    public AtomicFile ifUnchanged(FileState state) {
        return new AtomicFile(target, ownerOnly, replacesReadOnly, state);
    }

    /**
     * Checks before a long computation that its result can be written.
     *
     * @throws ReadOnlyFileException if the file exists and is read-only, unless allowed
     * @throws IOException           if the folder does not exist or cannot be written, or if the name is not that of a regular file; the
     *     message begins with the name
     */
    public void check() throws IOException {
        destination();
    }

    /**
     * Writes {@code content} to the file.
     *
     * @throws ChangedFileException  if the file's state differs from {@link #ifUnchanged}, checked when the content is complete; a missing
     *     file is accepted
     * @throws ReadOnlyFileException as {@link #check}
     * @throws IOException           as {@link #check}, or if {@code content} throws; the target is then unchanged and the temporary file
     *     removed, also when {@code content} throws a runtime exception
     */
    public void write(Content content) throws IOException {
        writeStream(content);
    }

    /** Writes content that is complete already; returns the file's new state. */
    public FileState write(byte[] content) throws IOException {
        return writeStream((Content) out -> out.write(content)).withContent(content);
    }

    /** Writes content in any order, otherwise as {@link #write(Content)}. */
    public void writeRandomAccess(RandomAccessContent content) throws IOException {
        writeChannel(content);
    }

    /** Writes content by file name: that of the temporary file. */
    public void writeToPath(PathContent content) throws IOException {
        replace(temporary -> {
            FilePermissions.OWNER_ONLY.create(temporary);
            content.writeTo(temporary);
            try (NamedChannel channel = openNamed(temporary)) {
                channel.force();
            }
        });
    }

    private FileState writeStream(Content content) throws IOException {
        return writeChannel(channel -> {
            var out = new BufferedOutputStream(new NonClosingStream(Channels.newOutputStream(channel)), 1 << 16);
            content.writeTo(out);
            out.flush();
        });
    }

    private FileState writeChannel(RandomAccessContent content) throws IOException {
        return replace(temporary -> fill(temporary, content));
    }

    private FileState replace(PathContent content) throws IOException {
        Path file = destination();
        Path folder = requireNonNull(file.getParent());
        TemporaryFile.removeStaleIn(folder);
        Path temporary = TemporaryFile.newPath(folder);
        try {
            FilePermissions permissions = ownerOnly ? FilePermissions.OWNER_ONLY : FilePermissions.forTarget(file);
            content.writeTo(temporary);
            permissions.applyTo(temporary);
            FileState written = FileState.readMetadata(temporary);
            if (expected == null && !Files.exists(file)) {
                Files.move(temporary, file, StandardCopyOption.ATOMIC_MOVE);
            } else {
                replaceInTurn(temporary, file, folder);
            }
            force(folder);
            return written;
        } catch (FileSystemException e) {
            throw withTargetName(e);
        } finally {
            delete(temporary);
        }
    }

    /** Deletes the temporary file of a failed write. The failure is reported, not that of deleting it. */
    private static void delete(Path temporary) {
        try {
            Files.deleteIfExists(temporary);
        } catch (IOException e) {
            // A later write deletes it.
        }
    }

    /** Compares and moves in one step for all processes that do the same. */
    private void replaceInTurn(Path temporary, Path file, Path folder) throws IOException {
        try (ReplaceLock _ = ReplaceLock.of(folder)) {
            if (expected != null && expected.differsFrom(file)) {
                throw new ChangedFileException(target);
            }
            Files.move(temporary, file, StandardCopyOption.ATOMIC_MOVE);
        }
    }

    private Path destination() throws IOException {
        Path file = WriteTarget.resolve(target);
        if (!replacesReadOnly && WriteTarget.isReadOnly(file)) {
            throw new ReadOnlyFileException(target);
        }
        return file;
    }

    private void fill(Path temporary, RandomAccessContent content) throws IOException {
        FilePermissions.OWNER_ONLY.create(temporary);
        try (NamedChannel channel = openNamed(temporary)) {
            content.writeTo(channel);
            // The rename may reach the disk before the data; after a power cut the name must not hold an empty file.
            channel.force();
        }
    }

    private NamedChannel openNamed(Path temporary) throws IOException {
        return new NamedChannel(FileChannel.open(temporary, StandardOpenOption.WRITE), target);
    }

    /** Syncs the folder's entry to disk. Some systems do not let a folder be opened; the file is complete anyway. */
    private static void force(Path folder) {
        try (FileChannel channel = FileChannel.open(folder)) {
            channel.force(true);
        } catch (IOException e) {
            // The system writes it later.
        }
    }

    /** Replaces a temporary name in an exception by the target's, the only one that the user sees. */
    private FileSystemException withTargetName(FileSystemException e) {
        if (e.getFile() == null || !TemporaryFile.isTemporary(Path.of(e.getFile()))) {
            return e;
        }
        var renamed = e instanceof AccessDeniedException ? new AccessDeniedException(target.toString())
                : new FileSystemException(target.toString(), null,
                        e.getReason() == null ? "cannot be written" : e.getReason());
        renamed.initCause(e);
        return renamed;
    }

    /** Stream whose close only flushes, because some encoders close their output. */
    private static final class NonClosingStream extends FilterOutputStream {
        NonClosingStream(OutputStream out) {
            super(out);
        }

        @Override
        public void write(byte[] bytes, int offset, int length) throws IOException {
            out.write(bytes, offset, length);
        }

        @Override
        public void close() throws IOException {
            flush();
        }
    }
}
