package lightning.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import lightning.cli.output.BadInputException;
import lightning.cli.output.Console;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import picocli.CommandLine;

/** Command blender. */
class BlenderCommandTest {
    private static final String HOME = "lightning.home";
    @TempDir
    private Path folder;
    private final String home = System.getProperty(HOME);

    @BeforeEach
    void setUp() throws IOException {
        Path program = Files.createDirectories(folder.resolve("program/blender"));
        try (var zip = new ZipOutputStream(Files.newOutputStream(program.resolve("lightning-blender.zip")))) {
            for (String name : new String[] {"__init__.py", "part/a.py", "../outside.py"}) {
                zip.putNextEntry(new ZipEntry(name));
                zip.write(name.getBytes(StandardCharsets.UTF_8));
            }
        }
        System.setProperty(HOME, folder.resolve("program").toString());
    }

    @AfterEach
    void tearDown() {
        if (home == null) {
            System.clearProperty(HOME);
        } else {
            System.setProperty(HOME, home);
        }
    }

    private String installed(Map<String, String> environment, String... arguments) throws Exception {
        var out = new ByteArrayOutputStream();
        var console = Console.of(new PrintStream(out, true, StandardCharsets.UTF_8),
                new PrintStream(OutputStream.nullOutputStream(), true, StandardCharsets.UTF_8));
        var command = new BlenderCommand(console, environment, folder.resolve("user"));
        new CommandLine(command).parseArgs(arguments);
        assertThat(command.call()).isZero();
        return out.toString(StandardCharsets.UTF_8);
    }

    @Test
    void givenFolder_getsAddOnAndProgram() throws Exception {
        Path extensions = Files.createDirectory(folder.resolve("extensions"));
        assertThat(installed(Map.of(), "--install", extensions.toString())).contains(extensions.resolve("lightning").toString(), "enable");
        assertThat(extensions.resolve("lightning/__init__.py")).hasContent("__init__.py");
        assertThat(extensions.resolve("lightning/part/a.py")).hasContent("part/a.py");
        assertThat(extensions.resolve("outside.py")).doesNotExist();
        assertThat(Files.readString(extensions.resolve("lightning/program.txt")).strip())
                .isEqualTo(folder.resolve("program/bin/lightning").toString());
        assertThat(installed(Map.of())).contains("lightning-blender.zip");
    }

    @Test
    void checkoutOfSources_isCopied() throws Exception {
        Files.delete(folder.resolve("program/blender/lightning-blender.zip"));
        Path extensions = Files.createDirectory(folder.resolve("extensions"));
        assertThatExceptionOfType(BadInputException.class).isThrownBy(() -> installed(Map.of(), "--install", extensions.toString()))
                .withMessageEndingWith("lightning-blender.zip: expected the Blender add-on, found no file");
        System.setProperty(HOME, Path.of("").toAbsolutePath().toString());
        installed(Map.of(), "--install", extensions.toString());
        assertThat(extensions.resolve("lightning/blender_manifest.toml")).hasSameTextualContentAs(
                Path.of("src/main/blender/lightning/blender_manifest.toml"));
        assertThat(extensions.resolve("lightning/lightning_relight/client.py")).hasSameTextualContentAs(
                Path.of("src/main/python/lightning_relight/client.py"));
    }

    @Test
    @EnabledOnOs(OS.LINUX)
    void newestBlender_isFound() throws Exception {
        for (String version : new String[] {"3.6", "4.5", "5.0", "cache"}) {
            Files.createDirectories(folder.resolve("user/.config/blender").resolve(version));
        }
        installed(Map.of(), "--install");
        assertThat(folder.resolve("user/.config/blender/5.0/extensions/user_default/lightning/__init__.py")).exists();
        installed(Map.of("BLENDER_USER_RESOURCES", folder.resolve("resources").toString()), "--install");
        assertThat(folder.resolve("resources/extensions/user_default/lightning/__init__.py")).exists();
        installed(Map.of("BLENDER_USER_EXTENSIONS", folder.resolve("own").toString()), "--install");
        assertThat(folder.resolve("own/user_default/lightning/__init__.py")).exists();
    }

    @Test
    @EnabledOnOs(OS.LINUX)
    void missingBlender_isOneSentence() {
        assertThatExceptionOfType(BadInputException.class).isThrownBy(() -> installed(Map.of(), "--install"))
                .withMessageEndingWith(
                        "blender: expected the settings of Blender 4.5 or newer, found none; start Blender once, or name its "
                                + "folder of extensions");
        assertThatExceptionOfType(BadInputException.class).isThrownBy(() -> installed(Map.of(), "--install", folder + "/none"))
                .withMessageEndingWith("none: expected a folder of Blender extensions, found none");
    }
}
