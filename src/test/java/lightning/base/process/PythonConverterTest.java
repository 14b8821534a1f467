package lightning.base.process;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import lightning.base.work.Await;
import lightning.base.work.Progress;
import lightning.sample.PythonPrograms;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** The process of a converter, with readers of one line in the place of a library. Elsewhere than on Linux, a process reads one file. */
@EnabledOnOs(OS.LINUX)
@Timeout(value = Await.TIMEOUT_SECONDS, unit = TimeUnit.SECONDS)
class PythonConverterTest {
    private static final Path CONVERTER = Path.of("src/main/python/converter.py").toAbsolutePath();

    @TempDir
    private Path folder;
    private Path script;

    @BeforeEach
    void writeReader() throws IOException {
        Files.copy(CONVERTER, folder.resolve("converter.py"));
        script = Files.createDirectory(folder.resolve("script"));
        Files.writeString(script.resolve("reader.py"), """
                import ctypes, os, pathlib, sys, time
                def main(arguments):
                    exec(arguments[0])
                    pathlib.Path(arguments[1], "result").write_text(f"{os.getppid()} {os.getpid()}")
                    return 0
                """);
    }

    /** Runs a statement of Python as the reader; returns the numbers of the converter's process and of the reader's. */
    private List<String> convert(String statement, Duration limit) throws IOException {
        var converter = new PythonConverter(Path.of(PythonPrograms.require("ctypes")), script, limit, new PythonPackage("lib", "Files"));
        return converter.convert(statement, List.of("0"), "result", Progress.NONE, IllegalArgumentException::new,
                written -> List.of(Files.readString(written.resolve("result")).split(" ")));
    }

    private List<String> convert(String statement) throws IOException {
        return convert(statement, Duration.ofMinutes(1));
    }

    @Test
    void nextFile_isReadByAForkOfTheSameProcess() throws IOException {
        List<String> first = convert("sys.modules['leak'] = os");
        List<String> second = convert("assert 'leak' not in sys.modules");
        assertThat(second.getFirst()).isEqualTo(first.getFirst());
        assertThat(second.getLast()).isNotEqualTo(first.getLast());
    }

    @Test
    void filesAtTheSameTime_haveTheirOwnProcesses() throws Exception {
        Path started = folder.resolve("started");
        Path next = folder.resolve("next");
        var first = CompletableFuture.supplyAsync(() -> {
            try {
                return convert("pathlib.Path('" + started + "').touch()\nwhile not os.path.exists('" + next + "'): time.sleep(0.01)");
            } catch (IOException e) {
                throw new IllegalStateException(e);
            }
        });
        Await.until(() -> Files.exists(started));
        List<String> second = convert("pathlib.Path('" + next + "').touch()");
        assertThat(first.get().getFirst()).isNotEqualTo(second.getFirst());
    }

    @Test
    void failure_hasTheLastLineOfTheReader_andTheNextFileIsRead() throws IOException {
        String converter = convert("pass").getFirst();
        assertThatThrownBy(() -> convert("raise ValueError('no\\nvalue')")).isInstanceOf(IllegalArgumentException.class)
                .hasMessage("the converter of Files ended with code 1 (value)");
        assertThatThrownBy(() -> convert("print('ended with code 0 (spoofed)'); sys.exit(7)"))
                .hasMessage("the converter of Files ended with code 7 (ended with code 0 (spoofed))");
        assertThatThrownBy(() -> convert("os.abort()")).hasMessage("cannot be read by lib, which ended with signal 6");
        assertThat(convert("pass").getFirst()).isEqualTo(converter);
    }

    @Test
    void fileAfterATimeout_isReadByAnotherProcess() throws IOException {
        String converter = convert("pass").getFirst();
        assertThatThrownBy(() -> convert("time.sleep(100)", Duration.ofMillis(200))).hasMessage("lib did not read it within 0 s");
        assertThat(ProcessHandle.of(Long.parseLong(converter))).isEmpty();
        assertThat(convert("pass").getFirst()).isNotEqualTo(converter);
    }

    @Test
    void fileAfterAKilledConverter_isReadByAnotherProcess() throws Exception {
        String converter = convert("pass").getFirst();
        ProcessHandle process = ProcessHandle.of(Long.parseLong(converter)).orElseThrow();
        process.destroyForcibly();
        process.onExit().get();
        assertThat(convert("pass").getFirst()).isNotEqualTo(converter);
    }

    /** Native code that holds Python's lock, as OpenColorIO does, keeps all of Python's threads from running. */
    private Process converterInNativeCode(Path written) throws Exception {
        Files.createDirectory(written);
        Process process =
                new ProcessBuilder(PythonPrograms.require("ctypes"), "-B", CONVERTER.toString(), script.toString(), "lib").start();
        process.outputWriter().write("[\"pathlib.Path(arguments[1], 'ready').touch(); ctypes.PyDLL(None).pause()\", \"" + written
                + "\", \"0\"]\n");
        process.outputWriter().flush();
        Await.until(() -> Files.exists(written.resolve("ready")));
        return process;
    }

    private static List<ProcessHandle> all(Process process) {
        List<ProcessHandle> all = Stream.concat(process.descendants(), Stream.of(process.toHandle())).toList();
        assertThat(all).hasSize(2);
        return all;
    }

    @Test
    void readerInNativeCode_endsWithItsInput() throws Exception {
        Path written = folder.resolve("written");
        Process process = converterInNativeCode(written);
        List<ProcessHandle> all = all(process);
        try {
            process.outputWriter().close();
            Await.untilEnded(all);
            assertThat(written).doesNotExist();
        } finally {
            all.forEach(ProcessHandle::destroyForcibly);
        }
    }

    @Test
    void readerInNativeCode_endsWithItsKilledConverter() throws Exception {
        Process process = converterInNativeCode(folder.resolve("written"));
        List<ProcessHandle> all = all(process);
        try {
            process.destroyForcibly();
            Await.untilEnded(all);
        } finally {
            all.forEach(ProcessHandle::destroyForcibly);
        }
    }
}
