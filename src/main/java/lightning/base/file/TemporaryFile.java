package lightning.base.file;

import java.io.IOException;
import java.nio.file.DirectoryIteratorException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.Map;
import java.util.Optional;
import java.util.UUID;
import java.util.concurrent.ConcurrentHashMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Names of temporary files: {@code .lightning-}, the process that writes the file, and a random number. Their length does
 * not depend on the file that they become, and no other program has them.
 *
 * <p>A process that is killed leaves its temporary file. Another removes it, when it first writes into that folder or next
 * writes there an hour later, if the owner has ended and the file was not written for an hour; a file whose owner cannot be
 * looked up, if it was not written for 30 days. A folder of many pictures is not listed for each of them.
 */
final class TemporaryFile {
    private static final Duration STALE_AFTER = Duration.ofHours(1);
    private static final Duration UNKNOWN_OWNER_STALE_AFTER = Duration.ofDays(30);

    /** With an owner, or as older releases wrote it. */
    private static final Pattern NAME_PATTERN = Pattern.compile("\\.lightning-(?:([0-9a-f]{8})-(" + ProcessIdentity.REGEX
            + ")-[0-9a-f]{16}|[0-9a-f]{8}(?:-[0-9a-f]{4}){3}-[0-9a-f]{12})\\.tmp");
    private static final Map<Path, Instant> LAST_SCANS = new ConcurrentHashMap<>();

    private TemporaryFile() {}

    /**
     * A process that writes a temporary file.
     *
     * @param realm   the machine and user, as {@link ProcessNamespace} names them
     * @param process its number there
     */
    record Owner(String realm, ProcessIdentity process) {
        static final Owner SELF = new Owner(ProcessNamespace.NAME, ProcessIdentity.current());

        /** A name in a folder that no file has. */
        Path newPath(Path folder) {
            String random = UUID.randomUUID().toString().replace("-", "").substring(16);
            return folder.resolve(".lightning-" + realm + "-" + process + "-" + random + ".tmp");
        }

        boolean isKnown() {
            return realm.equals(SELF.realm);
        }
    }

    /** A name in a folder that no file has, of a file of this process. */
    static Path newPath(Path folder) {
        return Owner.SELF.newPath(folder);
    }

    /** Removes what was left behind, unless the folder was looked through within the hour. Never fails. */
    static void removeStaleIn(Path folder) {
        Instant now = Instant.now();
        Instant lastScan = LAST_SCANS.get(folder);
        if (lastScan != null && now.isBefore(lastScan.plus(STALE_AFTER))) {
            return;
        }
        LAST_SCANS.put(folder, now);
        try (DirectoryStream<Path> files = Files.newDirectoryStream(folder)) {
            for (Path file : files) {
                Matcher matcher = NAME_PATTERN.matcher(file.getFileName().toString());
                if (matcher.matches() && Files.isRegularFile(file, LinkOption.NOFOLLOW_LINKS)) {
                    removeIfStale(file, owner(matcher), now);
                }
            }
        } catch (IOException | DirectoryIteratorException e) {
            // A folder that cannot be listed can still be written.
        }
    }

    /** The owner that a name tells, if it is one that can be looked up here. */
    private static Optional<Owner> owner(Matcher matcher) {
        return Optional.ofNullable(matcher.group(1))
                .flatMap(realm -> ProcessIdentity.parse(matcher.group(2)).map(process -> new Owner(realm, process))).filter(Owner::isKnown);
    }

    private static void removeIfStale(Path file, Optional<Owner> owner, Instant now) {
        try {
            Instant lastModified = Files.getLastModifiedTime(file).toInstant();
            if (lastModified.plus(owner.isPresent() ? STALE_AFTER : UNKNOWN_OWNER_STALE_AFTER).isBefore(now)
                    && owner.filter(known -> known.process().isRunning()).isEmpty()) {
                Files.deleteIfExists(file);
            }
        } catch (IOException e) {
            // Somebody else's, or gone by now.
        }
    }
}
