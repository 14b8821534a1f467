package lightning.serve;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import lightning.base.work.Await;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import tools.jackson.databind.JsonNode;

/** Requests that write files next to those of users and of other programs. */
@Timeout(value = Await.TIMEOUT_SECONDS, unit = TimeUnit.SECONDS)
class ServedFilesTest {
    @TempDir
    private Path folder;
    private Path file;
    private Server server;
    private TestClient client;

    @BeforeEach
    void start() throws IOException {
        file = folder.resolve("in.jen");
        Files.copy(Path.of("textures/checker.png"), folder.resolve("tex.png"));
        Files.writeString(file, "jen 1\npicture { size 8 8 }\nmaterial m { texture \"tex.png\" }\nsphere s { material m }\n"
                + "light k point { at 0 3 3 }\n");
        server = new Server(new ServerOptions(2, 500_000_000));
        client = new TestClient(server);
    }

    @AfterEach
    void end() throws IOException {
        client.close();
        server.close();
    }

    private JsonNode open() throws IOException {
        return client.request("open", "'file':'" + file + "'");
    }

    private String save(Path to, String fields) throws IOException {
        client.request("set", "'scene':1,'edits':'k.intensity=2'");
        return client.answer(client.send("save", "'scene':1,'file':'" + to + "'" + fields)).toString();
    }

    @Test
    void save_refusesFileChangedByAnotherProgram() throws Exception {
        open();
        Files.writeString(file, "# edited by another program\n", StandardOpenOption.APPEND);
        assertThat(save(file, "")).contains("was changed by another program").contains("overwrite");
        assertThat(save(folder.resolve("./in.jen"), "")).contains("was changed by another program");
        assertThat(file).content().contains("edited by another program");
        assertThat(save(file, ",'overwrite':true")).contains("result");
        assertThat(file).content().contains("intensity 2").doesNotContain("edited by another program");
    }

    @Test
    void saveAgain_isAllowedUntilAnotherProgramChangesTheFile() throws Exception {
        open();
        Path copy = folder.resolve("copy.jen");
        for (Path to : List.of(file, copy)) {
            assertThat(save(to, "")).contains("result");
            assertThat(save(to, "")).contains("result");
            Files.writeString(to, "# edited\n", StandardOpenOption.APPEND);
            assertThat(save(to, "")).contains("was changed by another program");
            Files.delete(to);
            assertThat(save(to, "")).contains("result");
        }
    }

    @Test
    void fileOfScene_isNeverReplaced() throws Exception {
        byte[] before = Files.readAllBytes(folder.resolve("tex.png"));
        open();
        assertThat(client.answer(client.send("render", "'scene':1,'file':'" + folder.resolve("tex.png") + "'")).toString())
                .contains("is read by this command and would be replaced");
        Files.createSymbolicLink(folder.resolve("link.jen"), Path.of("tex.png"));
        assertThat(save(folder.resolve("link.jen"), "")).contains("is read by this command and would be replaced");
        assertThat(folder.resolve("tex.png")).hasBinaryContent(before);
    }

    @Test
    @EnabledOnOs(OS.LINUX)
    void manyNamedPictures_holdNoFileHandles() throws Exception {
        open();
        client.request("render", "'scene':1,'memory':true");
        long before = handles();
        for (int i = 0; i < 50; i++) {
            assertThat(client.answer(client.send("render", "'scene':1,'memory':'" + folder.resolve("m" + i) + "'")).toString())
                    .contains("result");
        }
        assertThat(handles()).isLessThan(before + 25);
    }

    private static long handles() throws IOException {
        try (Stream<Path> handles = Files.list(Path.of("/proc/self/fd"))) {
            return handles.count();
        }
    }

    @Test
    void memoryPathOfUser_isNeverReplaced() throws Exception {
        open();
        Path mine = Files.writeString(folder.resolve("mine"), "mine");
        assertThat(client.answer(client.send("render", "'scene':1,'memory':'" + mine + "'")).toString()).contains("exists already");
        assertThat(mine).hasContent("mine");
    }
}
