package lightning.cli;

/** What a command tells the shell. */
final class ExitCode {
    static final int OK = 0;
    /** The check that the command was asked for failed. */
    static final int CHECK_FAILED = 1;
    static final int BAD_INPUT = 2;
    /** As shells number a program that Ctrl-C ended. */
    static final int CANCELED = 130;

    private ExitCode() {}
}
