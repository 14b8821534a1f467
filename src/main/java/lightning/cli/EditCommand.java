package lightning.cli;

import java.nio.file.Path;
import java.util.concurrent.Callable;
import lightning.base.text.Quote;
import lightning.cli.output.BadInputException;
import lightning.format.MeshFormat;
import lightning.format.jen.JenFile;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** Command {@code edit}; the launcher opens files that the editor supports itself, so this command only reports others. */
@Command(name = "edit", header = "Open a scene in the editor.", abbreviateSynopsis = true,
        description = "Same as lightning without a command. A glTF, USD, OBJ, PLY, NFF or FBX file, or one of another program, is converted to a scene next to it.",
        footer = {
            "Examples:",
            "  lightning edit scenes/stage.jen",
            "  lightning edit house.glb"})
final class EditCommand implements Callable<Integer> {
    @Spec
    private CommandSpec command;
    @Parameters(index = "0", arity = "0..1", paramLabel = "file",
            description = "Scene or model file (default: a copy of scenes/stage.jen).")
    private @Nullable Path file;

    @Override
    public Integer call() throws BadInputException {
        if (file != null && !JenFile.isJenFileName(file.toString())) {
            throw new BadInputException(Quote.path(file) + ": the editor opens files that end in " + JenFile.EXTENSION + ", "
                    + String.join(", ", MeshFormat.allExtensions()));
        }
        return command.parent().commandLine().execute(file == null ? new String[0] : new String[] {file.toString()});
    }
}
