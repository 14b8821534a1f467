package lightning.cli;

import static java.util.Objects.requireNonNull;

import java.io.PrintStream;
import java.io.PrintWriter;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.BiFunction;
import java.util.stream.Stream;
import lightning.base.text.Quote;
import lightning.cli.option.NumberConverters;
import lightning.cli.output.ClosedPipe;
import lightning.cli.output.Console;
import lightning.cli.output.ErrorReporter;
import lightning.cli.output.ExitCode;
import lightning.format.jen.JenFile;
import lightning.format.jen.asset.NameSuggestion;
import picocli.CommandLine;
import picocli.CommandLine.Help.Ansi;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.ParseResult;
import picocli.CommandLine.TypeConversionException;
import picocli.CommandLine.UnmatchedArgumentException;

/** Entry point of the command line; runs the command that the arguments name. */
public final class Lightning {
    private static final int HELP_WIDTH = 80;
    /** Factories of the commands, in the order of the help. */
    private static final Map<String, BiFunction<Console, KeptRenderer, Object>> COMMANDS = new LinkedHashMap<>();

    static {
        COMMANDS.put("edit", (_, _) -> new EditCommand());
        COMMANDS.put("render", RenderCommand::new);
        COMMANDS.put("relight", RelightCommand::new);
        COMMANDS.put("shot", (console, _) -> createShotCommand(console));
        COMMANDS.put("node", (console, _) -> new NodeCommand(console));
        COMMANDS.put("serve", (console, _) -> new ServeCommand(console));
        COMMANDS.put("resident", (console, _) -> new ResidentCommand(console));
        COMMANDS.put("explain", (console, _) -> new ExplainCommand(console));
        COMMANDS.put("match", (console, _) -> new MatchCommand(console));
        COMMANDS.put("review", (console, _) -> new ReviewCommand(console));
        COMMANDS.put("import", (console, _) -> new ImportCommand(console));
        COMMANDS.put("export", (console, _) -> new ExportCommand(console));
        COMMANDS.put("export-lights", (console, _) -> new ExportLightsCommand(console));
        COMMANDS.put("blender", (console, _) -> new BlenderCommand(console));
        COMMANDS.put("effects", (console, _) -> new EffectsCommand(console));
        COMMANDS.put("tour", (console, _) -> new TourCommand(console));
        COMMANDS.put("bench", (console, _) -> new BenchCommand(console));
        COMMANDS.put("check", (console, _) -> new CheckCommand(console));
        COMMANDS.put("compare", (console, _) -> new CompareCommand(console));
        COMMANDS.put("ocio", (console, _) -> new OcioCommand(console));
        COMMANDS.put("help", (console, _) -> new HelpCommand(console));
        COMMANDS.put("completion", (console, _) -> new CompletionCommand(console));
    }

    private Lightning() {}

    /**
     * Runs one command in this thread; interrupting the thread cancels the command.
     *
     * @param out receives the results
     * @param err receives errors and notes
     * @param args arguments as described by {@code lightning --help}
     * @return exit code: 0 done, 1 check failed, 2 bad usage or bad input, 130 canceled
     */
    public static int run(PrintStream out, PrintStream err, String... args) {
        try (KeptRenderer renderer = new KeptRenderer()) {
            return run(Console.of(out, err), renderer, args);
        }
    }

    /**
     * As above, for a process that runs several commands one after the other.
     *
     * @param renderer has the picture of the command before
     */
    static int run(Console console, KeptRenderer renderer, String... args) {
        try {
            CommandLine commands = createCommands(console, renderer, args);
            // Also for errors that stop parsing before it reaches the option.
            if (List.of(args).contains("--json")) {
                console.report().useJson();
            }
            int exit = isUnknown(commands, args) ? unknownCommand(console, commands, args[0]) : commands.execute(args);
            if (console.report().isJson()) {
                printJson(console, commands, exit, args);
            }
            return checkOutput(console, exit);
        } catch (Throwable e) {
            // Report any exception as a message instead of a stack trace.
            return ErrorReporter.report(console, e);
        }
    }

    /** Returns the exit code of a command, or that of bad input if its output could not be written. */
    static int checkOutput(Console console, int exit) {
        console.err().flush();
        // PrintStream swallows write errors; checkError flushes and returns them.
        if (!console.out().checkError()) {
            return exit;
        }
        if (!ClosedPipe.isOutput(console.out())) {
            console.err().println("lightning: cannot write to the standard output; is the device full or closed?");
        }
        return exit == ExitCode.OK ? ExitCode.BAD_INPUT : exit;
    }

    /**
     * Creates the command that the first argument names, or all commands if none: creating all takes longer than rendering a
     * small image.
     */
    static CommandLine createCommands(Console console, String... args) {
        return createCommands(console, new KeptRenderer(), args);
    }

    private static CommandLine createCommands(Console console, KeptRenderer renderer, String... args) {
        return createCommands(console, renderer, args.length > 0 && COMMANDS.containsKey(args[0]) ? Set.of(args[0]) : COMMANDS.keySet());
    }

    /** Prints the report of the command that ran; help pages and versions are texts. */
    private static void printJson(Console console, CommandLine commands, int exit, String... args) {
        for (ParseResult part = commands.getParseResult(); part != null; part = part.hasSubcommand() ? part.subcommand() : null) {
            if (part.isUsageHelpRequested() || part.isVersionHelpRequested()) {
                return;
            }
        }
        // Picocli has no result of a command whose arguments are wrong.
        CommandLine command = commands;
        for (String arg : args) {
            if (!arg.startsWith("-") && !command.getSubcommands().containsKey(arg)) {
                break;
            }
            command = command.getSubcommands().getOrDefault(arg, command);
        }
        String name = command.getCommandSpec().qualifiedName();
        console.report().print(console.out(), name.substring(name.indexOf(' ') + 1), exit);
    }

    private static CommandLine createShotCommand(Console console) {
        return new CommandLine(new ShotCommand()).addSubcommand(new ShotRenderCommand(console))
                .addSubcommand(new ShotRelightCommand(console)).addSubcommand(new ShotLightsCommand(console));
    }

    private static CommandLine createCommands(Console console, KeptRenderer renderer, Set<String> names) {
        CommandLine commands = new CommandLine(new RootCommand(console));
        for (String name : names) {
            commands.addSubcommand(requireNonNull(COMMANDS.get(name)).apply(console, renderer));
        }
        NumberConverters.register(commands);
        separateSections(commands);
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

    /** Separates the sections of all help pages by blank lines. */
    private static void separateSections(CommandLine command) {
        command.getCommandSpec().usageMessage().synopsisHeading("%nUsage: ").descriptionHeading("%n").parameterListHeading("%n")
                .optionListHeading("%n").footerHeading("%n");
        command.getSubcommands().values().forEach(Lightning::separateSections);
    }

    private static Path parsePath(String text) {
        try {
            return Path.of(text);
        } catch (InvalidPathException e) {
            throw new TypeConversionException("not a valid file name: " + Quote.of(text) + ": " + e.getReason()
                    + "; for non-ASCII names set a UTF-8 locale, such as LC_ALL=C.UTF-8");
        }
    }

    /**
     * Returns whether the first argument is neither a command nor a scene; picocli would report the argument after it
     * instead.
     */
    private static boolean isUnknown(CommandLine commands, String... args) {
        return args.length > 0 && !args[0].startsWith("-") && !JenFile.isJenFileName(args[0])
                && !commands.getSubcommands().containsKey(args[0]);
    }

    private static int unknownCommand(Console console, CommandLine commands, String word) {
        Set<String> names = commands.getSubcommands().keySet();
        console.error("lightning: unknown command " + Quote.of(word) + "; expected a scene.jen or one of " + String.join(", ", names)
                + NameSuggestion.closest(word, names).map(name -> "; did you mean '" + name + "'?").orElse("."));
        console.hint("Try 'lightning --help'.");
        return ExitCode.BAD_INPUT;
    }

    private static int badUsage(Console console, ParameterException e, String... args) {
        CommandSpec command = e.getCommandLine().getCommandSpec();
        String name = command.qualifiedName();
        // Picocli quotes whole arguments, and also the part after an equals sign separately.
        List<String> words = Stream.of(args).flatMap(arg -> Stream.of(arg, arg.substring(arg.indexOf('=') + 1))).toList();
        String hint = e instanceof UnmatchedArgumentException unmatched ? suggestion(command, unmatched.getUnmatched())
                : Stream.of(args).filter(arg -> isUnknownOption(command, arg)).findFirst()
                        .map(arg -> "; unknown option '" + optionName(arg) + "'" + suggestion(command, List.of(arg))).orElse("");
        console.error(name + ": " + Quote.shortenWords(String.valueOf(e.getMessage()), words) + hint);
        console.hint("Try '" + name + " --help'.");
        return ExitCode.BAD_INPUT;
    }

    /** Returns {@code "; did you mean '--size'?"} for the first misspelled option or command, or an empty string. */
    private static String suggestion(CommandSpec command, List<String> unmatched) {
        String word = unmatched.isEmpty() ? "" : optionName(unmatched.getFirst());
        Stream<String> known = word.startsWith("-") ? command.optionsMap().keySet().stream() : command.subcommands().keySet().stream();
        return NameSuggestion.closest(word, known.toList()).map(name -> "; did you mean '" + name + "'?").orElse("");
    }

    private static boolean isUnknownOption(CommandSpec command, String argument) {
        return argument.startsWith("--") && !command.optionsMap().containsKey(optionName(argument));
    }

    private static String optionName(String argument) {
        return argument.replaceFirst("=.*", "");
    }

    private static PrintWriter writer(PrintStream stream) {
        return new PrintWriter(stream, true, stream.charset());
    }
}
