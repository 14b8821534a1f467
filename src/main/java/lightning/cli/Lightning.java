package lightning.cli;

import java.io.PrintStream;
import java.io.PrintWriter;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Stream;
import lightning.base.text.Quote;
import lightning.format.jen.JenFile;
import picocli.CommandLine;
import picocli.CommandLine.Help.Ansi;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.TypeConversionException;
import picocli.CommandLine.UnmatchedArgumentException;

/** Runs the command that the arguments name. */
public final class Lightning {
    private static final int HELP_WIDTH = 120;
    /** What makes each, in the order in which the help lists them. */
    private static final Map<String, Function<Console, Object>> COMMANDS = new LinkedHashMap<>();

    static {
        COMMANDS.put("edit", _ -> new EditCommand());
        COMMANDS.put("render", RenderCommand::new);
        COMMANDS.put("relight", RelightCommand::new);
        COMMANDS.put("shot", Lightning::createShotCommand);
        COMMANDS.put("node", NodeCommand::new);
        COMMANDS.put("explain", ExplainCommand::new);
        COMMANDS.put("import", ImportCommand::new);
        COMMANDS.put("export", ExportCommand::new);
        COMMANDS.put("export-lights", ExportLightsCommand::new);
        COMMANDS.put("effects", EffectsCommand::new);
        COMMANDS.put("tour", TourCommand::new);
        COMMANDS.put("bench", BenchCommand::new);
        COMMANDS.put("check", CheckCommand::new);
        COMMANDS.put("compare", CompareCommand::new);
    }

    private Lightning() {}

    /**
     * Runs one command in this thread; interrupting it cancels the command.
     *
     * @param out  gets the results
     * @param err  gets complaints and remarks
     * @param args as {@code lightning --help} tells
     * @return the exit code: 0 done, 1 the check failed, 2 bad usage or bad input, 130 canceled
     */
    public static int run(PrintStream out, PrintStream err, String... args) {
        Console console = Console.of(out, err);
        try {
            CommandLine commands = createCommands(console, args);
            int exit = isUnknown(commands, args) ? unknownCommand(console, commands, args[0]) : commands.execute(args);
            err.flush();
            // PrintStream keeps its errors to itself; checkError flushes too.
            if (out.checkError()) {
                console.err().println("lightning: the results could not be written to the standard output; is its device full or closed?");
                return exit == ExitCode.OK ? ExitCode.BAD_INPUT : exit;
            }
            return exit;
        } catch (Throwable e) {
            // Whatever it is, a user gets a sentence.
            return ErrorReporter.report(console, e);
        }
    }

    /** The command that the first word names: to make all of them takes longer than a small picture. All, where it names none. */
    static CommandLine createCommands(Console console, String... args) {
        return createCommands(console, args.length > 0 && COMMANDS.containsKey(args[0]) ? Set.of(args[0]) : COMMANDS.keySet());
    }

    private static CommandLine createShotCommand(Console console) {
        return new CommandLine(new ShotCommand()).addSubcommand(new ShotRenderCommand(console))
                .addSubcommand(new ShotRelightCommand(console));
    }

    private static CommandLine createCommands(Console console, Set<String> names) {
        CommandLine commands = new CommandLine(new RootCommand(console));
        for (String name : names) {
            commands.addSubcommand(COMMANDS.get(name).apply(console));
        }
        NumberConverters.register(commands);
        return commands
                .registerConverter(Path.class, Lightning::parsePath)
                .setOut(writer(console.out()))
                .setErr(writer(console.err()))
                .setColorScheme(CommandLine.Help.defaultColorScheme(console.terminal() ? Ansi.AUTO : Ansi.OFF))
                .setUsageHelpWidth(HELP_WIDTH)
                .setCaseInsensitiveEnumValuesAllowed(true)
                .setExecutionExceptionHandler(
                        (e, command, _) -> ErrorReporter.report(console, e, option -> command.getCommandSpec().findOption(option) != null))
                .setParameterExceptionHandler((e, args) -> badUsage(console, e, args));
    }

    private static Path parsePath(String text) {
        try {
            return Path.of(text);
        } catch (InvalidPathException e) {
            throw new TypeConversionException(Quote.of(text) + " cannot be a file's name here: " + e.getReason()
                    + "; where it has letters beyond ASCII, start with a locale of UTF-8, as LC_ALL=C.UTF-8");
        }
    }

    /** A word that is neither a command nor a scene; picocli would complain about what follows it. */
    private static boolean isUnknown(CommandLine commands, String... args) {
        return args.length > 0 && !args[0].startsWith("-") && !JenFile.isJenFileName(args[0])
                && !commands.getSubcommands().containsKey(args[0]);
    }

    private static int unknownCommand(Console console, CommandLine commands, String word) {
        console.error("lightning: there is no command " + Quote.of(word) + "; expected a scene.jen or one of "
                + String.join(", ", commands.getSubcommands().keySet()) + ".");
        console.error("Try 'lightning --help'.");
        return ExitCode.BAD_INPUT;
    }

    private static int badUsage(Console console, ParameterException e, String... args) {
        String name = e.getCommandLine().getCommandSpec().qualifiedName();
        // Picocli quotes words whole, those behind an equals sign by themselves too.
        List<String> words = Stream.of(args).flatMap(arg -> Stream.of(arg, arg.substring(arg.indexOf('=') + 1))).toList();
        console.error(name + ": " + Quote.shortenWords(e.getMessage(), words));
        UnmatchedArgumentException.printSuggestions(e, writer(console.err()));
        console.error("Try '" + name + " --help'.");
        return ExitCode.BAD_INPUT;
    }

    private static PrintWriter writer(PrintStream stream) {
        return new PrintWriter(stream, true, stream.charset());
    }
}
