package lightning.base.file;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;

/** Another process that reads the state of a file when it is told to, and then replaces that state. */
final class SavingProcess implements AutoCloseable {
    private final Process process;
    private final PrintStream orders;
    private final BufferedReader answers;

    SavingProcess(Path file) throws IOException {
        process = new ProcessBuilder(ProcessHandle.current().info().command().orElseThrow(), "-XX:+UseSerialGC", "-XX:TieredStopAtLevel=1",
                "-cp", System.getProperty("java.class.path"), SavingProcess.class.getName(), file.toString())
                .redirectError(ProcessBuilder.Redirect.INHERIT).start();
        orders = new PrintStream(process.getOutputStream(), true, StandardCharsets.UTF_8);
        answers = process.inputReader(StandardCharsets.UTF_8);
    }

    /** Waits until the process has read the state of the file. */
    void prepare() throws IOException {
        orders.println("");
        answers.readLine();
    }

    /** Starts to replace the state. */
    void save(String text) {
        orders.println(text);
    }

    /** Waits for the end of the save, and returns whether it replaced the state. */
    boolean hasSaved() throws IOException {
        return Boolean.parseBoolean(answers.readLine());
    }

    public static void main(String... args) throws IOException {
        Path file = Path.of(args[0]);
        var orders = new BufferedReader(new InputStreamReader(System.in, StandardCharsets.UTF_8));
        FileState state = FileState.MISSING;
        for (String order = orders.readLine(); order != null; order = orders.readLine()) {
            if (order.isEmpty()) {
                state = FileState.of(file);
                System.out.println();
            } else {
                System.out.println(replaces(file, state, order));
            }
        }
    }

    private static boolean replaces(Path file, FileState state, String text) throws IOException {
        try {
            AtomicFile.of(file).ifUnchanged(state).write(text.getBytes(StandardCharsets.UTF_8));
            return true;
        } catch (ChangedFileException e) {
            return false;
        }
    }

    @Override
    public void close() {
        process.destroy();
    }
}
