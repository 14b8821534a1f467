package lightning.shot.cluster;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.Map;
import java.util.Optional;
import lightning.base.file.FileSentence;
import lightning.base.file.FolderLock;
import lightning.base.file.PrivateFolder;
import lightning.base.file.SafeFile;
import lightning.base.text.Quote;
import lightning.format.jen.NamedFiles;
import lightning.format.mesh.MeshLimits;
import lightning.shot.cluster.wire.Bill;
import lightning.shot.cluster.wire.Hash;

/**
 * Content that came from others, in a folder for nobody else to read: files named by their hash, and for each set of files that a scene
 * names a folder where they have these names.
 */
final class ContentFolder {
    /** Bytes of all content. */
    private static final long MOST_BYTES = 32L << 30;

    private final Path contents;
    private final Path scenes;
    private final FolderLock lock;
    private long bytes;
    private boolean cleared;

    /** Where content comes from. */
    interface Parts {
        /** Some bytes from an offset on, none at the end; waits for them. */
        byte[] from(Hash hash, long offset) throws IOException;
    }

    /**
     * Takes a folder, and removes what an earlier process left in it.
     *
     * @throws IOException if another node uses the folder, or it cannot be used; a sentence
     */
    ContentFolder(Path folder) throws IOException {
        PrivateFolder.close(folder);
        lock = lock(folder);
        contents = folder.resolve("contents");
        scenes = folder.resolve("scenes");
        for (Path own : new Path[] {contents, scenes}) {
            remove(own);
            PrivateFolder.close(own);
        }
    }

    private static FolderLock lock(Path folder) throws IOException {
        Optional<FolderLock> lock;
        try {
            lock = FolderLock.tryLock(folder);
        } catch (IOException e) {
            throw new IOException(Quote.path(folder) + ": cannot be locked for this node (" + reason(e)
                    + "); name a folder on another disk with --folder", e);
        }
        return lock
                .orElseThrow(() -> new IOException(Quote.path(folder) + ": another node uses this folder; name another one with --folder"));
    }

    private static String reason(IOException e) {
        return e instanceof FileSystemException file && file.getReason() != null ? file.getReason() : FileSentence.of(e);
    }

    /**
     * The file that holds some content, which is fetched where it is not there.
     *
     * @param most bytes that it may have
     * @throws ContentException if it is longer, or what came has another hash
     * @throws IOException      if it cannot be kept
     */
    synchronized Path file(Bill.Content content, long most, Parts parts) throws IOException {
        Path file = contents.resolve(content.hash().hex());
        if (Files.exists(file)) {
            return file;
        }
        if (content.bytes() > most) {
            throw new ContentException("expected content of at most " + most + " bytes, found " + content.bytes());
        }
        if (bytes + content.bytes() > MOST_BYTES) {
            throw new IOException("there is room for " + (MOST_BYTES - bytes) + " bytes of content more, and this has " + content.bytes());
        }
        SafeFile.at(file).forOwnerOnly().write(out -> {
            long at = 0;
            while (at < content.bytes()) {
                byte[] part = parts.from(content.hash(), at);
                if (part.length == 0 || part.length > content.bytes() - at) {
                    throw new ContentException("expected " + content.bytes() + " bytes of content, found " + (at + part.length));
                }
                out.write(part);
                at += part.length;
            }
        });
        if (!Hash.of(file).equals(content.hash())) {
            Files.delete(file);
            throw new ContentException("content has other bytes than its hash says; the file was written to meanwhile");
        }
        bytes += content.bytes();
        return file;
    }

    /**
     * The folder where the files of a bill have the names that its scene writes.
     *
     * @throws ContentException if a name leads elsewhere, or as {@link #file}
     * @throws IOException      as {@link #file}
     */
    synchronized Path scene(Bill bill, Parts parts) throws IOException {
        if (cleared) {
            throw new IOException("the node has ended");
        }
        Path folder = scenes.resolve(Hash.of(new Bill(new Bill.Content(NO_TEXT, 0), bill.files()).encode()).hex());
        PrivateFolder.make(folder);
        for (Map.Entry<String, Bill.Content> named : bill.files().entrySet()) {
            if (!NamedFiles.isAllowed(named.getKey())) {
                throw new ContentException("expected the name of a file beside a scene, found " + Quote.of(named.getKey()));
            }
            Path file = file(named.getValue(), MeshLimits.FILE_BYTES, parts);
            Path link = folder.resolve(named.getKey());
            PrivateFolder.make(link.getParent());
            link(link, file);
        }
        return folder;
    }

    private static final Hash NO_TEXT = Hash.of(new byte[0]);

    private static void link(Path link, Path file) throws IOException {
        try {
            Files.createLink(link, file);
        } catch (FileAlreadyExistsException e) {
            // The same: the folder's name says what is in it.
        } catch (IOException | UnsupportedOperationException e) {
            SafeFile.at(link).forOwnerOnly().write(out -> Files.copy(file, out));
        }
    }

    /** Removes all, and keeps nothing any more; whoever reads a file of it goes on. */
    synchronized void clear() {
        cleared = true;
        try {
            remove(contents);
            remove(scenes);
            lock.close();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static void remove(Path folder) throws IOException {
        if (!Files.exists(folder)) {
            return;
        }
        Files.walkFileTree(folder, new SimpleFileVisitor<>() {
            @Override
            public FileVisitResult visitFile(Path file, BasicFileAttributes attributes) throws IOException {
                Files.delete(file);
                return FileVisitResult.CONTINUE;
            }

            @Override
            public FileVisitResult postVisitDirectory(Path visited, IOException problem) throws IOException {
                Files.delete(visited);
                return FileVisitResult.CONTINUE;
            }
        });
    }
}
