package lightning.file;

import java.io.IOException;
import java.nio.file.DirectoryIteratorException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.Map;
import java.util.UUID;
import java.util.concurrent.ConcurrentHashMap;
import java.util.regex.Pattern;

/**
 * Names of temporary files: {@code .lightning-} and a number that is drawn once, so that their length does not depend on
 * the file that they become, and no other program has them.
 *
 * <p>A process that is killed leaves its temporary file behind. One that nobody has written to for an hour is removed when
 * this process first writes into that folder, or next writes there an hour later; a folder of many pictures is not
 * listed for each of them.
 */
final class TemporaryFile {
    static final Duration LEFT_BEHIND = Duration.ofHours(1);

    private static final Pattern OURS = Pattern.compile("\\.lightning-[0-9a-f]{8}(-[0-9a-f]{4}){3}-[0-9a-f]{12}\\.tmp");
    private static final Map<Path, Instant> LOOKED = new ConcurrentHashMap<>();

    private TemporaryFile() {}

    /** A name in a folder that no file has. */
    static Path in(Path folder) {
        return folder.resolve(".lightning-" + UUID.randomUUID() + ".tmp");
    }

    /** Removes what was left behind, unless the folder was looked through within the hour. Never fails. */
    static void removeLeftIn(Path folder) {
        Instant now = Instant.now();
        Instant before = LOOKED.get(folder);
        if (before != null && now.isBefore(before.plus(LEFT_BEHIND))) {
            return;
        }
        LOOKED.put(folder, now);
        try (DirectoryStream<Path> ours = Files.newDirectoryStream(folder, TemporaryFile::isOurs)) {
            for (Path file : ours) {
                removeIfLeft(file, now);
            }
        } catch (IOException | DirectoryIteratorException e) {
            // A folder that cannot be listed can still be written.
        }
    }

    private static boolean isOurs(Path file) {
        return OURS.matcher(file.getFileName().toString()).matches()
                && Files.isRegularFile(file, LinkOption.NOFOLLOW_LINKS);
    }

    private static void removeIfLeft(Path file, Instant now) {
        try {
            if (Files.getLastModifiedTime(file).toInstant().plus(LEFT_BEHIND).isBefore(now)) {
                Files.deleteIfExists(file);
            }
        } catch (IOException e) {
            // Somebody else's, or gone by now.
        }
    }
}
