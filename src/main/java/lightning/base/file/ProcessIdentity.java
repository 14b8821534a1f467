package lightning.base.file;

import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A process of this machine, by its number and the moment that it started: the system gives the numbers of ended processes to
 * new ones.
 *
 * @param pid    its number
 * @param startMillis when it started, in milliseconds since 1970; 0 where the system does not say
 */
public record ProcessIdentity(long pid, long startMillis) {
    /** What {@link #toString} writes. */
    static final String REGEX = "\\d{1,18}(?:-\\d{1,18})?";

    private static final Pattern PATTERN = Pattern.compile("(\\d{1,18})(?:-(\\d{1,18}))?");
    /** Two processes may compute different starts of a third: the system counts from its own start, by a clock that is corrected. */
    private static final long CLOCK_TOLERANCE_MILLIS = 60_000;

    /** Returns the process that runs this. */
    public static ProcessIdentity current() {
        return of(ProcessHandle.current());
    }

    private static ProcessIdentity of(ProcessHandle handle) {
        return new ProcessIdentity(handle.pid(), handle.info().startInstant().map(start -> start.toEpochMilli()).orElse(0L));
    }

    /** Returns the process that {@link #toString} wrote; empty for any other text. */
    public static Optional<ProcessIdentity> parse(String text) {
        Matcher parts = PATTERN.matcher(text);
        return parts.matches()
                ? Optional.of(
                        new ProcessIdentity(Long.parseLong(parts.group(1)), parts.group(2) == null ? 0 : Long.parseLong(parts.group(2))))
                : Optional.empty();
    }

    /** Returns whether it still runs; where the system does not say when a process of its number started, that counts as it. */
    public boolean isRunning() {
        if (pid == ProcessHandle.current().pid()) {
            return equals(current());
        }
        return ProcessHandle.of(pid).filter(ProcessHandle::isAlive).map(ProcessIdentity::of)
                .filter(now -> startMillis == 0 || now.startMillis - startMillis < CLOCK_TOLERANCE_MILLIS).isPresent();
    }

    /** The number, and behind a hyphen the start where it is known: digits alone. */
    @Override
    public String toString() {
        return startMillis == 0 ? Long.toString(pid) : pid + "-" + startMillis;
    }
}
