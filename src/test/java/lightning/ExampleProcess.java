package lightning;

import java.io.BufferedReader;
import java.io.BufferedWriter;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.net.URLDecoder;
import java.net.URLEncoder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import lightning.cli.Lightning;
import lightning.sample.TestedProgram;

/**
 * Process that runs the program's commands in a folder one after the other, like a user with an installed program, but with a single start
 * of Java.
 */
final class ExampleProcess implements AutoCloseable {
    /** Installation folder: this folder has the program's scenes and textures. */
    private static final Path HOME = Path.of("").toAbsolutePath();

    private final Process process;
    private final BufferedWriter input;
    private final BufferedReader output;

    /**
     * Result of a command.
     *
     * @param text its output, errors after results
     */
    record Result(int exit, String text) {}

    /** @param folder working directory of the commands */
    ExampleProcess(Path folder) throws IOException {
        var builder = new ProcessBuilder(TestedProgram.ofClass(ExampleProcess.class.getName(), "-Xmx1g", "-Dlightning.home=" + HOME,
                "-Dlightning.warmup=0", "-Dlightning.data=" + folder.resolve("data")))
                .directory(folder.toFile()).redirectError(folder.resolve("errors").toFile());
        builder.environment().put("BLENDER_USER_RESOURCES", folder.resolve("blender-settings").toString());
        process = builder.start();
        input = process.outputWriter(StandardCharsets.UTF_8);
        output = process.inputReader(StandardCharsets.UTF_8);
    }

    /** Runs the program with arguments. */
    Result run(List<String> arguments) throws IOException {
        input.write(
                arguments.stream().map(word -> URLEncoder.encode(word, StandardCharsets.UTF_8)).collect(Collectors.joining(" ")) + "\n");
        input.flush();
        String exit = output.readLine();
        if (exit == null) {
            throw new IOException("the process ended while it ran " + arguments);
        }
        return new Result(Integer.parseInt(exit), URLDecoder.decode(output.readLine(), StandardCharsets.UTF_8));
    }

    @Override
    public void close() throws IOException {
        input.close();
        process.destroyForcibly();
    }

    /** Runs the commands on standard input, one per line. */
    public static void main(String... args) throws IOException {
        PrintStream answers = System.out;
        System.setOut(System.err);
        var lines = new BufferedReader(new InputStreamReader(System.in, StandardCharsets.UTF_8));
        for (String line = lines.readLine(); line != null; line = lines.readLine()) {
            String[] words = Stream.of(line.split(" ")).map(word -> URLDecoder.decode(word, StandardCharsets.UTF_8)).toArray(String[]::new);
            var out = new ByteArrayOutputStream();
            var err = new ByteArrayOutputStream();
            int exit = Lightning.run(new PrintStream(out, true, StandardCharsets.UTF_8), new PrintStream(err, true, StandardCharsets.UTF_8),
                    words);
            answers.println(exit);
            answers.println(URLEncoder.encode(out.toString(StandardCharsets.UTF_8) + err.toString(StandardCharsets.UTF_8),
                    StandardCharsets.UTF_8));
        }
    }
}
