package lightning.base.file;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Process of this machine, by process id and start time, because the system reuses ids.
 *
 * @param pid         process id
 * @param startMillis start in milliseconds since 1970; 0 if unknown
 */
public record ProcessIdentity(long pid, long startMillis) {
    /** Pattern of {@link #toString}. */
    static final String REGEX = "\\d{1,18}(?:-\\d{1,18})?";

    private static final Pattern PATTERN = Pattern.compile("(\\d{1,18})(?:-(\\d{1,18}))?");
    private static final Pattern ZOMBIE = Pattern.compile(" [ZX] ");
    /** Two processes may compute different start times for a third: the system counts from its own start, by a clock that is adjusted. */
    private static final long CLOCK_TOLERANCE_MILLIS = 60_000;

    /** Returns the current process. */
    public static ProcessIdentity current() {
        return of(ProcessHandle.current());
    }

    private static ProcessIdentity of(ProcessHandle handle) {
        return new ProcessIdentity(handle.pid(), handle.info().startInstant().map(start -> start.toEpochMilli()).orElse(0L));
    }

    /** Parses the output of {@link #toString}; empty for any other text. */
    public static Optional<ProcessIdentity> parse(String text) {
        Matcher parts = PATTERN.matcher(text);
        return parts.matches()
                ? Optional.of(
                        new ProcessIdentity(Long.parseLong(parts.group(1)), parts.group(2) == null ? 0 : Long.parseLong(parts.group(2))))
                : Optional.empty();
    }

    /**
     * Returns whether the process still runs. A zombie, which ended and whose parent has not asked for its exit code, does not. If the start
     * time is unknown, any process with this id counts.
     */
    public boolean isRunning() {
        if (pid == ProcessHandle.current().pid()) {
            return equals(current());
        }
        return ProcessHandle.of(pid).filter(ProcessHandle::isAlive).map(ProcessIdentity::of)
                .filter(now -> startMillis == 0 || now.startMillis - startMillis < CLOCK_TOLERANCE_MILLIS).isPresent() && !isZombie();
    }

    /** Reads the state from Linux's process information: the letter after the name in parentheses, which may contain any character. */
    private boolean isZombie() {
        Path stat = Path.of("/proc/" + pid + "/stat");
        try {
            String line = Files.isReadable(stat) ? Files.readString(stat, StandardCharsets.ISO_8859_1) : "";
            return ZOMBIE.matcher(line.substring(line.lastIndexOf(')') + 1)).lookingAt();
        } catch (IOException e) {
            // The process ended meanwhile.
            return true;
        }
    }

    /** Returns the id and, if known, a hyphen and the start time. */
    @Override
    public String toString() {
        return startMillis == 0 ? Long.toString(pid) : pid + "-" + startMillis;
    }
}
