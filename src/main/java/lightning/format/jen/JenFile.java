package lightning.format.jen;

/** Names of scene files. */
public final class JenFile {
    /** File extension of scenes. */
    public static final String EXTENSION = ".jen";

    private JenFile() {}

    /** Returns whether a file name has the extension of a scene. */
    public static boolean isJenFileName(String file) {
        return file.endsWith(EXTENSION);
    }

    /** Returns the name without the scene extension, or the whole name if it has another. */
    public static String stem(String name) {
        return isJenFileName(name) ? name.substring(0, name.length() - EXTENSION.length()) : name;
    }
}
