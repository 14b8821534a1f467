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

/** Whose temporary files are removed. */
class TemporaryFileTest {
    @TempDir
    private Path folder;

    @Test
    void fileThatAnotherProcessWrites_staysHoweverLongThatTakes() throws Exception {
        Process other = slowWriter();
        try {
            Path half = temporary().getFirst();
            SafeFile.write(folder.resolve("picture"), out -> out.write(1));
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
    void fileOfAKilledProcess_isRemoved() throws Exception {
        Process other = slowWriter();
        other.destroyForcibly().waitFor();
        assertThat(temporary()).hasSize(1);
        SafeFile.write(folder.resolve("picture"), out -> out.write(1));
        assertThat(temporary()).isEmpty();
    }

    @Test
    void fileOfAKilledProcess_staysForAnHour() throws Exception {
        Path young = untouched(gone().in(folder), Duration.ofMinutes(50));
        SafeFile.write(folder.resolve("picture"), out -> out.write(1));
        assertThat(young).exists();
    }

    @Test
    void numberOfALivingProcessThatStartedLater_isNoOwner() throws IOException {
        ProcessStart me = ProcessStart.ofThisProcess();
        var before = new TemporaryFile.Owner(TemporaryFile.Owner.ME.realm(), new ProcessStart(me.pid(), me.millis() - 86_400_000));
        Path left = untouched(before.in(folder), Duration.ofHours(2));
        Path mine = untouched(TemporaryFile.in(folder), Duration.ofDays(99));
        SafeFile.write(folder.resolve("picture"), out -> out.write(1));
        assertThat(left).doesNotExist();
        assertThat(mine).exists();
    }

    /** Another machine's process cannot be looked up here, nor that of an older release, which left no number. */
    @Test
    void fileWhoseOwnerCannotBeLookedUp_staysForAMonth() throws IOException {
        var elsewhere = new TemporaryFile.Owner("0123abcd", gone().process());
        Path written = untouched(elsewhere.in(folder), Duration.ofDays(29));
        Path left = untouched(elsewhere.in(folder), Duration.ofDays(31));
        Path older = untouched(folder.resolve(".lightning-00000000-0000-4000-8000-000000000001.tmp"), Duration.ofDays(29));
        Path oldest = untouched(folder.resolve(".lightning-00000000-0000-4000-8000-000000000002.tmp"), Duration.ofDays(31));
        SafeFile.write(folder.resolve("picture"), out -> out.write(1));
        assertThat(List.of(written, older)).allSatisfy(file -> assertThat(file).exists());
        assertThat(List.of(left, oldest)).allSatisfy(file -> assertThat(file).doesNotExist());
    }

    /** No process has this number: it is beyond what any system hands out. */
    private static TemporaryFile.Owner gone() {
        return new TemporaryFile.Owner(TemporaryFile.Owner.ME.realm(), new ProcessStart(999_999_999_999L, 1));
    }

    private Process slowWriter() throws IOException {
        Process other = new ProcessBuilder(Path.of(System.getProperty("java.home"), "bin", "java").toString(), "-cp",
                System.getProperty("java.class.path"), SlowWriter.class.getName(), folder.resolve("film").toString())
                .redirectError(ProcessBuilder.Redirect.INHERIT).start();
        assertThat(other.inputReader().readLine()).isEqualTo("writing");
        return other;
    }

    private static Path untouched(Path file, Duration ago) throws IOException {
        Files.writeString(file, "half");
        return Files.setLastModifiedTime(file, FileTime.from(Instant.now().minus(ago)));
    }

    private List<Path> temporary() throws IOException {
        try (Stream<Path> all = Files.list(folder)) {
            return all.filter(file -> file.getFileName().toString().startsWith(".lightning-")).toList();
        }
    }
}
