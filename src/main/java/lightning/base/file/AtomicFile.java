package lightning.base.file;

import java.io.BufferedOutputStream;
import java.io.FilterOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.channels.Channels;
import java.nio.channels.FileChannel;
import java.nio.channels.SeekableByteChannel;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;

/**
 * Writes a file to a temporary name in the same folder and moves it over the old one when it is
 * complete, so that at every moment the name holds either the old content or the new one. All that
 * the program writes, it writes with this.
 *
 * <p>Where the target is a symbolic link, the file that it leads to is written and the link stays.
 * The temporary file is its owner's alone; the finished one has owner, group and mode of the file
 * that it replaces, or those that the system gives to new files. Temporary files that an ended
 * process left in the folder are removed: see {@link TemporaryFile}.
 */
public final class AtomicFile {
    private final Path target;
    private final boolean ownerOnly;
    private final boolean replacesReadOnly;
    /** What may be replaced; null for anything. */
    private final FileState expected;

    private AtomicFile(Path target, boolean ownerOnly, boolean replacesReadOnly, FileState expected) {
        this.target = target;
        this.ownerOnly = ownerOnly;
        this.replacesReadOnly = replacesReadOnly;
        this.expected = expected;
    }

    /** What goes into the file. */
    @FunctionalInterface
    public interface Content {
        /** Writes everything; the stream is buffered, and closing it is allowed but not needed. */
        void writeTo(OutputStream out) throws IOException;
    }

    /** What goes into a file whose beginning is known last. */
    @FunctionalInterface
    public interface RandomAccessContent {
        /** Writes everything; the channel can be positioned, and closing it is not needed. */
        void writeTo(SeekableByteChannel file) throws IOException;
    }

    /** Who writes what goes into the file by its name, as another program does. */
    @FunctionalInterface
    public interface PathContent {
        /** Writes everything into a file that is there and empty; its name ends in no kind of files. */
        void writeTo(Path temporary) throws IOException;
    }

    /** A file to write, new or in place of an old one that may be written. */
    public static AtomicFile of(Path target) {
        return new AtomicFile(target, false, false, null);
    }

    /** Puts {@code content} into the file {@code target}: {@link #write(Content)} with nothing asked for. */
    public static void write(Path target, Content content) throws IOException {
        of(target).write(content);
    }

    /** Nobody but its owner may read or write the file, whatever the mode of the old one. */
    public AtomicFile forOwnerOnly() {
        return new AtomicFile(target, true, replacesReadOnly, expected);
    }

    /** A read-only file is replaced too, and is read-only again then. */
    public AtomicFile allowReadOnly() {
        return new AtomicFile(target, ownerOnly, true, expected);
    }

    /** Replaces only what the caller knows of; {@link FileState#MISSING} is no file at all. */
    public AtomicFile ifUnchanged(FileState state) {
        return new AtomicFile(target, ownerOnly, replacesReadOnly, state);
    }

    /**
     * Finds out before a long computation whether its result could not be written.
     *
     * @throws ReadOnlyFileException if the file is there and read-only, unless that was allowed
     * @throws IOException           if the folder does not exist or cannot be written, or if the name leads to
     *                               anything but a regular file; the message is a sentence that begins with the name
     */
    public void check() throws IOException {
        destination();
    }

    /**
     * Puts {@code content} into the file.
     *
     * @throws ChangedFileException  if the file holds anything but what {@link #ifUnchanged} told; looked at when the content
     *                               is complete. That it is gone is no obstacle
     * @throws ReadOnlyFileException as {@link #check}
     * @throws IOException           as {@link #check}, or if {@code content} throws; the target is then unchanged and
     *                               nothing else is left in the folder. Runtime exceptions of {@code content} pass
     *                               through with the same promise
     */
    public void write(Content content) throws IOException {
        writeStream(content);
    }

    /** The same for content that is whole already; returns what the file holds then. */
    public FileState write(byte[] content) throws IOException {
        return writeStream((Content) out -> out.write(content)).withContent(content);
    }

    /** The same as {@link #write(Content)} for content that is not written from its beginning to its end. */
    public void writeRandomAccess(RandomAccessContent content) throws IOException {
        writeChannel(content);
    }

    /** The same for content that is written by the name of a file, which is another one until it is complete. */
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
        TemporaryFile.removeStaleIn(file.getParent());
        Path temporary = TemporaryFile.newPath(file.getParent());
        try {
            FilePermissions permissions = ownerOnly ? FilePermissions.OWNER_ONLY : FilePermissions.forTarget(file);
            content.writeTo(temporary);
            permissions.applyTo(temporary);
            FileState written = FileState.readMetadata(temporary);
            if (expected != null && expected.differsFrom(file)) {
                throw new ChangedFileException(target);
            }
            Files.move(temporary, file, StandardCopyOption.ATOMIC_MOVE);
            force(file.getParent());
            return written;
        } catch (FileSystemException e) {
            throw withTargetName(e, temporary);
        } finally {
            Files.deleteIfExists(temporary);
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
            // A move may reach the disk before the data does; after a power cut the name must not hold an empty file.
            channel.force();
        }
    }

    private NamedChannel openNamed(Path temporary) throws IOException {
        return new NamedChannel(FileChannel.open(temporary, StandardOpenOption.WRITE), target);
    }

    /** Brings the new name itself to the disk. Not every system lets a folder be opened; the file is whole all the same. */
    private static void force(Path folder) {
        try (FileChannel channel = FileChannel.open(folder)) {
            channel.force(true);
        } catch (IOException e) {
            // The system writes it in its own time.
        }
    }

    /** Nobody knows the temporary name: what happened to it, happened to the file. */
    private FileSystemException withTargetName(FileSystemException e, Path temporary) {
        if (!temporary.toString().equals(e.getFile())) {
            return e;
        }
        var renamed = new FileSystemException(target.toString(), null,
                e.getReason() == null ? "cannot be written (" + e.getClass().getSimpleName() + ")" : e.getReason());
        renamed.initCause(e);
        return renamed;
    }

    /** A stream whose close only flushes: some encoders close what they write to. */
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
