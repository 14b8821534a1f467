package lightning.cli;

import java.io.FilterOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Path;
import java.util.concurrent.Callable;
import java.util.concurrent.CancellationException;
import lightning.base.work.HeapBudget;
import lightning.cli.option.ThreadsOption;
import lightning.cli.output.Console;
import lightning.cli.output.ExitCode;
import lightning.serve.Server;
import lightning.serve.ServerOptions;
import lightning.serve.SocketListener;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** Keeps scenes loaded and answers requests of other programs. */
@Command(name = "serve", header = "Keep scenes loaded and answer requests of other programs.", abbreviateSynopsis = true,
        description = {
            "Reads requests from the standard input and writes answers to the standard output, one JSON object a line. An edit "
                    + "recomputes only what it changes, and each picture equals a full trace in every bit.",
            "",
            "With --socket, listens at a Unix domain socket instead, which only your user can open. The command runs until a client "
                    + "sends 'shutdown' or you stop it.",
            "",
            "docs/serve.md describes all requests. The folder python of the program has a package for Python."},
        footer = {
            "Examples:",
            "  lightning serve",
            "  lightning serve --socket lightning.sock"})
final class ServeCommand implements Callable<Integer> {
    private static final double GB = 1e9;

    private final Console console;

    @Spec
    private CommandSpec command;
    @Mixin
    private ThreadsOption threads;
    @Option(names = "--socket", paramLabel = "PATH", description = "Unix domain socket to create (default: standard input and output).")
    private @Nullable Path socket;
    @Option(names = "--memory", paramLabel = "GB",
            description = "Memory for the caches of all scenes in GB (default: 0.8 of Java's memory).")
    private @Nullable Double memory;

    ServeCommand(Console console) {
        this.console = console;
    }

    @Override
    public Integer call() throws Exception {
        if (memory != null && !(memory > 0)) {
            throw new ParameterException(command.commandLine(), "--memory must be more than 0, was " + memory);
        }
        if (console.report().isJson()) {
            throw new ParameterException(command.commandLine(), "serve does not take --json: its answers are JSON already");
        }
        long bytes = memory == null ? HeapBudget.availableBytes() : Math.min((long) (memory * GB), HeapBudget.availableBytes());
        try (Server server = new Server(new ServerOptions(threads.count(), bytes))) {
            if (socket == null) {
                serveStandardStreams(server);
            } else {
                try (SocketListener _ = SocketListener.start(server, socket)) {
                    console.print("%s: waiting for clients; press Ctrl-C to stop", socket);
                    console.out().flush();
                    server.awaitStop();
                }
            }
        } catch (InterruptedException e) {
            throw new CancellationException();
        }
        return ExitCode.OK;
    }

    private void serveStandardStreams(Server server) throws InterruptedException {
        server.connect(System.in, new CheckedOutput(console.out()), server::stop);
        server.awaitStop();
    }

    /** Output that reports errors, which a print stream only stores. */
    private static final class CheckedOutput extends FilterOutputStream {
        private final PrintStream out;

        CheckedOutput(PrintStream out) {
            super(out);
            this.out = out;
        }

        @Override
        public void write(byte[] bytes, int offset, int length) {
            out.write(bytes, offset, length);
        }

        @Override
        public void flush() throws IOException {
            if (out.checkError()) {
                throw new IOException("the client does not read");
            }
        }
    }
}
