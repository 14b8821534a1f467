package lightning.sample;

import com.sun.management.OperatingSystemMXBean;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.IntStream;
import org.junit.platform.engine.TestExecutionResult;
import org.junit.platform.engine.support.descriptor.ClassSource;
import org.junit.platform.launcher.TestExecutionListener;
import org.junit.platform.launcher.TestIdentifier;
import org.junit.platform.launcher.TestPlan;

/**
 * Records what each test class costs: a line {@code seconds class programs elapsed} in {@code target/processor-times/PROCESS}.
 * {@code sort -rn target/processor-times/*} lists the slowest first.
 *
 * <p>{@code seconds} is the processor time of the whole Java process, with its compilers and its garbage collector, and of the programs
 * that it started. {@code programs} is the share of the programs; 0 on systems other than Linux.
 * {@code elapsed} is the wall time, which depends on what else runs.
 */
public final class ProcessorTimes implements TestExecutionListener {
    private static final OperatingSystemMXBean SYSTEM = ManagementFactory.getPlatformMXBean(OperatingSystemMXBean.class);
    /** Fields after the name of the program: processor time in user mode and in the kernel, and that of ended programs; proc_pid_stat(5). */
    private static final int OWN = 11;
    private static final int ENDED = 13;
    private static final int END = 15;
    private static final double TICKS_PER_SECOND = 100;

    /**
     * Times since the start of the process, seconds.
     *
     * @param own processor time of this process
     * @param programs processor time of the programs
     * @param elapsed wall time since an arbitrary moment
     */
    private record Times(double own, double programs, double elapsed) {
        static Times now() {
            return new Times(SYSTEM.getProcessCpuTime() * 1e-9, ofPrograms(), System.nanoTime() * 1e-9);
        }

        private static double ofPrograms() {
            ProcessHandle self = ProcessHandle.current();
            return (ticks(self, ENDED) + self.descendants().mapToLong(p -> ticks(p, OWN)).sum()) / TICKS_PER_SECOND;
        }

        /** Returns the sum of the fields from one on; 0 if the process has ended just now, or the system has none. */
        private static long ticks(ProcessHandle process, int first) {
            try {
                String line = Files.readString(Path.of("/proc/" + process.pid() + "/stat"));
                String[] fields = line.substring(line.lastIndexOf(')') + 2).split(" ");
                return IntStream.range(first, END).mapToLong(i -> Long.parseLong(fields[i])).sum();
            } catch (IOException e) {
                return 0;
            }
        }
    }

    private Times last = Times.now();
    private TestPlan plan;

    @Override
    public void testPlanExecutionStarted(TestPlan plan) {
        this.plan = plan;
    }

    /** Also counts what happened since the end of the previous class, such as the search for tests. */
    @Override
    public void executionFinished(TestIdentifier test, TestExecutionResult result) {
        if (isTopLevel(test)) {
            className(test).ifPresent(this::record);
        }
    }

    private boolean isTopLevel(TestIdentifier test) {
        return plan.getParent(test).map(parent -> plan.getParent(parent).isEmpty()).orElse(false);
    }

    private void record(String name) {
        Times now = Times.now();
        double programs = now.programs() - last.programs();
        Path file = Path.of("target/processor-times/" + ProcessHandle.current().pid());
        try {
            Files.createDirectories(file.getParent());
            Files.writeString(file, String.format(Locale.ROOT, "%.2f %s %.2f %.2f%n", now.own() - last.own() + programs, name, programs,
                    now.elapsed() - last.elapsed()), StandardOpenOption.CREATE, StandardOpenOption.APPEND);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        last = now;
    }

    private static Optional<String> className(TestIdentifier test) {
        return test.getSource().filter(ClassSource.class::isInstance).map(source -> ((ClassSource) source).getClassName());
    }
}
