package lightning.cli;

import java.util.ArrayList;
import java.util.List;
import lightning.base.work.ProcessRestart;
import lightning.render.warmup.LongRenderCheck;
import lightning.scene.Scene;

/**
 * Restarts a long render in a Java runtime that starts slower but renders faster, if the launcher began with the
 * fast-starting one: docs/decisions/0120-single-images-with-a-smaller-java.md.
 */
final class LongRenderRestart {
    /** System property with the launcher's file, set only by the fast-starting launcher. */
    private static final String LAUNCHER_PROPERTY = "lightning.launcher";
    /** Environment variable that tells the launcher to start the faster runtime. */
    private static final String LONG_RENDER_VARIABLE = "LIGHTNING_LONG=1";

    private LongRenderRestart() {}

    /**
     * Replaces this process by a new run of the command if that saves time. Must be called before any output.
     *
     * @param scene scene with the view's settings
     * @param arguments the whole command line, starting with the command's name
     */
    static void restartIfLong(Scene scene, List<String> arguments) {
        String launcher = System.getProperty(LAUNCHER_PROPERTY);
        if (launcher == null || !LongRenderCheck.isLong(scene)) {
            return;
        }
        List<String> command = new ArrayList<>(List.of("/usr/bin/env", LONG_RENDER_VARIABLE, launcher));
        command.addAll(arguments);
        ProcessRestart.exec(command);
    }
}
