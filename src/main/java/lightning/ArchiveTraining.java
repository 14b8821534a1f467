package lightning;

import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import lightning.cli.Lightning;
import lightning.editor.window.StartupTraining;

/**
 * Training run for the class archive: renders an image with the command and opens the editor once, while the JVM records the classes
 * loaded. Called by {@code make-archive} with the image file to write.
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
