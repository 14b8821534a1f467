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
import java.util.SortedMap;
import java.util.TreeMap;
import lightning.format.jen.JenDocument;
import lightning.format.jen.ReferencedFiles;
import lightning.shot.ShotRevision;
import lightning.shot.cluster.wire.ContentHash;
import lightning.shot.cluster.wire.Message;
import lightning.shot.cluster.wire.SceneManifest;

/** Content served by a coordinator to its nodes: the manifests of its newest revisions, their scene texts and the scene's files. */
final class AssetTransfer {
    /** Older revisions are not requested any more. */
    private static final int MAX_TRANSFERS = 4;

    private final Path folder;
    private final ArrayDeque<Transfer> newest = new ArrayDeque<>();
    /** Content by file; each file is read once. */
    private final Map<Path, SceneManifest.Content> contents = new HashMap<>();
    private final Map<ContentHash, Path> files = new HashMap<>();

    /** @param manifest bytes of the manifest */
    record Transfer(ShotRevision revision, ContentHash hash, byte[] manifest, ContentHash textHash, byte[] text) {}

    /** @param folder folder of the scene file */
    AssetTransfer(Path folder) {
        this.folder = folder;
    }

    /** @throws IOException if a file that the scene names cannot be read */
    synchronized Transfer prepare(ShotRevision revision) throws IOException {
        for (Transfer transfer : newest) {
            if (transfer.revision() == revision) {
                return transfer;
            }
        }
        byte[] text = JenDocument.of(revision.scene()).withShot(revision.shot()).text().getBytes(StandardCharsets.UTF_8);
        SortedMap<String, SceneManifest.Content> entries = new TreeMap<>();
        for (Map.Entry<String, Path> file : ReferencedFiles.of(revision.scene(), folder).entrySet()) {
            entries.put(file.getKey(), content(file.getValue()));
        }
        ContentHash textHash = ContentHash.of(text);
        byte[] manifest = new SceneManifest(new SceneManifest.Content(textHash, text.length), entries).encode();
        var transfer = new Transfer(revision, ContentHash.of(manifest), manifest, textHash, text);
        newest.addFirst(transfer);
        if (newest.size() > MAX_TRANSFERS) {
            newest.removeLast();
        }
        return transfer;
    }

    private SceneManifest.Content content(Path file) throws IOException {
        SceneManifest.Content content = contents.get(file);
        if (content == null) {
            content = new SceneManifest.Content(ContentHash.of(file), Files.size(file));
            contents.put(file, content);
            files.put(content.hash(), file);
        }
        return content;
    }

    /** Returns a part of the content with a hash; empty for an unknown hash, or after its end. */
    synchronized byte[] readPart(ContentHash hash, long offset) {
        for (Transfer transfer : newest) {
            if (transfer.hash().equals(hash)) {
                return readPart(transfer.manifest(), offset);
            }
            if (transfer.textHash().equals(hash)) {
                return readPart(transfer.text(), offset);
            }
        }
        Path file = files.get(hash);
        return file == null ? new byte[0] : readPart(file, offset);
    }

    private static byte[] readPart(byte[] bytes, long offset) {
        int from = (int) Math.min(bytes.length, offset);
        return Arrays.copyOfRange(bytes, from, Math.min(bytes.length, from + Message.PART_BYTES));
    }

    private static byte[] readPart(Path file, long offset) {
        try (var in = new RandomAccessFile(file.toFile(), "r")) {
            byte[] part = new byte[(int) Math.clamp(in.length() - offset, 0L, Message.PART_BYTES)];
            in.seek(offset);
            in.readFully(part);
            return part;
        } catch (IOException e) {
            // The node reports the missing content.
            return new byte[0];
        }
    }
}
