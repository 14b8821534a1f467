package lightning.cli;

import java.nio.file.Path;
import java.util.concurrent.Callable;
import lightning.base.text.ReleaseInfo;
import lightning.cli.output.Console;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.IVersionProvider;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.ScopeType;
import picocli.CommandLine.Spec;

/** Program without a command: the editor, or the tour if no window can be opened. */
@Command(name = "lightning", versionProvider = RootCommand.Version.class,
        header = "Light ray-traced scenes: trace once, then relight exactly in a fraction of the time.",
        description = "Without a command, opens a scene (default: a copy of scenes/stage.jen) or a glTF, USD, OBJ, PLY, NFF, FBX or other file in the editor. If no "
                + "window can be opened, runs lightning tour, which demonstrates every kind of edit with images and timings.",
        commandListHeading = "%nCommands (each has a --help with examples):%n",
        footer = {
            "Exit codes: 0 done, 1 check failed (relight --verify, compare), 2 bad usage or bad input, 130 canceled.",
            "",
            "Examples:",
            "  lightning check scenes/bird.jen",
            "  lightning render scenes/bird.jen -o bird.png",
            "  lightning relight scenes/bird.jen -o red.png --set \"sun.color=1 0 0\"",
            "  lightning compare before.png after.png --json"})
final class RootCommand implements Callable<Integer> {
    private final Console console;

    @Spec
    private CommandSpec command;
    @Parameters(index = "0", arity = "0..1", paramLabel = "scene.jen", description = "Scene to open.")
    private @Nullable Path scene;
    @Option(names = {"-h", "--help"}, usageHelp = true, scope = ScopeType.INHERIT, description = "Show this help.")
    private boolean help;
    @Option(names = {"-V", "--version"}, versionHelp = true, scope = ScopeType.INHERIT, description = "Show the version.")
    private boolean version;

    @Option(names = "--json", scope = ScopeType.INHERIT,
            description = "Print the results as one JSON object (docs/json.md) instead of lines.")
    private void setJson(boolean on) {
        console.report().useJson();
    }

    @Option(names = {"-q", "--quiet"}, scope = ScopeType.INHERIT, description = "Print only errors: no results, notes or progress.")
    private void setQuiet(boolean on) {
        console.report().beQuiet();
    }

    RootCommand(Console console) {
        this.console = console;
    }

    @Override
    public Integer call() {
        console.warn("The editor cannot open a window here; running the tour of the scene instead.");
        return command.commandLine().execute(scene == null ? new String[] {"tour"} : new String[] {"tour", scene.toString()});
    }

    /** Version of the program and of its runtime. */
    static final class Version implements IVersionProvider {
        @Override
        public String[] getVersion() {
            return new String[] {ReleaseInfo.text()};
        }
    }
}
