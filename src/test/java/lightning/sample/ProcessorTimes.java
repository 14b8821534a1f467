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
import org.junit.platform.engine.support.descriptor.ClassSource;
import org.junit.platform.launcher.TestExecutionListener;
import org.junit.platform.launcher.TestIdentifier;
import org.junit.platform.launcher.TestPlan;

/**
 * Records what each test class costs: a line {@code seconds class} in {@code target/processor-times/PROCESS}. It counts the
 * processor time of the whole Java process, with its compilers and its garbage collector but without programs that a test starts.
 * {@code sort -rn target/processor-times/*} lists the slowest first.
 */
public final class ProcessorTimes implements TestExecutionListener {
    private static final OperatingSystemMXBean SYSTEM = ManagementFactory.getPlatformMXBean(OperatingSystemMXBean.class);

    private long began;

    @Override
    public void testPlanExecutionStarted(TestPlan plan) {
        began = SYSTEM.getProcessCpuTime();
    }

    /** Each class that Maven runs is a plan of its own. */
    @Override
    public void testPlanExecutionFinished(TestPlan plan) {
        double seconds = (SYSTEM.getProcessCpuTime() - began) * 1e-9;
        String name = plan.getRoots().stream().flatMap(root -> plan.getDescendants(root).stream())
                .flatMap(test -> className(test).stream()).findFirst().orElse("none");
        Path file = Path.of("target/processor-times/" + ProcessHandle.current().pid());
        try {
            Files.createDirectories(file.getParent());
            Files.writeString(file, String.format(Locale.ROOT, "%.2f %s%n", seconds, name), StandardOpenOption.CREATE,
                    StandardOpenOption.APPEND);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static Optional<String> className(TestIdentifier test) {
        return test.getSource().filter(ClassSource.class::isInstance).map(source -> ((ClassSource) source).getClassName());
    }
}
