package lightning.bench;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.stream.IntStream;

/**
 * Processor time as Linux counts it, in ticks of a hundredth of a second.
 *
 * @param own      time of this process, all threads
 * @param children time of the processes that it started and that have ended
 * @param busy     time that all processors of the machine worked, or that the machine's host gave to others
 * @param all      time of all processors, idle or not
 */
record ProcessorTime(long own, long children, long busy, long all) {
    static final double TICK_MS = 10;
    private static final Path PROCESS = Path.of("/proc/self/stat");
    private static final Path MACHINE = Path.of("/proc/stat");
    /** Places in {@link #PROCESS} after the program's name: user and kernel time, then the children's. */
    private static final int USER = 11;
    /** Places in the first line of {@link #MACHINE}: user, nice, system, idle, waiting for disks, two of interrupts, stolen. */
    private static final int IDLE = 3;
    private static final int WAITING = 4;
    private static final int COUNTED = 8;

    /** The time until now; empty where the system does not report it. */
    static Optional<ProcessorTime> now() {
        try {
            return Optional.of(of(Files.readString(PROCESS), Files.readString(MACHINE)));
        } catch (IOException | RuntimeException e) {
            return Optional.empty();
        }
    }

    /** Reads it from the text of both files. */
    static ProcessorTime of(String process, String machine) {
        long[] mine = numbers(process.substring(process.lastIndexOf(')') + 2), USER, USER + 4);
        long[] machines = numbers(machine.lines().findFirst().orElseThrow().replaceFirst("cpu +", ""), 0, COUNTED);
        long all = IntStream.range(0, COUNTED).mapToLong(i -> machines[i]).sum();
        return new ProcessorTime(mine[0] + mine[1], mine[2] + mine[3], all - machines[IDLE] - machines[WAITING], all);
    }

    private static long[] numbers(String text, int from, int to) {
        String[] words = text.split(" ");
        return IntStream.range(from, to).mapToLong(i -> Long.parseLong(words[i])).toArray();
    }

    /** The share of the machine's processor time since {@code start} that neither this process nor its children had, 0…1. */
    double othersSince(ProcessorTime start) {
        long mine = own + children - start.own - start.children;
        long passed = all - start.all;
        return passed <= 0 ? 0 : Math.clamp((double) (busy - start.busy - mine) / passed, 0, 1);
    }
}
