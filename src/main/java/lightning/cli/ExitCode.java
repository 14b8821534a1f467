package lightning.cli;

/** Exit codes of commands. */
final class ExitCode {
    static final int OK = 0;
    /** A check of the command failed. */
    static final int CHECK_FAILED = 1;
    static final int BAD_INPUT = 2;
    /** Code that shells report for a program that Ctrl-C ended. */
    static final int CANCELED = 130;

    private ExitCode() {}
}
