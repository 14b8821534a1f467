package lightning.cli;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

final class NodeCommandTest {
    @TempDir
    private Path folder;

    @Test
    void missingCertificate_isRefusedSayingHowToMakeOne() {
        Cli.run("node").isRefusedSaying("--certificate FILE is missing", "--make-certificate");
        Cli.run("shot", "relight", "scenes/dusk.jen", "--set", "sky.on=no", "--cluster", "127.0.0.1", "-o", folder.resolve("a"))
                .isRefusedSaying("--certificate FILE is missing");
    }

    @Test
    void otherMachine_isRefusedWithoutAnAddressOfThisOne() {
        Cli.run("node", "--certificate", "c.p12", "--join", "192.0.2.7:7800").isRefusedSaying("192.0.2.7 is another machine",
                "--bind ADDRESS");
    }

    @Test
    void bindToAllAddresses_isRefused() {
        Cli.run("node", "--certificate", "c.p12", "--bind", "0.0.0.0").isRefusedSaying("--bind must be one address", "0.0.0.0");
    }

    @Test
    void bindToAnAddressOfAnotherMachine_isRefused_withoutASlash() {
        Path file = folder.resolve("c.p12");
        Cli.run("node", "--make-certificate", file).isDone();
        Cli.run("node", "--certificate", file, "--bind", "192.0.2.1", "--folder", folder)
                .isRefusedSaying("--bind must be an address of this machine, was 192.0.2.1, which no network interface has");
    }

    @Test
    void wordsThatAreNoMachine_areRefused() {
        for (String word : new String[] {"", "a b", "host:", "host:0", "host:70000", "a:b:c", "[::1"}) {
            Cli.run("node", "--certificate", "c.p12", "--join", word).isRefusedSaying("expected a machine and a port from 1 to 65535");
        }
    }

    @Test
    void certificateThatIsThere_isNotWrittenOver() {
        Path file = folder.resolve("c.p12");
        Cli.run("node", "--make-certificate", file).isDone();
        Cli.run("node", "--make-certificate", file).isRefusedSaying("c.p12: is there already");
    }

    @Test
    void certificateThatIsNotThere_isMissedByItsName() {
        Cli.run("node", "--certificate", folder.resolve("none.p12")).isRefusedSaying("none.p12: there is no such file",
                "--make-certificate");
    }
}
