package lightning.editor.window.desktop;

import java.util.Optional;

/** Why the test of the packaged program's window cannot run, told where a skip would go unseen. */
final class WindowSkip {
    /** With this environment variable, a skip that an installed package would mend is a failure. */
    static final String REQUIRED_VARIABLE = "LIGHTNING_NEEDS_JAVAFX";

    private WindowSkip() {}

    /**
     * Returns what keeps the test from running, whatever is installed.
     *
     * @param system the system property {@code os.name}
     */
    static Optional<String> reasonOn(String system) {
        return system.equals("Linux") ? Optional.empty()
                : Optional
                        .of("the packaged program's window is not tested on " + system + ": the test opens it on a virtual display of X11");
    }

    /** The line that makes a skip seen: the hosts that run workflows of this form show it on the page of the run. */
    static String line(String reason) {
        return "::warning title=The window is not tested::" + reason;
    }
}
