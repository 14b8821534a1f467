package lightning.shot.cluster;

import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;
import lightning.base.file.ContentHash;
import lightning.format.jen.JenDocument;
import lightning.format.jen.ReferencedFiles;
import lightning.shot.ShotRevision;
import lightning.shot.cluster.wire.SceneManifest;

/** Content served by a coordinator to its nodes: the manifests of its newest revisions, their scene texts and the scene's files. */
final class AssetTransfer {
    /** Older revisions are not requested any more. */
    private static final int MAX_TRANSFERS = 4;

    private final Path folder;
    private final Hasher hasher;
    /** Held while files are hashed, which takes seconds for large ones; {@code this} guards what {@link #readPart} looks up. */
    private final Object preparing = new Object();
    private final ArrayDeque<Transfer> newest = new ArrayDeque<>();
    /** Content by file; each file is read once. Guarded by {@link #preparing}. */
    private final Map<Path, SceneManifest.Content> contents = new HashMap<>();
    private final Map<ContentHash, Path> files = new HashMap<>();

    /** Hashes a file. */
    @FunctionalInterface
    interface Hasher {
        ContentHash hash(Path file) throws IOException;
    }

    /** @param manifest bytes of the manifest */
    record Transfer(ShotRevision revision, ContentHash hash, byte[] manifest, ContentHash textHash, byte[] text) {}

    /** @param folder folder of the scene file */
    AssetTransfer(Path folder) {
        this(folder, ContentHash::of);
    }

    AssetTransfer(Path folder, Hasher hasher) {
        this.folder = folder;
        this.hasher = hasher;
    }

    /** @throws IOException if a file that the scene names cannot be read */
    Transfer prepare(ShotRevision revision) throws IOException {
        synchronized (preparing) {
            Optional<Transfer> prepared = prepared(revision);
            if (prepared.isPresent()) {
                return prepared.get();
            }
            byte[] text = JenDocument.of(revision.scene()).withShot(revision.shot()).text().getBytes(StandardCharsets.UTF_8);
            SortedMap<String, SceneManifest.Content> entries = new TreeMap<>();
            for (Map.Entry<String, Path> file : ReferencedFiles.of(revision.scene(), folder).entrySet()) {
                entries.put(file.getKey(), content(file.getValue()));
            }
            ContentHash textHash = ContentHash.of(text);
            byte[] manifest = new SceneManifest(new SceneManifest.Content(textHash, text.length), entries).encode();
            var transfer = new Transfer(revision, ContentHash.of(manifest), manifest, textHash, text);
            publish(transfer);
            return transfer;
        }
    }

    private synchronized Optional<Transfer> prepared(ShotRevision revision) {
        return newest.stream().filter(transfer -> transfer.revision() == revision).findFirst();
    }

    private synchronized void publish(Transfer transfer) {
        newest.addFirst(transfer);
        if (newest.size() > MAX_TRANSFERS) {
            newest.removeLast();
        }
    }

    private SceneManifest.Content content(Path file) throws IOException {
        SceneManifest.Content content = contents.get(file);
        if (content == null) {
            content = new SceneManifest.Content(hasher.hash(file), Files.size(file));
            contents.put(file, content);
            synchronized (this) {
                files.put(content.hash(), file);
            }
        }
        return content;
    }

    /** Returns a part of the content with a hash; empty for an unknown hash, or after its end. Does not wait for {@link #prepare}. */
    byte[] readPart(ContentHash hash, long offset, int maxBytes) {
        Path file;
        synchronized (this) {
            for (Transfer transfer : newest) {
                if (transfer.hash().equals(hash)) {
                    return readPart(transfer.manifest(), offset, maxBytes);
                }
                if (transfer.textHash().equals(hash)) {
                    return readPart(transfer.text(), offset, maxBytes);
                }
            }
            file = files.get(hash);
        }
        return file == null ? new byte[0] : readPart(file, offset, maxBytes);
    }

    private static byte[] readPart(byte[] bytes, long offset, int maxBytes) {
        int from = (int) Math.min(bytes.length, offset);
        return Arrays.copyOfRange(bytes, from, Math.min(bytes.length, from + maxBytes));
    }

    private static byte[] readPart(Path file, long offset, int maxBytes) {
        try (var in = new RandomAccessFile(file.toFile(), "r")) {
            byte[] part = new byte[(int) Math.clamp(in.length() - offset, 0L, maxBytes)];
            in.seek(offset);
            in.readFully(part);
            return part;
        } catch (IOException e) {
            // The node reports the missing content.
            return new byte[0];
        }
    }
}
