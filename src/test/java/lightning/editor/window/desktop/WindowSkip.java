package lightning.editor.window.desktop;

import java.util.Optional;

/** Reasons for skipping the test of the packaged program's window, reported where a skip would go unnoticed. */
final class WindowSkip {
    /** Environment variable that turns a skip into a failure if installing a package would fix it. */
    static final String REQUIRED_VARIABLE = "LIGHTNING_NEEDS_JAVAFX";

    private WindowSkip() {}

    /**
     * Returns the reason why the test can never run on a system; empty if it can.
     *
     * @param system the system property {@code os.name}
     */
    static Optional<String> reasonOn(String system) {
        return system.equals("Linux") ? Optional.empty()
                : Optional
                        .of("the packaged program's window is not tested on " + system + ": the test opens it on a virtual display of X11");
    }

    /** Returns a workflow annotation that reports the skip: CI hosts show lines of this form on the page of the run. */
    static String line(String reason) {
        return "::warning title=The window is not tested::" + reason;
    }
}
