package lightning.cli.output;

/** Exit codes of commands. */
public final class ExitCode {
    public static final int OK = 0;
    /** A check of the command failed. */
    public static final int CHECK_FAILED = 1;
    public static final int BAD_INPUT = 2;
    /** Code that shells report for a program that Ctrl-C ended. */
    static final int CANCELED = 130;

    private ExitCode() {}
}
