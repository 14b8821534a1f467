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
    private static final Duration LEFT_BEHIND = Duration.ofHours(1);
    private static final Duration OWNER_UNKNOWN = Duration.ofDays(30);

    /** With an owner, or as older releases wrote it. */
    private static final Pattern OURS = Pattern.compile("\\.lightning-(?:([0-9a-f]{8})-(" + ProcessStart.FORM
            + ")-[0-9a-f]{16}|[0-9a-f]{8}(?:-[0-9a-f]{4}){3}-[0-9a-f]{12})\\.tmp");
    private static final Map<Path, Instant> LOOKED = new ConcurrentHashMap<>();

    private TemporaryFile() {}

    /**
     * A process that writes a temporary file.
     *
     * @param realm   the machine and user, as {@link ProcessRealm} names them
     * @param process its number there
     */
    record Owner(String realm, ProcessStart process) {
        static final Owner ME = new Owner(ProcessRealm.NAME, ProcessStart.ofThisProcess());

        /** A name in a folder that no file has. */
        Path in(Path folder) {
            String random = UUID.randomUUID().toString().replace("-", "").substring(16);
            return folder.resolve(".lightning-" + realm + "-" + process + "-" + random + ".tmp");
        }

        boolean isKnown() {
            return realm.equals(ME.realm);
        }
    }

    /** A name in a folder that no file has, of a file of this process. */
    static Path in(Path folder) {
        return Owner.ME.in(folder);
    }

    /** Removes what was left behind, unless the folder was looked through within the hour. Never fails. */
    static void removeLeftIn(Path folder) {
        Instant now = Instant.now();
        Instant before = LOOKED.get(folder);
        if (before != null && now.isBefore(before.plus(LEFT_BEHIND))) {
            return;
        }
        LOOKED.put(folder, now);
        try (DirectoryStream<Path> all = Files.newDirectoryStream(folder)) {
            for (Path file : all) {
                Matcher ours = OURS.matcher(file.getFileName().toString());
                if (ours.matches() && Files.isRegularFile(file, LinkOption.NOFOLLOW_LINKS)) {
                    removeIfLeft(file, owner(ours), now);
                }
            }
        } catch (IOException | DirectoryIteratorException e) {
            // A folder that cannot be listed can still be written.
        }
    }

    /** The owner that a name tells, if it is one that can be looked up here. */
    private static Optional<Owner> owner(Matcher name) {
        return Optional.ofNullable(name.group(1))
                .flatMap(realm -> ProcessStart.parse(name.group(2)).map(process -> new Owner(realm, process))).filter(Owner::isKnown);
    }

    private static void removeIfLeft(Path file, Optional<Owner> owner, Instant now) {
        try {
            Instant written = Files.getLastModifiedTime(file).toInstant();
            if (written.plus(owner.isPresent() ? LEFT_BEHIND : OWNER_UNKNOWN).isBefore(now)
                    && owner.filter(known -> known.process().isRunning()).isEmpty()) {
                Files.deleteIfExists(file);
            }
        } catch (IOException e) {
            // Somebody else's, or gone by now.
        }
    }
}
