package lightning.base.file;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests which temporary files are removed. */
class TemporaryFileTest {
    @TempDir
    private Path folder;

    @Test
    void fileOfRunningProcess_isNotRemoved() throws Exception {
        Process other = slowWriter();
        try {
            Path half = temporary().getFirst();
            AtomicFile.write(folder.resolve("picture"), out -> out.write(1));
            assertThat(half).hasContent("first");
            other.outputWriter().append('\n').close();
            assertThat(other.waitFor()).isZero();
            assertThat(folder.resolve("film")).hasContent("whole");
            assertThat(temporary()).isEmpty();
        } finally {
            other.destroyForcibly();
        }
    }

    @Test
    void fileOfKilledProcess_isRemoved() throws Exception {
        Process other = slowWriter();
        other.destroyForcibly().waitFor();
        assertThat(temporary()).hasSize(1);
        AtomicFile.write(folder.resolve("picture"), out -> out.write(1));
        assertThat(temporary()).isEmpty();
    }

    @Test
    void fileOfKilledProcess_isKeptForAnHour() throws Exception {
        Path young = age(endedProcess().newPath(folder), Duration.ofMinutes(50));
        AtomicFile.write(folder.resolve("picture"), out -> out.write(1));
        assertThat(young).exists();
    }

    @Test
    void reusedProcessId_isNoOwner() throws IOException {
        ProcessIdentity me = ProcessIdentity.current();
        var before =
                new TemporaryFile.Owner(TemporaryFile.Owner.SELF.realm(), new ProcessIdentity(me.pid(), me.startMillis() - 86_400_000));
        Path staleFile = age(before.newPath(folder), Duration.ofHours(2));
        Path mine = age(TemporaryFile.newPath(folder), Duration.ofDays(99));
        AtomicFile.write(folder.resolve("picture"), out -> out.write(1));
        assertThat(staleFile).doesNotExist();
        assertThat(mine).exists();
    }

    /** Processes of another machine cannot be looked up, nor those of an older release without a process id. */
    @Test
    void fileOfUnknownOwner_isKeptForAMonth() throws IOException {
        var elsewhere = new TemporaryFile.Owner("0123abcd", endedProcess().process());
        Path written = age(elsewhere.newPath(folder), Duration.ofDays(29));
        Path staleFile = age(elsewhere.newPath(folder), Duration.ofDays(31));
        Path older = age(folder.resolve(".lightning-00000000-0000-4000-8000-000000000001.tmp"), Duration.ofDays(29));
        Path oldest = age(folder.resolve(".lightning-00000000-0000-4000-8000-000000000002.tmp"), Duration.ofDays(31));
        AtomicFile.write(folder.resolve("picture"), out -> out.write(1));
        assertThat(List.of(written, older)).allSatisfy(file -> assertThat(file).exists());
        assertThat(List.of(staleFile, oldest)).allSatisfy(file -> assertThat(file).doesNotExist());
    }

    /** Returns an owner with an impossible process id. */
    private static TemporaryFile.Owner endedProcess() {
        return new TemporaryFile.Owner(TemporaryFile.Owner.SELF.realm(), new ProcessIdentity(999_999_999_999L, 1));
    }

    private Process slowWriter() throws IOException {
        Process other = new ProcessBuilder(Path.of(System.getProperty("java.home"), "bin", "java").toString(), "-cp",
                System.getProperty("java.class.path"), SlowWriter.class.getName(), folder.resolve("film").toString())
                .redirectError(ProcessBuilder.Redirect.INHERIT).start();
        assertThat(other.inputReader().readLine()).isEqualTo("writing");
        return other;
    }

    private static Path age(Path file, Duration ago) throws IOException {
        Files.writeString(file, "half");
        return Files.setLastModifiedTime(file, FileTime.from(Instant.now().minus(ago)));
    }

    private List<Path> temporary() throws IOException {
        try (Stream<Path> all = Files.list(folder)) {
            return all.filter(file -> file.getFileName().toString().startsWith(".lightning-")).toList();
        }
    }
}
