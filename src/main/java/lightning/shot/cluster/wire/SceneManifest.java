package lightning.shot.cluster.wire;

import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import lightning.base.file.ContentHash;

/**
 * Manifest of a revision: its scene text and the files that this names.
 *
 * @param text  the scene's text with its keyframes
 * @param files files by their names in the text, at most {@value #MAX_FILES}
 */
public record SceneManifest(Content text, SortedMap<String, Content> files) {
    /** More than a scene may have. */
    public static final int MAX_FILES = 1000;
    /** Maximum bytes of an encoded manifest. */
    public static final int MAX_BYTES = 1 << 20;
    private static final int NAME_BYTES = 800;

    /**
     * Content identified by its hash.
     *
     * @param bytes its length
     */
    public record Content(ContentHash hash, long bytes) {}

    /** Encodes the manifest, at most {@value #MAX_BYTES} bytes. */
    public byte[] encode() {
        var out = new WireWriter();
        out.unsignedByte(MessageCodec.VERSION).hash(text.hash()).int64(text.bytes()).int32(files.size());
        for (Map.Entry<String, Content> file : files.entrySet()) {
            out.text(file.getKey(), NAME_BYTES).hash(file.getValue().hash()).int64(file.getValue().bytes());
        }
        return out.toBytes();
    }

    /** @throws WireException if the bytes are not exactly one manifest */
    public static SceneManifest decode(byte[] bytes) throws WireException {
        var in = new WireReader(bytes);
        int version = in.unsignedByte("the version");
        if (version != MessageCodec.VERSION) {
            throw WireReader.invalid(0, "the version", String.valueOf(MessageCodec.VERSION), version);
        }
        Content text = content(in);
        int count = in.int32("the number of files", MAX_FILES);
        SortedMap<String, Content> files = new TreeMap<>();
        for (int i = 0; i < count; i++) {
            files.put(in.text("a file's name", NAME_BYTES), content(in));
        }
        in.requireEnd();
        return new SceneManifest(text, files);
    }

    private static Content content(WireReader in) throws WireException {
        return new Content(in.hash("a hash"), in.int64("a length"));
    }
}
