package lightning.bench;

import com.sun.management.OperatingSystemMXBean;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.net.URISyntaxException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import jdk.incubator.vector.FloatVector;

/** The machine and the program that run now. */
final class Here {
    private Here() {}

    static Machine machine() {
        long memory = ManagementFactory.getOperatingSystemMXBean() instanceof OperatingSystemMXBean system
                ? system.getTotalMemorySize() : 0;
        return new Machine(System.getProperty("os.name") + ", " + System.getProperty("os.arch"),
                Runtime.getRuntime().availableProcessors(), FloatVector.SPECIES_PREFERRED.vectorBitSize(), memory,
                Runtime.getRuntime().maxMemory(), System.getProperty("java.vm.name") + " " + Runtime.version());
    }

    /** The commit that the program was built from, if it still lies in its repository; else {@code unknown}. */
    static String commit() {
        try {
            Path program = Path.of(Here.class.getProtectionDomain().getCodeSource().getLocation().toURI()).getParent();
            Process git = new ProcessBuilder("git", "describe", "--always", "--dirty").directory(program.toFile())
                    .redirectError(ProcessBuilder.Redirect.DISCARD).start();
            String said = new String(git.getInputStream().readAllBytes(), StandardCharsets.UTF_8).strip();
            return git.waitFor() == 0 && !said.isEmpty() ? said : "unknown";
        } catch (IOException | URISyntaxException e) {
            return "unknown";
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            return "unknown";
        }
    }
}
