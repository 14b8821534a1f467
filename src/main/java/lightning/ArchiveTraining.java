package lightning;

import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import lightning.cli.Lightning;
import lightning.editor.window.StartupTraining;

/**
 * Training run for the class archive: renders an image and relights one with indirect light by commands, then opens the editor once, while
 * the JVM records the classes loaded. The editor alone would reach an update of indirect light only on a fast machine. Called by
 * {@code make-archive} with the image file to write.
 */
public final class ArchiveTraining {
    private ArchiveTraining() {}

    public static void main(String[] args) {
        var nullOutput = new PrintStream(OutputStream.nullOutputStream(), false, StandardCharsets.UTF_8);
        String scenes = System.getProperty("lightning.home") + "/scenes/";
        Lightning.run(nullOutput, nullOutput, "render", scenes + "bird.jen", "-o", args[0]);
        Lightning.run(nullOutput, nullOutput, "relight", scenes + "stage.jen", "--size", "96x54", "--set", "amber.intensity=2",
                "--no-savings", "-o", args[0]);
        StartupTraining.open();
        System.exit(0);
    }
}
