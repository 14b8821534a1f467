package lightning.base.process;

import java.io.IOException;
import java.nio.file.Path;
import lightning.base.file.SearchPath;
import lightning.base.text.Messages;
import lightning.base.text.Quote;
import org.jspecify.annotations.Nullable;

/**
 * Python's interpreter: the one that the environment variable {@value #VARIABLE} names, or the first {@code python3} or {@code python} of the
 * system's search path.
 */
final class PythonInterpreter {
    static final String VARIABLE = "LIGHTNING_PYTHON";

    private PythonInterpreter() {}

    /**
     * Returns the interpreter.
     *
     * @param chosen value of the variable; null or empty for none
     * @param library package that the message names
     * @throws IOException if there is none; the message asks for it
     */
    static Path find(@Nullable String chosen, SearchPath path, PythonPackage library) throws IOException {
        if (chosen != null && !chosen.isEmpty()) {
            return SearchPath.program("", chosen).or(() -> path.find(chosen)).orElseThrow(() -> new IOException(
                    Messages.tr("{0} names {1}, which is not a program", VARIABLE, Quote.of(chosen))));
        }
        return path.find("python3").or(() -> path.find("python")).orElseThrow(() -> new IOException(
                Messages.tr("{0} need Python with the package {1}; install Python 3, then run: pip install {1}", library.title(),
                        library.name())));
    }
}
