package lightning.serve.resident;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import lightning.base.file.ContentHash;
import lightning.base.file.ProgramFiles;
import lightning.base.file.RegularFile;

/**
 * What a command takes from its process beside its arguments: the program itself, the working folder, the environment and the mode of new
 * files. Only a process with equal surroundings may run the command.
 */
final class Surroundings {
    /** Variables that shells, terminals and the launcher set, and that change nothing of a command's output. */
    private static final Set<String> IRRELEVANT = Set.of("_", "SHLVL", "PWD", "OLDPWD", "COLUMNS", "LINES", "WINDOWID", "TERM_SESSION_ID",
            "LIGHTNING_LONG");
    /** Bytes of the status of a process; about one page. */
    private static final int MAX_STATUS = 1 << 16;

    private Surroundings() {}

    /** Returns a hash of the surroundings of this process, 64 hexadecimal digits. */
    static String ofThisProcess() throws IOException {
        return hash(ProgramFiles.state(), Path.of("").toAbsolutePath().toString(), System.getenv(), umask());
    }

    static String hash(String program, String folder, Map<String, String> environment, String umask) {
        var relevant = new TreeMap<>(environment);
        relevant.keySet().removeAll(IRRELEVANT);
        // A NUL cannot occur in any of them.
        String all = Stream.concat(Stream.of(program, folder, umask), relevant.entrySet().stream().map(Map.Entry::toString))
                .collect(Collectors.joining("\0"));
        return ContentHash.of(all.getBytes(StandardCharsets.UTF_8)).hex();
    }

    /** Returns the line with the mode of new files, or nothing on systems that do not tell it. */
    private static String umask() throws IOException {
        Path status = Path.of("/proc/self/status");
        if (!Files.isReadable(status)) {
            return "";
        }
        String text = new String(RegularFile.readBytes(status, "a status of a process", MAX_STATUS), StandardCharsets.ISO_8859_1);
        return text.lines().filter(line -> line.startsWith("Umask:")).findFirst().orElse("");
    }
}
