package lightning.shot.cluster;

import static java.util.Objects.requireNonNull;

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
import lightning.base.file.AtomicFile;
import lightning.base.file.ContentHash;
import lightning.base.file.FileErrorMessage;
import lightning.base.file.FolderLock;
import lightning.base.file.PrivateFolder;
import lightning.base.text.Quote;
import lightning.format.jen.ReferencedFiles;
import lightning.format.mesh.MeshLimits;
import lightning.shot.cluster.wire.SceneManifest;

/**
 * Content-addressed file cache, readable by its owner only: files named by hash, and for each scene's set of files a folder with their
 * original names.
 */
final class ContentFolder {
    /** Maximum bytes of all content. */
    private static final long MAX_BYTES = 32L << 30;

    private final Path contents;
    private final Path scenes;
    private final FolderLock lock;
    private long storedBytes;
    private boolean cleared;

    /** Source of content. */
    interface PartSource {
        /** Reads some bytes from an offset, none at the end; blocks until they arrive. */
        byte[] read(ContentHash hash, long offset) throws IOException;
    }

    /**
     * Locks a folder and removes what an earlier process left in it.
     *
     * @throws IOException if another node uses the folder, or it is unusable; the message is a sentence
     */
    ContentFolder(Path folder) throws IOException {
        PrivateFolder.restrict(folder);
        lock = lock(folder);
        contents = folder.resolve("contents");
        scenes = folder.resolve("scenes");
        for (Path subfolder : new Path[] {contents, scenes}) {
            remove(subfolder);
            PrivateFolder.restrict(subfolder);
        }
    }

    private static FolderLock lock(Path folder) throws IOException {
        Optional<FolderLock> lock;
        try {
            lock = FolderLock.tryLock(folder);
        } catch (IOException e) {
            throw new IOException(Quote.path(folder) + ": cannot lock the folder (" + reason(e)
                    + "); choose a folder on another disk with --folder", e);
        }
        return lock
                .orElseThrow(() -> new IOException(
                        Quote.path(folder) + ": another node uses this folder; choose another one with --folder"));
    }

    private static String reason(IOException e) {
        return e instanceof FileSystemException file && file.getReason() != null ? file.getReason() : FileErrorMessage.of(e);
    }

    /**
     * Returns the file with some content, and fetches it if missing.
     *
     * @param maxBytes maximum size
     * @throws InvalidContentException if it is longer, or has another hash
     * @throws IOException             if it cannot be stored
     */
    synchronized Path fetch(SceneManifest.Content content, long maxBytes, PartSource parts) throws IOException {
        Path file = contents.resolve(content.hash().hex());
        if (Files.exists(file)) {
            return file;
        }
        if (content.bytes() > maxBytes) {
            throw new InvalidContentException("expected content of at most " + maxBytes + " bytes, found " + content.bytes());
        }
        if (storedBytes + content.bytes() > MAX_BYTES) {
            throw new IOException(
                    "content has " + content.bytes() + " bytes, but only " + (MAX_BYTES - storedBytes) + " are free");
        }
        AtomicFile.of(file).forOwnerOnly().write(out -> {
            long offset = 0;
            while (offset < content.bytes()) {
                byte[] part = parts.read(content.hash(), offset);
                if (part.length == 0 || part.length > content.bytes() - offset) {
                    throw new InvalidContentException("expected " + content.bytes() + " bytes of content, found " + (offset + part.length));
                }
                out.write(part);
                offset += part.length;
            }
        });
        if (!ContentHash.of(file).equals(content.hash())) {
            Files.delete(file);
            throw new InvalidContentException("content does not match its hash; the file changed during the transfer");
        }
        storedBytes += content.bytes();
        return file;
    }

    /**
     * Returns a folder with the files of a manifest under their names in the scene.
     *
     * @throws InvalidContentException if a name leads out of the folder, or as {@link #fetch}
     * @throws IOException             as {@link #fetch}
     */
    synchronized Path sceneFolder(SceneManifest manifest, PartSource parts) throws IOException {
        if (cleared) {
            throw new IOException("the node has stopped");
        }
        Path folder = scenes
                .resolve(ContentHash.of(new SceneManifest(new SceneManifest.Content(EMPTY_HASH, 0), manifest.files()).encode()).hex());
        PrivateFolder.create(folder);
        for (Map.Entry<String, SceneManifest.Content> entry : manifest.files().entrySet()) {
            if (!ReferencedFiles.isAllowed(entry.getKey())) {
                throw new InvalidContentException("expected a file name relative to the scene, found " + Quote.of(entry.getKey()));
            }
            Path file = fetch(entry.getValue(), MeshLimits.FILE_BYTES, parts);
            Path link = folder.resolve(entry.getKey());
            PrivateFolder.create(requireNonNull(link.getParent()));
            link(link, file);
        }
        return folder;
    }

    private static final ContentHash EMPTY_HASH = ContentHash.of(new byte[0]);

    private static void link(Path link, Path file) throws IOException {
        try {
            Files.createLink(link, file);
        } catch (FileAlreadyExistsException e) {
            // It exists with the same content, because its name is a hash of it.
        } catch (IOException | UnsupportedOperationException e) {
            AtomicFile.of(link).forOwnerOnly().write(out -> Files.copy(file, out));
        }
    }

    /** Removes all content and stores nothing more; open files stay readable. */
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
