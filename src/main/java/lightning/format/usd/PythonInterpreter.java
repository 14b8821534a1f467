package lightning.format.usd;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import lightning.base.text.Messages;
import lightning.base.text.Quote;

/**
 * Python's interpreter: the one that the environment variable {@value #VARIABLE} names, or the first {@code python3} or {@code python} of the
 * system's search path.
 */
final class PythonInterpreter {
    static final String VARIABLE = "LIGHTNING_PYTHON";
    private static final List<String> NAMES = List.of("python3", "python3.exe", "python", "python.exe");

    private PythonInterpreter() {}

    /**
     * Returns the interpreter.
     *
     * @param chosen value of the variable; null or empty for none
     * @param folders value of the environment variable {@code PATH}; null for none
     * @throws IOException if there is none; the message asks for it
     */
    static Path find(String chosen, String folders) throws IOException {
        if (chosen != null && !chosen.isEmpty()) {
            return executable("", chosen).or(() -> searched(folders, chosen)).orElseThrow(() -> new IOException(
                    Messages.tr("{0} names {1}, which is not a program", VARIABLE, Quote.of(chosen))));
        }
        for (String name : NAMES) {
            var found = searched(folders, name);
            if (found.isPresent()) {
                return found.get();
            }
        }
        throw new IOException(
                Messages.tr("USD files need Python with the package usd-core; install Python 3, then run: pip install usd-core"));
    }

    private static Optional<Path> searched(String folders, String name) {
        if (folders != null) {
            for (String folder : folders.split(File.pathSeparator)) {
                var found = folder.isEmpty() ? Optional.<Path>empty() : executable(folder, name);
                if (found.isPresent()) {
                    return found;
                }
            }
        }
        return Optional.empty();
    }

    private static Optional<Path> executable(String folder, String name) {
        try {
            Path program = Path.of(folder, name);
            return Files.isRegularFile(program) && Files.isExecutable(program) ? Optional.of(program)
                    : Optional.empty();
        } catch (InvalidPathException e) {
            // The system skips invalid entries, too.
            return Optional.empty();
        }
    }
}
