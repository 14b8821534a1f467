package lightning.bench;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.stream.IntStream;

/**
 * Processor time from Linux counters, in ticks of 10 ms.
 *
 * @param own      time of this process, all threads
 * @param children time of its child processes that have ended
 * @param busy     busy time of all processors, including time stolen by the host
 * @param all      total time of all processors, idle or busy
 */
record ProcessorTime(long own, long children, long busy, long all) {
    static final double TICK_MS = 10;
    private static final Path PROCESS_STAT = Path.of("/proc/self/stat");
    private static final Path SYSTEM_STAT = Path.of("/proc/stat");
    /** Field indices in {@link #PROCESS_STAT} after the program's name: user and kernel time, then those of children. */
    private static final int USER = 11;
    /** Field indices in the first line of {@link #SYSTEM_STAT}: user, nice, system, idle, I/O wait, two of interrupts, stolen. */
    private static final int IDLE = 3;
    private static final int IO_WAIT = 4;
    private static final int FIELD_COUNT = 8;

    /** Returns the current time; empty if the system does not report it. */
    static Optional<ProcessorTime> now() {
        try {
            return Optional.of(parse(Files.readString(PROCESS_STAT), Files.readString(SYSTEM_STAT)));
        } catch (IOException | RuntimeException e) {
            return Optional.empty();
        }
    }

    /** Parses the text of both files. */
    static ProcessorTime parse(String process, String machine) {
        long[] processTicks = numbers(process.substring(process.lastIndexOf(')') + 2), USER, USER + 4);
        long[] systemTicks = numbers(machine.lines().findFirst().orElseThrow().replaceFirst("cpu +", ""), 0, FIELD_COUNT);
        long total = IntStream.range(0, FIELD_COUNT).mapToLong(i -> systemTicks[i]).sum();
        return new ProcessorTime(processTicks[0] + processTicks[1], processTicks[2] + processTicks[3],
                total - systemTicks[IDLE] - systemTicks[IO_WAIT], total);
    }

    private static long[] numbers(String text, int from, int to) {
        String[] words = text.split(" ");
        return IntStream.range(from, to).mapToLong(i -> Long.parseLong(words[i])).toArray();
    }

    /** Returns the share, 0…1, of the machine's processor time since {@code start} that other processes used. */
    double otherShareSince(ProcessorTime start) {
        long ownTicks = own + children - start.own - start.children;
        long elapsedTicks = all - start.all;
        return elapsedTicks <= 0 ? 0 : Math.clamp((double) (busy - start.busy - ownTicks) / elapsedTicks, 0, 1);
    }
}
