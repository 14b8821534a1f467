package lightning.format.exchange.assembly;

import java.io.IOException;
import java.nio.file.DirectoryIteratorException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.regex.Pattern;
import lightning.base.file.FolderLock;
import lightning.base.file.ParentFolder;
import lightning.base.file.TemporaryFolder;

/** Folder next to a scene for the files of its replacement. A killed process leaves it; the next replacement of the scene removes it. */
record StagingFolder(Path path, Optional<FolderLock> lock) implements AutoCloseable {
    private static final String ENDING = ".import";
    /** Leaves most of a file name's 200 characters to the files in the folder. */
    private static final int MAX_STEM_LENGTH = 24;
    private static final Duration CREATION_GRACE = Duration.ofMinutes(1);
    /** Folders of this process: closing any channel of a lock file releases the process's lock. */
    private static final Set<Path> OPEN = ConcurrentHashMap.newKeySet();

    /** Creates a folder with an unused name. */
    static StagingFolder createNextTo(Path sceneFile) throws IOException {
        for (int i = 1;; i++) {
            Path candidate = sceneFile.toAbsolutePath().resolveSibling(start(sceneFile) + (i == 1 ? "" : i));
            if (!Files.exists(candidate, LinkOption.NOFOLLOW_LINKS)) {
                OPEN.add(candidate);
                Files.createDirectory(candidate);
                return new StagingFolder(candidate, FolderLock.tryLock(candidate));
            }
        }
    }

    /** Removes folders of ended processes, except those that a scene uses. Never fails: the next call removes what is left. */
    static void removeStale(Path sceneFile) {
        var names = Pattern.compile(Pattern.quote(start(sceneFile)) + "\\d*").asMatchPredicate();
        try (DirectoryStream<Path> files = Files.newDirectoryStream(ParentFolder.of(sceneFile),
                file -> names.test(file.getFileName().toString()))) {
            for (Path file : files) {
                if (isStale(file) && !OtherScenes.in(ParentFolder.of(file)).mayUse(file.getFileName() + "/")) {
                    TemporaryFolder.delete(file);
                }
            }
        } catch (IOException | DirectoryIteratorException e) {
            // May belong to another user.
        }
    }

    private static boolean isStale(Path folder) throws IOException {
        if (OPEN.contains(folder)) {
            return false;
        }
        if (!FolderLock.hasLockFile(folder)) {
            // Left empty between two steps of its creation or deletion. A new one gets its lock at once.
            return Files.isDirectory(folder, LinkOption.NOFOLLOW_LINKS) && isEmpty(folder)
                    && Files.getLastModifiedTime(folder).toInstant().plus(CREATION_GRACE).isBefore(Instant.now());
        }
        Optional<FolderLock> lock = FolderLock.tryLock(folder);
        if (lock.isPresent()) {
            lock.get().close();
        }
        return lock.isPresent();
    }

    private static boolean isEmpty(Path folder) throws IOException {
        try (DirectoryStream<Path> files = Files.newDirectoryStream(folder)) {
            return !files.iterator().hasNext();
        }
    }

    private static String start(Path sceneFile) {
        String name = SceneAssembler.sanitize(sceneFile.getFileName().toString().replaceFirst("\\.[^.]*$", ""));
        return name.substring(0, name.offsetByCodePoints(0, Math.min(MAX_STEM_LENGTH, name.codePointCount(0, name.length())))) + ENDING;
    }

    /** Deletes the folder. */
    void delete() throws IOException {
        close();
        TemporaryFolder.delete(path);
    }

    /** Releases the folder, and leaves its files. */
    @Override
    public void close() throws IOException {
        if (lock.isPresent()) {
            lock.get().close();
        }
        OPEN.remove(path);
    }
}
