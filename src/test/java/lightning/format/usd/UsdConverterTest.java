package lightning.format.usd;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Duration;
import java.util.concurrent.CancellationException;
import java.util.concurrent.atomic.AtomicInteger;
import lightning.base.process.PythonConverter;
import lightning.base.work.Progress;
import lightning.format.mesh.MeshException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** The process that reads stages, with scripts in the place of Python. */
@DisabledOnOs(OS.WINDOWS)
class UsdConverterTest {
    private static final Duration SECOND = Duration.ofSeconds(1);
    @TempDir
    private Path folder;

    /** Returns a program that knows the folder of the first request, whose line is {@code ["STAGE","FOLDER",...]}. */
    private Path program(String commands) throws IOException {
        Path file = Files.writeString(folder.resolve("python3"), "#!/bin/sh\nIFS='\"' read -r _ _ _ folder _\n" + commands + "\n");
        return Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rwxr-xr-x"));
    }

    private String convert(String commands, Duration limit, Progress progress) throws IOException, MeshException {
        Path source = folder.resolve("shot.usda");
        return new UsdConverter(new PythonConverter(program(commands), folder, limit, UsdConverter.USD), 1L << 30, 0).convert(source,
                StageChoice.DEFAULT, progress,
                written -> Files.readString(written.resolve("stage.json")));
    }

    @Test
    void writtenFolder_isReadAndRemoved() throws Exception {
        Path place = folder.resolve("place");
        assertThat(convert("echo $folder > " + place + "; printf found > $folder/stage.json", Duration.ofMinutes(1), Progress.NONE))
                .isEqualTo("found");
        assertThat(Path.of(Files.readString(place).strip())).as("the folder that it wrote into").doesNotExist();
    }

    @Test
    void missingPackage_isAskedForInOneSentence() {
        assertThatThrownBy(() -> convert("exit 3", Duration.ofMinutes(1), Progress.NONE)).isInstanceOf(IOException.class)
                .hasMessage("USD files need the Python package usd-core; run: " + folder.resolve("python3") + " -m pip install usd-core");
    }

    @Test
    void errorOfStage_isOneSentence() {
        assertThatThrownBy(() -> convert("printf 'is damaged\\nmore' > $folder/error.txt; exit 2", Duration.ofMinutes(1), Progress.NONE))
                .isInstanceOf(MeshException.class).hasMessageEndingWith("shot.usda: is damaged");
        assertThatThrownBy(() -> convert("echo cannot work >&2; exit 1", Duration.ofMinutes(1), Progress.NONE))
                .isInstanceOf(MeshException.class).hasMessageEndingWith("the converter of USD files ended with code 1 (cannot work)");
        assertThatThrownBy(() -> convert("kill -9 $$", Duration.ofMinutes(1), Progress.NONE)).isInstanceOf(MeshException.class)
                .hasMessageContaining("ended with code 137");
        assertThatThrownBy(() -> convert("", Duration.ofMinutes(1), Progress.NONE)).isInstanceOf(MeshException.class)
                .hasMessageContaining("ended with code 0");
    }

    @Test
    void endlessProcess_isEnded() throws IOException {
        Path place = folder.resolve("place");
        assertThatThrownBy(() -> convert("echo $folder > " + place + "; sleep 100", SECOND, Progress.NONE))
                .isInstanceOf(MeshException.class)
                .hasMessageEndingWith("shot.usda: usd-core did not read it within 1 s");
        assertThat(ProcessHandle.current().descendants().filter(ProcessHandle::isAlive)
                .anyMatch(p -> p.info().commandLine().orElse("").contains(folder.toString()))).isFalse();
        assertThat(Path.of(Files.readString(place).strip())).as("the folder that it wrote into").doesNotExist();
    }

    @Test
    void canceledProcess_isEnded() {
        var polls = new AtomicInteger();
        assertThatThrownBy(() -> convert("sleep 100", Duration.ofMinutes(1), Progress.cancellation(() -> polls.incrementAndGet() > 2)))
                .isInstanceOf(CancellationException.class);
    }
}
