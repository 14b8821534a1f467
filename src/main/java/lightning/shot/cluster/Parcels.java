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
import lightning.format.jen.NamedFiles;
import lightning.shot.Take;
import lightning.shot.cluster.wire.Bill;
import lightning.shot.cluster.wire.Hash;
import lightning.shot.cluster.wire.Message;

/** What nodes ask a coordinator for: the bills of its newest takes, their texts, the files of the scene. */
final class Parcels {
    /** Of older takes, nothing is wanted any more. */
    private static final int KEPT = 4;

    private final Path folder;
    private final ArrayDeque<Parcel> newest = new ArrayDeque<>();
    /** Of files, which are read once. */
    private final Map<Path, Bill.Content> known = new HashMap<>();
    private final Map<Hash, Path> files = new HashMap<>();

    /** @param bill the bytes of a bill */
    record Parcel(Take take, Hash hash, byte[] bill, Hash textHash, byte[] text) {}

    /** @param folder the folder that holds the scene file */
    Parcels(Path folder) {
        this.folder = folder;
    }

    /** @throws IOException if a file that the scene names cannot be read */
    synchronized Parcel of(Take take) throws IOException {
        for (Parcel parcel : newest) {
            if (parcel.take() == take) {
                return parcel;
            }
        }
        byte[] text = JenDocument.of(take.scene()).withShot(take.shot()).text().getBytes(StandardCharsets.UTF_8);
        SortedMap<String, Bill.Content> named = new TreeMap<>();
        for (Map.Entry<String, Path> file : NamedFiles.of(take.scene(), folder).entrySet()) {
            named.put(file.getKey(), content(file.getValue()));
        }
        Hash textHash = Hash.of(text);
        byte[] bill = new Bill(new Bill.Content(textHash, text.length), named).encode();
        var parcel = new Parcel(take, Hash.of(bill), bill, textHash, text);
        newest.addFirst(parcel);
        if (newest.size() > KEPT) {
            newest.removeLast();
        }
        return parcel;
    }

    private Bill.Content content(Path file) throws IOException {
        Bill.Content content = known.get(file);
        if (content == null) {
            content = new Bill.Content(Hash.of(file), Files.size(file));
            known.put(file, content);
            files.put(content.hash(), file);
        }
        return content;
    }

    /** Some of the content of a hash; none where there is none such, or behind its end. */
    synchronized byte[] part(Hash hash, long offset) {
        for (Parcel parcel : newest) {
            if (parcel.hash().equals(hash)) {
                return part(parcel.bill(), offset);
            }
            if (parcel.textHash().equals(hash)) {
                return part(parcel.text(), offset);
            }
        }
        Path file = files.get(hash);
        return file == null ? new byte[0] : part(file, offset);
    }

    private static byte[] part(byte[] bytes, long offset) {
        int from = (int) Math.min(bytes.length, offset);
        return Arrays.copyOfRange(bytes, from, Math.min(bytes.length, from + Message.PART_BYTES));
    }

    private static byte[] part(Path file, long offset) {
        try (var in = new RandomAccessFile(file.toFile(), "r")) {
            byte[] part = new byte[(int) Math.clamp(in.length() - offset, 0L, Message.PART_BYTES)];
            in.seek(offset);
            in.readFully(part);
            return part;
        } catch (IOException e) {
            // The node tells that it did not come.
            return new byte[0];
        }
    }
}
