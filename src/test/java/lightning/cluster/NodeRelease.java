package lightning.cluster;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import lightning.cli.Lightning;

/** What nodes that run from these classes call their release. */
record NodeRelease() {
    String text() {
        var out = new ByteArrayOutputStream();
        var stream = new PrintStream(out, true, StandardCharsets.UTF_8);
        Lightning.run(stream, stream, "--version");
        return out.toString(StandardCharsets.UTF_8).strip() + " on " + System.getProperty("os.arch");
    }
}
