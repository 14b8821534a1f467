package lightning.serve;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.TimeUnit;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import lightning.base.work.Await;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.node.ObjectNode;

/** The examples of docs/serve.md: each answer has the documented fields, and their values unless they depend on the machine. */
@Timeout(value = Await.TIMEOUT_SECONDS, unit = TimeUnit.SECONDS)
class ServeDocumentTest {
    private static final Path DOCUMENT = Path.of("docs/serve.md");
    private static final Pattern BLOCK = Pattern.compile("(?ms)^```jsonl\\n(.*?)^```");
    private static final Set<String> OF_THE_MACHINE =
            Set.of("milliseconds", "writing_milliseconds", "path", "version", "memory", "rays", "file", "url");

    @TempDir
    private Path folder;

    private static List<String> blocks() throws IOException {
        return BLOCK.matcher(Files.readString(DOCUMENT)).results().map(block -> block.group(1)).toList();
    }

    @Test
    void examples_areAnsweredAsDocumented() throws IOException {
        List<String> blocks = blocks();
        assertThat(blocks).hasSize(4);
        run(blocks.get(0) + blocks.get(1) + blocks.get(2));
        run(blocks.get(3));
    }

    private void run(String example) throws IOException {
        try (Server server = new Server(new ServerOptions(1, 500_000_000)); TestClient client = new TestClient(server)) {
            for (String line : example.lines().toList()) {
                if (line.startsWith("> ")) {
                    client.sendLine(inFolder((ObjectNode) JsonLines.JSON.readTree(line.substring(2))).toString());
                } else {
                    assertSame(line, JsonLines.JSON.readTree(line.substring(2)), client.read());
                }
            }
        }
    }

    /** Lets files be written into the test's folder. */
    private ObjectNode inFolder(ObjectNode request) {
        return request.has("file") && !request.get("method").stringValue().equals("open")
                ? request.put("file", folder.resolve(request.get("file").stringValue()).toString()) : request;
    }

    private static void assertSame(String line, JsonNode documented, JsonNode answer) {
        if (documented.isObject()) {
            assertThat(answer.propertyNames()).as(line).containsExactlyElementsOf(documented.propertyNames());
            for (String name : documented.propertyNames()) {
                if (!OF_THE_MACHINE.contains(name) || documented.get(name).isObject()) {
                    assertSame(line, documented.get(name), answer.get(name));
                }
            }
        } else {
            assertThat(answer).as(line).hasToString(documented.toString());
        }
    }

    @Test
    void everyMethodFieldAndCode_isDocumented() throws IOException {
        String text = Files.readString(DOCUMENT);
        String examples = String.join("", blocks());
        for (Method method : Method.values()) {
            assertThat(examples).contains("\"method\": \"" + method.text() + "\"");
            String row = text.lines().filter(line -> line.startsWith("| ") && line.split("\\|")[1].contains("`" + method.text() + "`"))
                    .findFirst().orElseThrow();
            Set<String> fields = new TreeSet<>(method.fields());
            fields.removeAll(Set.of("id", "method"));
            assertThat(fields).as(row).allSatisfy(field -> assertThat(row).contains("`" + field + "`"));
        }
        assertThat(Stream.of(ErrorCode.values()).map(ErrorCode::text)).allSatisfy(code -> assertThat(text).contains("| `" + code + "` |"));
        assertThat(Arrays.asList(JsonLines.MAX_LINE, Client.MAX_WAITING, SocketListener.MAX_CLIENTS, Server.MAX_SCENES,
                SceneEditing.MAX_STEPS)).containsExactly(4 << 20, 64, 32, 100, 10_000);
    }
}
