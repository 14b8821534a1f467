package lightning.editor.window.desktop;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

/** No CI job skips the window test silently. */
class WindowSkipTest {
    @Test
    void otherSystem_isSkippedWithReason() {
        assertThat(WindowSkip.reasonOn("Linux")).isEmpty();
        assertThat(WindowSkip.reasonOn("Windows Server 2025").map(WindowSkip::line))
                .hasValue("::warning title=The window is not tested::the "
                        + "packaged program's window is not tested on Windows Server 2025: the test opens it on a virtual display of X11");
        assertThat(WindowSkip.reasonOn("Mac OS X")).isPresent();
    }

    @Test
    void everyTestJob_treatsSkipAsFailure() throws IOException {
        List<String> workflow = Files.readAllLines(Path.of(".ci/workflow.yml"));
        int[] steps = IntStream.range(0, workflow.size()).filter(i -> workflow.get(i).matches(" +run: mvn .*\\bverify")).toArray();
        assertThat(steps).isNotEmpty();
        for (int step : steps) {
            assertThat(workflow.subList(step + 1, step + 3)).extracting(String::strip).containsExactly("env:",
                    WindowSkip.REQUIRED_VARIABLE + ": 1");
        }
        assertThat(Path.of(".ci/run")).content().contains("export " + WindowSkip.REQUIRED_VARIABLE + "=1\n");
    }
}
