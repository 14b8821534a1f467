package lightning.shot.cluster.wire;

import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;

/**
 * What a take is made of: its text, and the files that this names, each under its name there.
 *
 * @param text  the scene's text with its keys
 * @param files by the names that the text writes, at most {@value #MOST_FILES}
 */
public record Bill(Content text, SortedMap<String, Content> files) {
    /** More than a scene may have. */
    public static final int MOST_FILES = 1000;
    private static final int NAME_BYTES = 800;

    /**
     * Something of which a bill knows the hash.
     *
     * @param bytes its length
     */
    public record Content(Hash hash, long bytes) {}

    /** The bill's own bytes, at most {@link Message#PART_BYTES}. */
    public byte[] encode() {
        var to = new WireSink();
        to.octet(Codec.VERSION).hash(text.hash()).large(text.bytes()).number(files.size());
        for (Map.Entry<String, Content> file : files.entrySet()) {
            to.text(file.getKey(), NAME_BYTES).hash(file.getValue().hash()).large(file.getValue().bytes());
        }
        return to.toBytes();
    }

    /** @throws WireException if the bytes are no bill, whole and nothing behind */
    public static Bill decode(byte[] bytes) throws WireException {
        var from = new WireSource(bytes);
        int version = from.octet("the version");
        if (version != Codec.VERSION) {
            throw WireSource.wrong(0, "the version", String.valueOf(Codec.VERSION), version);
        }
        Content text = content(from);
        int count = from.number("the number of files", MOST_FILES);
        SortedMap<String, Content> files = new TreeMap<>();
        for (int i = 0; i < count; i++) {
            files.put(from.text("a file's name", NAME_BYTES), content(from));
        }
        from.end();
        return new Bill(text, files);
    }

    private static Content content(WireSource from) throws WireException {
        return new Content(from.hash("a hash"), from.large("a length"));
    }
}
