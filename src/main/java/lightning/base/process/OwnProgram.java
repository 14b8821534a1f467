package lightning.base.process;

import java.nio.file.Path;
import java.util.List;

/** This program, to be started again. */
public final class OwnProgram {
    private OwnProgram() {}

    /**
     * Returns the words that start it: the launcher of the installed image or of the program's folder. Without one, Java with the current class
     * path.
     */
    public static List<String> command() {
        String installed = System.getProperty("jpackage.app-path");
        if (installed != null) {
            return List.of(installed);
        }
        String home = System.getProperty("lightning.home");
        if (home != null) {
            return List.of(Path.of(home, "bin", "lightning").toString());
        }
        return List.of(Path.of(System.getProperty("java.home"), "bin", "java").toString(), "--add-modules", "jdk.incubator.vector",
                "--enable-native-access=ALL-UNNAMED", "-cp", System.getProperty("jdk.module.path", System.getProperty("java.class.path")),
                "lightning.Main");
    }
}
