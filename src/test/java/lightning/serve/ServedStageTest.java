package lightning.serve;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import lightning.base.work.Await;
import lightning.format.usd.NestedStages;
import lightning.sample.PythonPrograms;
import lightning.sample.Slow;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** USD stages that a server opens: the converter ends with the request. */
@Slow
@DisabledOnOs(OS.WINDOWS)
@Timeout(value = Await.TIMEOUT_SECONDS, unit = TimeUnit.SECONDS)
class ServedStageTest {
    @TempDir
    private Path folder;

    @BeforeEach
    void requireUsd() {
        PythonPrograms.require("pxr");
    }

    /** Returns the converter that reads a stage, and its reader. Others may wait for a stage. */
    private static List<ProcessHandle> converters() {
        return ProcessHandle.current().children().filter(p -> p.info().commandLine().orElse("").contains("lightning_usd"))
                .filter(p -> p.children().findAny().isPresent()).flatMap(p -> Stream.concat(Stream.of(p), p.children())).toList();
    }

    private static List<ProcessHandle> startedConverters() throws InterruptedException {
        List<ProcessHandle> started = converters();
        while (started.size() < 2) {
            Thread.sleep(20);
            started = converters();
        }
        return started;
    }

    private String open() throws Exception {
        return "'file':'" + NestedStages.write(folder.resolve("slow.usda"), 6) + "','output':'" + folder.resolve("slow.jen") + "'";
    }

    @Test
    void cancel_endsImport() throws Exception {
        try (Server server = new Server(new ServerOptions(1, 500_000_000)); TestClient client = new TestClient(server)) {
            int request = client.send("open", open());
            List<ProcessHandle> converters = startedConverters();
            assertThat(client.request("cancel", "'request':" + request).get("canceled").asBoolean()).isTrue();
            assertThat(Stream.concat(client.others().stream(), Stream.of(client.answer(client.send("list", "")))).toList().toString())
                    .contains("version");
            Await.untilEnded(converters);
        }
    }

    @Test
    void clientThatIsGone_endsImport() throws Exception {
        try (Server server = new Server(new ServerOptions(1, 500_000_000)); TestClient client = new TestClient(server)) {
            client.send("open", open());
            List<ProcessHandle> converters = startedConverters();
            client.close();
            Await.untilEnded(converters);
        }
    }

    @Test
    void closedServer_endsImport() throws Exception {
        List<ProcessHandle> converters;
        try (Server server = new Server(new ServerOptions(1, 500_000_000)); TestClient client = new TestClient(server)) {
            client.send("open", open());
            converters = startedConverters();
        }
        Await.untilEnded(converters);
    }
}
