package lightning.cli;

import java.nio.file.Path;
import java.util.concurrent.Callable;
import lightning.base.text.Quote;
import lightning.format.MeshFormat;
import lightning.format.jen.JenFile;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** The editor by its name; the program opens it before it comes to commands where it is asked for a file that it opens. */
@Command(name = "edit", header = "Open a scene in the editor, as lightning does without a command.", abbreviateSynopsis = true,
        description = "A scene is made of a glTF, OBJ, PLY or NFF file, beside it, as where it is opened in the editor.",
        footer = {
            "Examples:",
            "  lightning edit scenes/stage.jen",
            "  lightning edit house.glb"})
final class EditCommand implements Callable<Integer> {
    @Spec
    private CommandSpec command;
    @Parameters(index = "0", arity = "0..1", paramLabel = "file", description = "The file; scenes/bird.jen without it.")
    private Path file;

    @Override
    public Integer call() throws BadInputException {
        if (file != null && !JenFile.isJenFileName(file.toString())) {
            throw new BadInputException(Quote.path(file) + ": the editor opens files whose names end with " + JenFile.EXTENSION + ", "
                    + String.join(", ", MeshFormat.allExtensions()));
        }
        return command.parent().commandLine().execute(file == null ? new String[0] : new String[] {file.toString()});
    }
}
