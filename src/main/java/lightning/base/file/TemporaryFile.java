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
 * Names of temporary files: {@code .lightning-}, the writing process and a random number. Their length does not depend on the target's
 * name, and no other program uses such names.
 *
 * <p>A killed process leaves its temporary file. Another process removes it at its first write into the folder, or at a write an hour
 * later, if the owner has ended and the file is an hour old. If the owner cannot be looked up, the file must be 30 days old. A folder of
 * many images is not listed for each of them.
 */
final class TemporaryFile {
    private static final Duration STALE_AFTER = Duration.ofHours(1);
    private static final Duration UNKNOWN_OWNER_STALE_AFTER = Duration.ofDays(30);

    /** Name with an owner, or in the format of older releases. */
    private static final Pattern NAME_PATTERN = Pattern.compile("\\.lightning-(?:([0-9a-f]{8})-(" + ProcessIdentity.REGEX
            + ")-[0-9a-f]{16}|[0-9a-f]{8}(?:-[0-9a-f]{4}){3}-[0-9a-f]{12})\\.tmp");
    private static final Map<Path, Instant> LAST_SCANS = new ConcurrentHashMap<>();

    private TemporaryFile() {}

    /**
     * Process that writes a temporary file.
     *
     * @param realm   machine and user, as {@link ProcessNamespace} names them
     * @param process the process there
     */
    record Owner(String realm, ProcessIdentity process) {
        static final Owner SELF = new Owner(ProcessNamespace.NAME, ProcessIdentity.current());

        /** Returns an unused path in a folder. */
        Path newPath(Path folder) {
            String random = UUID.randomUUID().toString().replace("-", "").substring(16);
            return folder.resolve(".lightning-" + realm + "-" + process + "-" + random + ".tmp");
        }

        boolean isKnown() {
            return realm.equals(SELF.realm);
        }
    }

    /** Returns an unused path in a folder for a file of this process. */
    static Path newPath(Path folder) {
        return Owner.SELF.newPath(folder);
    }

    /** Returns whether a file has the name of a temporary file. */
    static boolean isTemporary(Path file) {
        return file.getFileName() != null && NAME_PATTERN.matcher(file.getFileName().toString()).matches();
    }

    /** Removes stale temporary files, unless the folder was scanned within the last hour. Never fails. */
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
            // A folder that cannot be listed may still be writable.
        }
    }

    /** Returns the owner in a file name, if it can be looked up here. */
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
            // Belongs to another user, or is gone by now.
        }
    }
}
