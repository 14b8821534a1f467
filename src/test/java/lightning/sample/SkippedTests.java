package lightning.sample;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Optional;
import org.junit.platform.engine.TestExecutionResult;
import org.junit.platform.engine.support.descriptor.ClassSource;
import org.junit.platform.engine.support.descriptor.MethodSource;
import org.junit.platform.launcher.TestExecutionListener;
import org.junit.platform.launcher.TestIdentifier;

/**
 * Records each skipped test, or class of tests: a line {@code class#test: reason} in {@code target/skipped-tests/PROCESS}. Tests are skipped by
 * a failed assumption, such as a missing program, and by an annotation, such as one for another system.
 */
public final class SkippedTests implements TestExecutionListener {
    private static final String ASSUMPTION = "Assumption failed: ";
    private final Path file;

    /** For the service of JUnit. */
    public SkippedTests() {
        this(Path.of("target/skipped-tests/" + ProcessHandle.current().pid()));
    }

    SkippedTests(Path file) {
        this.file = file;
    }

    @Override
    public void executionSkipped(TestIdentifier test, String reason) {
        record(test, reason);
    }

    @Override
    public void executionFinished(TestIdentifier test, TestExecutionResult result) {
        if (result.getStatus() == TestExecutionResult.Status.ABORTED) {
            record(test, result.getThrowable().map(Throwable::getMessage).orElse("aborted"));
        }
    }

    private void record(TestIdentifier test, String reason) {
        try {
            Files.createDirectories(file.getParent());
            Files.writeString(file, line(test, reason), StandardOpenOption.CREATE, StandardOpenOption.APPEND);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Returns the line of a test, with its parameters if it has any. */
    private static String line(TestIdentifier test, String reason) {
        String name = test.getSource().flatMap(source -> switch (source) {
            case MethodSource method -> Optional.of(method.getClassName() + "#" + method.getMethodName());
            case ClassSource type -> Optional.of(type.getClassName());
            default -> Optional.empty();
        }).orElse(test.getUniqueId());
        String run = test.getDisplayName().startsWith("[") ? " " + test.getDisplayName() : "";
        return (name + run + ": " + (reason.startsWith(ASSUMPTION) ? reason.substring(ASSUMPTION.length()) : reason))
                .replaceAll("\\s+", " ").strip() + "\n";
    }
}
