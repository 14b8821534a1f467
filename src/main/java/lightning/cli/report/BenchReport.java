package lightning.cli.report;

import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * A benchmark.
 *
 * @param folder   folder of report and results
 * @param scenes   number of measured scenes; absent with {@code --report}, as the next two
 * @param problems promises that were not kept, and scenes that were not read
 * @param worse    what is slower or less accurate than the baseline; absent without one
 */
public record BenchReport(String folder, String report, String results, @Nullable Integer scenes, @Nullable List<String> problems,
        @Nullable List<String> worse) {}
