package lightning.format.jen;

/** Names of scene files. */
public final class JenFile {
    /** What they end in. */
    public static final String EXTENSION = ".jen";

    private JenFile() {}

    /** Whether a file is a scene by its name. */
    public static boolean isJenFileName(String file) {
        return file.endsWith(EXTENSION);
    }

    /** A name without its ending; the whole name where it has another. */
    public static String stem(String name) {
        return isJenFileName(name) ? name.substring(0, name.length() - EXTENSION.length()) : name;
    }
}
