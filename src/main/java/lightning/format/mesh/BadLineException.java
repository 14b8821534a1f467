package lightning.format.mesh;

/** Invalid line of a text file. Formats whose lines do not depend on each other skip it and note it. */
public final class BadLineException extends MeshException {
    private static final long serialVersionUID = 1;

    private final String reason;

    BadLineException(ByteSource source, int line, String message) {
        super(source.file(), "line " + line, message);
        reason = "line " + line + " skipped: " + message;
    }

    /** Returns the note about the line, if it is skipped: its number, and expected and found content. */
    public String note() {
        return reason;
    }
}
