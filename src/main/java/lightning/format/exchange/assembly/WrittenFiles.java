package lightning.format.exchange.assembly;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import lightning.base.file.ContentHash;
import lightning.base.file.RegularFile;

/**
 * Files that an import wrote next to a scene, with their hashes. A comment of the scene file stores each, so that the record changes in the
 * same step as the scene. A file with another hash belongs to the user.
 */
record WrittenFiles(Map<String, ContentHash> hashes) {
    private static final Pattern COMMENT = Pattern.compile("# wrote: ([0-9a-f]{64}) ([^<>]+?)( < [^<>]+)?");
    /** Larger files are no scene files of this program. */
    private static final int MAX_SCENE_BYTES = 256 << 20;

    /** Returns what the comments of a scene file say; nothing if it cannot be read. */
    static WrittenFiles findIn(Path sceneFile) {
        Map<String, ContentHash> hashes = new HashMap<>();
        try {
            if (Files.isRegularFile(sceneFile)) {
                String text = new String(RegularFile.readBytes(sceneFile, "a scene", MAX_SCENE_BYTES), StandardCharsets.UTF_8);
                text.lines().map(COMMENT::matcher).filter(Matcher::matches)
                        .forEach(comment -> hashes.put(comment.group(2), new ContentHash(comment.group(1))));
            }
        } catch (IOException e) {
            // Without a record, all files belong to the user.
        }
        return new WrittenFiles(hashes);
    }

    /**
     * Returns the comment of a file.
     *
     * @param source name of the file in the imported one
     */
    static String comment(String name, String source, ContentHash hash) {
        return "wrote: " + hash.hex() + " " + name + (name.equals(source) ? "" : " < " + source);
    }

    /** Returns whether a file of this name is as an import wrote it. */
    boolean contains(String name, Path file) throws IOException {
        return hashes.containsKey(name) && Files.isRegularFile(file, LinkOption.NOFOLLOW_LINKS)
                && ContentHash.of(file).equals(hashes.get(name));
    }
}
