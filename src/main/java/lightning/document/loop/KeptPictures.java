package lightning.document.loop;

import java.io.IOException;
import java.nio.file.DirectoryIteratorException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Function;
import lightning.base.file.AtomicFile;
import lightning.base.file.ContentHash;
import lightning.base.file.PrivateFolder;
import lightning.base.file.ProgramFiles;
import lightning.render.cache.PictureFile;
import lightning.render.cache.PixelCache;
import lightning.render.relight.MemoryEstimate;
import lightning.render.trace.Geometry;
import lightning.scene.Scene;

/**
 * Pictures that earlier processes finished, in a folder of the user, with all that was computed for them. A scene that was traced before opens
 * with its picture, and edits continue from it. Only the owner can read the folder, and all of it may be deleted at any time. Thread-safe.
 *
 * <p>A picture is found only for a scene with the same text and the same images, profiles and meshes, by the same program, so it equals the
 * one that would be traced.
 */
public final class KeptPictures {
    static final String EXTENSION = ".picture";
    /** Most bytes of all files. */
    private static final long MAX_BYTES = 3L << 30;
    /** Space that stays free on the disk, in sizes of a picture. */
    private static final int FREE_SHARE = 4;

    /** A picture that is traced faster than this is not kept, nanoseconds. */
    private static final long LONG_NS = 4_000_000_000L;

    private final Optional<Path> folder;
    private final long maxBytes;
    private final long longNs;
    /** State of the program; empty if it is unknown. */
    private final Optional<String> program;
    private final AtomicBoolean isEnabled;

    private KeptPictures(Optional<Path> folder, long maxBytes, long longNs, Optional<String> program, AtomicBoolean isEnabled) {
        this.longNs = longNs;
        this.isEnabled = isEnabled;
        this.folder = folder;
        this.maxBytes = maxBytes;
        this.program = program;
    }

    /** Returns pictures that are never kept. */
    public static KeptPictures none() {
        return new KeptPictures(Optional.empty(), 0, 0, Optional.empty(), new AtomicBoolean());
    }

    /**
     * Returns the pictures in a folder.
     *
     * @param folder    created with the first picture
     * @param isEnabled whether pictures are kept and found at first
     */
    public static KeptPictures in(Path folder, boolean isEnabled) {
        try {
            // Read at the start: the files may be replaced while the program runs.
            Optional<String> program = ProgramFiles.areArchives() ? Optional.of(ProgramFiles.state()) : Optional.empty();
            return new KeptPictures(Optional.of(folder), MAX_BYTES, LONG_NS, program, new AtomicBoolean(isEnabled));
        } catch (IOException e) {
            return none();
        }
    }

    /**
     * Returns the pictures in a folder, however long they took.
     *
     * @param maxBytes most bytes of all files
     * @param program  state of the program; without it no picture is kept
     */
    static KeptPictures in(Path folder, long maxBytes, Optional<String> program) {
        return new KeptPictures(Optional.of(folder), maxBytes, 0, program, new AtomicBoolean(true));
    }

    /** Returns whether pictures are kept and found. */
    public boolean isEnabled() {
        return isEnabled.get();
    }

    /** Returns the time from which the trace of a picture counts as long, nanoseconds. */
    long longNs() {
        return longNs;
    }

    /** Sets whether pictures are kept and found. Switched off, all are deleted, as far as they can be. */
    public void setEnabled(boolean enabled) {
        isEnabled.set(enabled);
        try {
            if (!enabled && folder.isPresent()) {
                removeOldest(0);
            }
        } catch (IOException e) {
            // They are replaced or deleted later.
        }
    }

    /**
     * Reads the picture of a scene.
     *
     * @param geometries prepares the geometry of a scene
     * @param memory     most bytes of the picture
     * @return empty if there is none, or it cannot be read
     */
    Optional<PixelCache> find(Scene scene, Function<Scene, Geometry> geometries, long memory) {
        try {
            List<Path> kept = !isEnabled() || folder.isEmpty() || program.isEmpty() ? List.of() : files();
            if (kept.isEmpty()) {
                return Optional.empty();
            }
            Optional<ContentHash> text = PictureKey.textOf(scene, program.orElseThrow());
            if (text.isEmpty() || kept.stream().noneMatch(file -> hasText(file, text.get()))) {
                return Optional.empty();
            }
            Path found = file(scene, text.get());
            return !Files.isRegularFile(found) || Files.size(found) > memory ? Optional.empty()
                    : Optional.of(read(found, geometries.apply(scene), scene));
        } catch (IOException | RuntimeException | OutOfMemoryError e) {
            // Then it is traced, and that tells what is wrong with the scene or with the memory.
            return Optional.empty();
        }
    }

    private static boolean hasText(Path file, ContentHash text) {
        return String.valueOf(file.getFileName()).startsWith(PictureKey.prefix(text));
    }

    private Path file(Scene scene, ContentHash text) {
        return folder.orElseThrow().resolve(new PictureKey(text, PictureKey.contentOf(scene)).fileName());
    }

    private static PixelCache read(Path file, Geometry geometry, Scene scene) throws IOException {
        try {
            PixelCache read = PictureFile.read(file, geometry, scene);
            Files.setLastModifiedTime(file, FileTime.from(Instant.now()));
            return read;
        } catch (IOException | RuntimeException e) {
            Files.deleteIfExists(file);
            throw new IOException("cannot read a kept picture", e);
        }
    }

    /**
     * Keeps a picture, unless it is kept already or there is no space. Removes those that were not used for the longest time.
     *
     * @param cache finished picture of accuracy exact
     * @throws IOException if it cannot be written
     */
    void keep(PixelCache cache) throws IOException {
        long bytes = MemoryEstimate.usedBytes(cache);
        if (!isEnabled() || folder.isEmpty() || program.isEmpty() || bytes > maxBytes || !PictureFile.canWrite(cache)) {
            return;
        }
        Optional<ContentHash> text = PictureKey.textOf(cache.scene(), program.get());
        if (text.isEmpty()) {
            return;
        }
        Path file = file(cache.scene(), text.get());
        if (Files.exists(file)) {
            return;
        }
        PrivateFolder.restrict(folder.get());
        removeOldest(maxBytes - bytes);
        if (Files.getFileStore(folder.get()).getUsableSpace() > FREE_SHARE * bytes) {
            AtomicFile.of(file).forOwnerOnly().writeRandomAccess(out -> PictureFile.write(cache, out));
        }
    }

    /** Removes the files that were used first until the others need at most some bytes. */
    private void removeOldest(long most) throws IOException {
        record Used(Path file, long bytes, FileTime time) {}
        List<Used> used = new ArrayList<>();
        for (Path file : files()) {
            used.add(new Used(file, Files.size(file), Files.getLastModifiedTime(file)));
        }
        used.sort(Comparator.comparing(Used::time));
        long sum = used.stream().mapToLong(Used::bytes).sum();
        for (Used oldest : used) {
            if (sum <= most) {
                return;
            }
            Files.deleteIfExists(oldest.file);
            sum -= oldest.bytes;
        }
    }

    private List<Path> files() throws IOException {
        Path in = folder.orElseThrow();
        if (!Files.isDirectory(in)) {
            return List.of();
        }
        List<Path> files = new ArrayList<>();
        try (DirectoryStream<Path> found = Files.newDirectoryStream(in, "*" + EXTENSION)) {
            found.forEach(files::add);
        } catch (DirectoryIteratorException e) {
            throw e.getCause();
        }
        return files;
    }
}
