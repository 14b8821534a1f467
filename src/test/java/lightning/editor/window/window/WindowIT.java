package lightning.editor.window.window;

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

/** Starts a virtual display, and an artist on it: see {@link Artist}. */
@Packaged
class WindowIT {
    private static final int PATIENCE_MINUTES = 4;

    @TempDir
    private Path folder;

    @Test
    void packagedProgram_showsItsPictureAndAnEditInAWindow() throws Exception {
        Process display = display();
        try {
            BufferedReader out = display.inputReader();
            String number = out.readLine();
            assertThat(number).as("the number of the virtual display").isNotNull();
            assertThat(artist(":" + number)).as(Files.readString(folder.resolve("log"))).isZero();
        } finally {
            display.destroy();
        }
    }

    private Process display() {
        WindowSkip.onSystem(System.getProperty("os.name")).ifPresent(WindowIT::skip);
        try {
            return new ProcessBuilder("Xvfb", "-displayfd", "1", "-screen", "0", "1280x900x24", "-nolisten", "tcp")
                    .redirectError(ProcessBuilder.Redirect.DISCARD).start();
        } catch (IOException e) {
            String sentence = "a window needs a display; install the packages xvfb libgtk-3-0 libxtst6";
            assertThat(System.getenv(WindowSkip.DEMAND)).as(sentence).isNull();
            skip(sentence);
            throw new AssertionError(e);
        }
    }

    private static void skip(String why) {
        System.out.println(WindowSkip.line(why));
        Assumptions.abort(why);
    }

    /** A program of its own, for a display is chosen when Java starts. */
    private int artist(String display) throws Exception {
        Path home = Path.of(System.getProperty("java.home"));
        ProcessBuilder builder = new ProcessBuilder(home.resolve("bin/java").toString(), "-cp", "target/test-classes",
                Artist.class.getName(), folder.toString());
        builder.environment().put("DISPLAY", display);
        builder.environment().put("JAVA_HOME", home.toString());
        Process artist = builder.redirectErrorStream(true).redirectOutput(folder.resolve("log").toFile()).start();
        if (!artist.waitFor(PATIENCE_MINUTES, TimeUnit.MINUTES)) {
            artist.descendants().forEach(ProcessHandle::destroyForcibly);
            artist.destroyForcibly().waitFor();
        }
        return artist.exitValue();
    }
}
