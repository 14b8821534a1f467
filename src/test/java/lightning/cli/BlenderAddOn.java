package lightning.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import lightning.sample.TestedProgram;

/** The Blender add-on of this build, installed for a test. */
final class BlenderAddOn {
    private BlenderAddOn() {}

    /** Installs the add-on into the folder's {@code user}, Blender's user resources; returns its program, a launcher of the classes under test. */
    static Path install(Path folder) throws IOException {
        Path addOn = Files.createDirectories(folder.resolve("user/extensions/user_default/lightning"));
        copy(Path.of("src/main/blender/lightning"), addOn);
        copy(Path.of("src/main/python/lightning_relight"), addOn.resolve("lightning_relight"));
        // With less memory, each small picture is rendered twice to forecast it.
        List<String> command = TestedProgram.command("-Xmx4g", "-Xmn60m", "-Djava.awt.headless=true");
        Path program = Files.writeString(folder.resolve("lightning"), "#!/bin/sh\nexec '" + String.join("' '", command) + "' \"$@\"\n");
        Files.setPosixFilePermissions(program, PosixFilePermissions.fromString("rwxr-xr-x"));
        Files.writeString(addOn.resolve("program.txt"), program + "\n");
        return program;
    }

    private static void copy(Path from, Path to) throws IOException {
        Files.createDirectories(to);
        try (var files = Files.list(from)) {
            for (Path file : files.filter(Files::isRegularFile).toList()) {
                Files.copy(file, to.resolve(file.getFileName()));
            }
        }
    }
}
