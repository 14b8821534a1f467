package lightning.cli;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

final class NodeCommandTest {
    @TempDir
    private Path folder;

    @Test
    void missingCertificate_isRejectedWithHint() {
        CliResult.run("node").assertRejected("--certificate FILE is missing", "--make-certificate");
        CliResult.run("shot", "relight", "scenes/dusk.jen", "--set", "sky.on=no", "--cluster", "127.0.0.1", "-o", folder.resolve("a"))
                .assertRejected("--certificate FILE is missing");
    }

    @Test
    void remoteMachine_withoutBind_isRejected() {
        CliResult.run("node", "--certificate", "c.p12", "--join", "192.0.2.7:7800").assertRejected("192.0.2.7 is another machine",
                "--bind ADDRESS");
    }

    @Test
    void bindToAllAddresses_isRejected() {
        CliResult.run("node", "--certificate", "c.p12", "--bind", "0.0.0.0").assertRejected("--bind must be one address", "0.0.0.0");
    }

    @Test
    void bindToForeignAddress_isRejected() {
        Path file = folder.resolve("c.p12");
        CliResult.run("node", "--make-certificate", file).assertSuccess();
        CliResult.run("node", "--certificate", file, "--bind", "192.0.2.1", "--folder", folder)
                .assertRejected("--bind must be an address of this machine, was 192.0.2.1, which no network interface has");
    }

    @Test
    void invalidHost_isRejected() {
        for (String word : new String[] {"", "a b", "host:", "host:0", "host:70000", "a:b:c", "[::1"}) {
            CliResult.run("node", "--certificate", "c.p12", "--join", word).assertRejected("expected a host and a port from 1 to 65535");
        }
    }

    @Test
    void existingCertificate_isNotOverwritten() {
        Path file = folder.resolve("c.p12");
        CliResult.run("node", "--make-certificate", file).assertSuccess();
        CliResult.run("node", "--make-certificate", file).assertRejected("c.p12: already exists");
    }

    @Test
    void missingCertificateFile_isNamed() {
        CliResult.run("node", "--certificate", folder.resolve("none.p12")).assertRejected("none.p12: file not found",
                "--make-certificate");
    }
}
