package lightning.editor.window.desktop;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import lightning.sample.Packaged;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Starts a virtual display and runs {@link ScreenRobot} on it. */
@Packaged
class WindowIT {
    private static final int TIMEOUT_MINUTES = 4;

    @TempDir
    private Path folder;

    @Test
    void packagedProgram_showsPictureAndEdit() throws Exception {
        Process display = startDisplay();
        try {
            BufferedReader out = display.inputReader();
            String number = out.readLine();
            assertThat(number).as("the number of the virtual display").isNotNull();
            assertThat(runScreenRobot(":" + number)).as(Files.readString(folder.resolve("log"))).isZero();
        } finally {
            display.destroy();
        }
    }

    private Process startDisplay() {
        WindowSkip.reasonOn(System.getProperty("os.name")).ifPresent(WindowIT::skip);
        try {
            return new ProcessBuilder("Xvfb", "-displayfd", "1", "-screen", "0", "1280x900x24", "-nolisten", "tcp")
                    .redirectError(ProcessBuilder.Redirect.DISCARD).start();
        } catch (IOException e) {
            String sentence = "a window needs a display; install the packages xvfb libgtk-3-0 libxtst6";
            assertThat(System.getenv(WindowSkip.REQUIRED_VARIABLE)).as(sentence).isNull();
            skip(sentence);
            throw new AssertionError(e);
        }
    }

    private static void skip(String reason) {
        System.out.println(WindowSkip.line(reason));
        Assumptions.abort(reason);
    }

    /** Runs in a separate process, because Java chooses its display at startup. */
    private int runScreenRobot(String display) throws Exception {
        Path home = Path.of(System.getProperty("java.home"));
        ProcessBuilder builder = new ProcessBuilder(home.resolve("bin/java").toString(), "-cp", "target/test-classes",
                ScreenRobot.class.getName(), folder.toString());
        builder.environment().put("DISPLAY", display);
        builder.environment().put("JAVA_HOME", home.toString());
        Process artist = builder.redirectErrorStream(true).redirectOutput(folder.resolve("log").toFile()).start();
        if (!artist.waitFor(TIMEOUT_MINUTES, TimeUnit.MINUTES)) {
            artist.descendants().forEach(ProcessHandle::destroyForcibly);
            artist.destroyForcibly().waitFor();
        }
        return artist.exitValue();
    }
}
