package lightning.cli;

import java.util.concurrent.Callable;
import picocli.AutoComplete;
import picocli.CommandLine.Command;
import picocli.CommandLine.Parameters;

/** Prints a script that completes commands and options in a shell. */
@Command(name = "completion", abbreviateSynopsis = true, header = "Print a script for shell completion.",
        description = {
            "Prints a script for bash (also used by zsh) that completes commands, options and file names.",
            "",
            "bash: source <(lightning completion bash), in ~/.bashrc.",
            "zsh: the same after autoload -U +X bashcompinit && bashcompinit, in ~/.zshrc."},
        footer = {
            "Example:",
            "  lightning completion bash"})
final class CompletionCommand implements Callable<Integer> {
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

    /** Returns the script for all commands, without the time that picocli writes into it. */
    static String script(Console console) {
        return AutoComplete.bash("lightning", Lightning.createCommands(console)).replaceFirst("(?m)^# (Date|Generated).*\\R", "");
    }
}
