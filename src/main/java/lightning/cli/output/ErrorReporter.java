package lightning.cli.output;

import java.io.IOException;
import java.nio.file.InvalidPathException;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.function.Predicate;
import lightning.base.file.FileErrorMessage;
import lightning.base.file.FileHandles;
import lightning.base.text.Quote;
import lightning.base.text.UserFacingException;
import lightning.cli.report.ErrorReport;
import lightning.format.jen.JenException;
import lightning.render.relight.PictureTooLargeException;

/** Converts exceptions to error messages and exit codes; the only class that does. */
public final class ErrorReporter {
    private ErrorReporter() {}

    /** Reports an error outside of any command; returns the exit code. */
    public static int report(Console console, Throwable problem) {
        return report(console, problem, _ -> false);
    }

    /**
     * Reports an error; returns the exit code.
     *
     * @param options tests whether the command has an option, such as {@code --size}
     */
    public static int report(Console console, Throwable problem, Predicate<String> options) {
        return switch (problem) {
            case CancellationException _ -> reportCanceled(console);
            case InterruptedException _ -> reportCanceled(console);
            case IOException _ when Thread.currentThread().isInterrupted() -> reportCanceled(console);
            case JenException e -> {
                e.problems().forEach(p -> console.error(new ErrorReport(p.message(), p.file(), p.line(), p.column())));
                yield ExitCode.BAD_INPUT;
            }
            case Throwable e when FileHandles.areExhausted(e) ->
                    reportError(console, "not enough file handles; raise the limit, for example "
                            + "with 'ulimit -n 4096', and restart");
            case InvalidPathException e ->
                    reportError(console, "not a valid file name: " + Quote.of(e.getInput()) + ": " + e.getReason()
                            + "; for non-ASCII names set a UTF-8 locale, such as LC_ALL=C.UTF-8");
            case UserFacingException told -> reportError(console, told.getMessage());
            case IOException e -> reportError(console, FileErrorMessage.of(e));
            case PictureTooLargeException e -> reportError(console, e.message(way -> suggestion(way, options)));
            case OutOfMemoryError _ ->
                    reportError(console, "not enough memory; use a smaller --size, "
                            + "or give Java more memory with JAVA_TOOL_OPTIONS=-Xmx8g");
            default -> reportError(console, "internal error, not caused by your input: " + problem
                    + sourceLocation(problem) + "; please report it with the command and the scene");
        };
    }

    /** Returns a remedy with its option; empty if neither the scene nor an option of the command can apply it. */
    private static Optional<String> suggestion(PictureTooLargeException.Suggestion remedy, Predicate<String> options) {
        String option = switch (remedy) {
            case PictureTooLargeException.Suggestion.Size _ -> "--size";
            case PictureTooLargeException.Suggestion.Samples _ -> "--samples";
            case PictureTooLargeException.Suggestion.NoAntialias _ -> "--antialias";
            case PictureTooLargeException.Suggestion.MirrorsAsShapes _ -> "--storage";
            case PictureTooLargeException.Suggestion.Paths _ -> "";
        };
        String value = switch (remedy) {
            case PictureTooLargeException.Suggestion.Size size -> size.width() + "x" + size.height();
            case PictureTooLargeException.Suggestion.Samples samples -> String.valueOf(samples.grid());
            case PictureTooLargeException.Suggestion.NoAntialias _ -> "off";
            case PictureTooLargeException.Suggestion.MirrorsAsShapes _ -> "shapes";
            case PictureTooLargeException.Suggestion.Paths _ -> "";
        };
        return options.test(option) ? Optional.of(remedy.description() + " (" + option + " " + value + ")")
                : remedy instanceof PictureTooLargeException.Suggestion.MirrorsAsShapes ? Optional.empty()
                : Optional.of(remedy.description());
    }

    private static int reportCanceled(Console console) {
        console.error("lightning: canceled");
        return ExitCode.CANCELED;
    }

    private static int reportError(Console console, String sentence) {
        console.error("lightning: " + sentence);
        return ExitCode.BAD_INPUT;
    }

    /** Returns the topmost stack frame in the program's own code, such as " (File.java, line 12)". */
    private static String sourceLocation(Throwable problem) {
        for (StackTraceElement element : problem.getStackTrace()) {
            if (element.getClassName().startsWith("lightning.")) {
                return " (" + element.getFileName() + ", line " + element.getLineNumber() + ")";
            }
        }
        return "";
    }
}
