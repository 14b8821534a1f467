package lightning.cli;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipInputStream;
import lightning.base.file.AtomicFile;
import lightning.base.file.RegularFile;
import lightning.cli.output.BadInputException;
import lightning.cli.output.Console;
import lightning.cli.output.ExitCode;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/** Installs the Blender add-on. */
@Command(name = "blender", header = "Install the Blender add-on.", abbreviateSynopsis = true,
        description = {
            "With --install, unpacks the add-on into Blender's folder of user extensions and tells it where Lightning is. Then enable "
                    + "Lightning in Blender under Edit > Preferences > Add-ons.",
            "",
            "Without --install, prints the add-on's zip file, which Blender installs from disk."},
        footer = {
            "Examples:",
            "  lightning blender --install",
            "  lightning blender"})
final class BlenderCommand implements Callable<Integer> {
    private static final String ADD_ON = "lightning";
    /** Folder of the add-on in a checkout of the sources, which has no zip. */
    private static final Path SOURCES = Path.of("src", "main", "blender", ADD_ON);
    /** Package that the add-on contains in its zip, as in blender.xml. */
    private static final String CLIENT = "lightning_relight";
    private static final Path CLIENT_SOURCES = Path.of("src", "main", "python", CLIENT);
    /** Oldest version that the add-on runs in, as in its manifest. */
    private static final double MIN_VERSION = 4.5;

    private final Console console;
    private final Map<String, String> environment;
    private final Path home;

    @Option(names = "--install", paramLabel = "DIR", arity = "0..1", fallbackValue = "",
            description = "Install into a folder of extensions (default: that of the newest Blender that has one).")
    private @Nullable String folder;

    BlenderCommand(Console console) {
        this(console, System.getenv(), Path.of(System.getenv().getOrDefault("HOME", System.getProperty("user.home"))));
    }

    /**
     * Creates a command for other settings of the system.
     *
     * @param home the user's folder
     */
    BlenderCommand(Console console, Map<String, String> environment, Path home) {
        this.console = console;
        this.environment = environment;
        this.home = home;
    }

    @Override
    public Integer call() throws Exception {
        String program = System.getProperty("lightning.home");
        Path root = Path.of(program == null ? "" : program).toAbsolutePath();
        Path zip = root.resolve("blender").resolve("lightning-blender.zip");
        Path sources = root.resolve(SOURCES);
        if (!Files.isRegularFile(zip) && !Files.isDirectory(sources)) {
            throw new BadInputException(Console.text("%s: expected the Blender add-on, found no file", zip));
        }
        if (folder == null) {
            console.print("%s", Files.isRegularFile(zip) ? zip : sources);
            return ExitCode.OK;
        }
        Path extensions = folder.isEmpty() ? userFolder() : Path.of(folder);
        if (!folder.isEmpty() && !Files.isDirectory(extensions)) {
            throw new BadInputException(Console.text("%s: expected a folder of Blender extensions, found none", extensions));
        }
        Path target = extensions.resolve(ADD_ON);
        if (Files.isRegularFile(zip)) {
            unpack(zip, target);
        } else {
            copy(sources, target);
            copy(root.resolve(CLIENT_SOURCES), target.resolve(CLIENT));
        }
        String launcher = Optional.ofNullable(System.getProperty("jpackage.app-path")).orElse(root.resolve("bin/lightning").toString());
        AtomicFile.of(target.resolve("program.txt")).write((launcher + "\n").getBytes(StandardCharsets.UTF_8));
        console.print("%s: installed; enable Lightning in Blender under Edit > Preferences > Add-ons", target);
        return ExitCode.OK;
    }

    /** Returns the folder of user extensions of the newest Blender that was started by this user. */
    private Path userFolder() throws IOException, BadInputException {
        String extensions = environment.get("BLENDER_USER_EXTENSIONS");
        if (extensions != null) {
            return Path.of(extensions, "user_default");
        }
        String resources = environment.get("BLENDER_USER_RESOURCES");
        if (resources != null) {
            return Path.of(resources, "extensions", "user_default");
        }
        Path settings = settingsFolder();
        Optional<Path> newest = Optional.empty();
        if (Files.isDirectory(settings)) {
            try (Stream<Path> versions = Files.list(settings)) {
                newest = versions.filter(v -> version(v) >= MIN_VERSION)
                        .max((a, b) -> Double.compare(version(a), version(b)));
            }
        }
        return newest.orElseThrow(() -> new BadInputException(Console.text(
                "%s: expected the settings of Blender %s or newer, found none; start Blender once, or name its folder of extensions",
                settings,
                MIN_VERSION))).resolve("extensions").resolve("user_default");
    }

    private Path settingsFolder() {
        String system = System.getProperty("os.name").toLowerCase(Locale.ROOT);
        if (system.contains("win")) {
            return Path.of(environment.getOrDefault("APPDATA", home.toString()), "Blender Foundation", "Blender");
        }
        return system.contains("mac") ? home.resolve("Library/Application Support/Blender")
                : Path.of(environment.getOrDefault("XDG_CONFIG_HOME", home.resolve(".config").toString()), "blender");
    }

    /** Returns the version of a folder such as 5.0; 0 if its name is none. */
    private static double version(Path folder) {
        String name = folder.getFileName().toString();
        return name.matches("\\d+\\.\\d") ? Double.parseDouble(name) : 0;
    }

    private static void unpack(Path zip, Path target) throws IOException {
        Files.createDirectories(target);
        try (var in = new ZipInputStream(RegularFile.open(zip, "the Blender add-on"))) {
            for (ZipEntry entry = in.getNextEntry(); entry != null; entry = in.getNextEntry()) {
                Path file = target.resolve(entry.getName()).normalize();
                if (!entry.isDirectory() && file.startsWith(target)) {
                    Files.createDirectories(file.getParent());
                    AtomicFile.of(file).write(in.readAllBytes());
                }
            }
        }
    }

    private static void copy(Path sources, Path target) throws IOException {
        Files.createDirectories(target);
        try (Stream<Path> files = Files.list(sources)) {
            for (Path file : files.filter(Files::isRegularFile).toList()) {
                try (InputStream in = RegularFile.open(file, "the Blender add-on")) {
                    AtomicFile.of(target.resolve(file.getFileName())).write(in.readAllBytes());
                }
            }
        }
    }
}
