package lightning.sample;

import java.util.List;
import java.util.logging.Filter;
import java.util.logging.LogRecord;

/** Hides log lines that a green run of the tests would print: they describe how the tests run, not a fault. */
public final class KnownLogLines implements Filter {
    private static final List<String> KNOWN = List.of(
            // The tests load JavaFX from the class path.
            "Unsupported JavaFX configuration",
            // Properties have few tries in the usual check.
            "Edge case generation exceeds number of tries",
            // Tests of review pages do not use Selenium's copy of Chromium's protocol, which is older than the browser.
            "Unable to find CDP implementation matching", "Unable to find version of CDP to use for");

    @Override
    public boolean isLoggable(LogRecord line) {
        return line.getMessage() == null || KNOWN.stream().noneMatch(line.getMessage()::startsWith);
    }
}
