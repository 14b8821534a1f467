package lightning;

import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import lightning.cli.Lightning;
import lightning.editor.window.StartupTraining;

/**
 * Does what starts do, while Java takes down which classes that needs: a picture by the command, and the editor's first
 * one. Called by {@code make-archive}, with a picture file to write.
 */
public final class ArchiveTraining {
    private ArchiveTraining() {}

    public static void main(String[] args) {
        var nullOutput = new PrintStream(OutputStream.nullOutputStream(), false, StandardCharsets.UTF_8);
        Lightning.run(nullOutput, nullOutput, "render", System.getProperty("lightning.home") + "/scenes/bird.jen", "-o", args[0]);
        StartupTraining.open();
        System.exit(0);
    }
}
