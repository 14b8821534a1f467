package lightning.cli;

import java.util.Locale;
import java.util.concurrent.Callable;
import java.util.regex.Pattern;
import lightning.cli.output.Console;
import lightning.cli.output.ExitCode;
import picocli.AutoComplete;
import picocli.CommandLine.Command;
import picocli.CommandLine.Parameters;

/** Prints a script that completes commands and options in a shell. */
@Command(name = "completion", abbreviateSynopsis = true, header = "Print a script for shell completion.",
        description = {
            "Prints a script for bash and zsh that completes commands, options, their words and file names.",
            "",
            "bash: source <(lightning completion bash), in ~/.bashrc.",
            "zsh: source <(lightning completion zsh), in ~/.zshrc, after compinit if you call it."},
        footer = {
            "Example:",
            "  lightning completion bash"})
final class CompletionCommand implements Callable<Integer> {
    /** Words of options and parameters, such as {@code ("OFF" "EDGES")}. */
    private static final Pattern WORDS = Pattern.compile("(?<=_(option|pos_param)_args=)\\(.*\\)");
    /** Changes how zsh completes all aliases of the user. */
    private static final String ZSH_ALIASES =
            "(?m)^  # Make alias a distinct command.*\\R  setopt COMPLETE_ALIASES\\R  alias compopt=complete\\R+";
    private static final String FILES = "compgen -f --";
    /** Completes files; none in zsh, which then completes them itself, with a slash after folders. */
    private static final String OWN_FILES = "\nfunction _lightning_files() {\n  [ -n \"$ZSH_VERSION\" ] || " + FILES + " \"$1\"\n}\n";

    /** Names of shells; zsh runs the script of bash. */
    enum Shell { BASH, ZSH }

    private final Console console;

    @Parameters(index = "0", paramLabel = "SHELL", description = "bash or zsh.")
    private Shell shell;

    CompletionCommand(Console console) {
        this.console = console;
    }

    @Override
    public Integer call() {
        // Printed as it is, not as lines of results.
        console.out().print(script(console));
        return ExitCode.OK;
    }

    /**
     * Returns the script for all commands: picocli's without its time, with words in lowercase as in the documents, and without the settings
     * that change zsh for other commands.
     */
    static String script(Console console) {
        String script = AutoComplete.bash("lightning", Lightning.createCommands(console)).replaceFirst("(?m)^# (Date|Generated).*\\R", "")
                .replaceFirst(ZSH_ALIASES, "").replace(FILES, "_lightning_files") + OWN_FILES;
        return WORDS.matcher(script).replaceAll(words -> words.group().toLowerCase(Locale.ROOT));
    }
}
