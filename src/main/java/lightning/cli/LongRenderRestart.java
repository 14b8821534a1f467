package lightning.cli;

import java.util.ArrayList;
import java.util.List;
import lightning.base.work.ProcessRestart;
import lightning.render.warmup.LongRenderCheck;
import lightning.scene.Scene;

/**
 * Gives a long picture over to a Java that is slower to start and faster in the end, where the launcher began with one that is quick to
 * start: docs/decisions/0120-a-picture-by-a-lighter-java.md.
 */
final class LongRenderRestart {
    /** Names the launcher's file where it began so. */
    private static final String LAUNCHER_PROPERTY = "lightning.launcher";
    /** Tells the launcher that the picture is long. */
    private static final String LONG_RENDER_VARIABLE = "LIGHTNING_LONG=1";

    private LongRenderRestart() {}

    /**
     * Starts the command anew in this process's place if it is worth that, before anything was written or printed.
     *
     * @param scene     as the view shows it
     * @param arguments all of the command line, the command's name first
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
