package lightning.format.ocio;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Duration;
import java.util.List;
import lightning.base.process.PythonConverter;
import lightning.base.work.Progress;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** The process that reads configurations, with scripts in the place of Python. */
@DisabledOnOs(OS.WINDOWS)
class OcioConverterTest {
    @TempDir
    private Path folder;

    /** Runs a shell script that knows the values of the first request, whose line is {@code ["CONFIGURATION","FOLDER","MEMORY"]}. */
    private String convert(String config, String commands, Duration limit) throws IOException {
        Path python = Files.writeString(folder.resolve("python3"), "#!/bin/sh\nIFS='\"' read -r _ config _ folder _\n" + commands + "\n");
        Files.setPosixFilePermissions(python, PosixFilePermissions.fromString("rwxr-xr-x"));
        return new OcioConverter(new PythonConverter(python, folder, limit, OcioConverter.OCIO)).convert(config, List.of(), Progress.NONE,
                written -> Files.readString(written.resolve("views.json")));
    }

    @Test
    void builtInName_isPassedOn() throws Exception {
        assertThat(convert("ocio://default", "printf $config > $folder/views.json", Duration.ofMinutes(1))).isEqualTo("ocio://default");
    }

    @Test
    void missingPackage_isAskedForInOneSentence() {
        assertThatThrownBy(() -> convert("ocio://default", "exit 3", Duration.ofMinutes(1))).isInstanceOf(IOException.class).hasMessage(
                "OpenColorIO views need the Python package opencolorio; run: " + folder.resolve("python3") + " -m pip install opencolorio");
    }

    @Test
    void error_isOneSentenceWithTheFile() throws IOException {
        Path config = Files.writeString(folder.resolve("show.ocio"), "");
        assertThatThrownBy(() -> convert(config.toString(), "printf 'is broken\\nmore' > $folder/error.txt; exit 2", Duration.ofMinutes(1)))
                .isInstanceOf(IOException.class).hasMessage(config + ": is broken");
    }

    @Test
    void endlessProcess_isEnded() {
        assertThatThrownBy(() -> convert("ocio://default", "sleep 100", Duration.ofSeconds(1))).isInstanceOf(IOException.class)
                .hasMessage("ocio://default: opencolorio did not read it within 1 s");
    }

    @Test
    void folder_isNoConfiguration() {
        assertThatThrownBy(() -> convert(folder.toString(), "", Duration.ofMinutes(1))).isInstanceOf(IOException.class)
                .hasMessage(folder + ": is a folder, expected an OpenColorIO configuration");
    }
}
