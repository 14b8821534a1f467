package lightning.cli;

import java.io.IOException;
import java.nio.file.InvalidPathException;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.function.Predicate;
import lightning.base.file.FileErrorMessage;
import lightning.base.file.FileHandles;
import lightning.base.text.Quote;
import lightning.base.text.UserFacingException;
import lightning.format.jen.JenException;
import lightning.render.relight.PictureTooLargeException;

/** Turns whatever went wrong into sentences and an exit code; the only place that does. */
final class ErrorReporter {
    private ErrorReporter() {}

    /** Says what went wrong outside of any command; returns the exit code. */
    static int report(Console console, Throwable problem) {
        return report(console, problem, _ -> false);
    }

    /**
     * Says what went wrong; returns the exit code.
     *
     * @param options which the command has, as in {@code --size}
     */
    static int report(Console console, Throwable problem, Predicate<String> options) {
        return switch (problem) {
            case CancellationException _ -> reportCanceled(console);
            case InterruptedException _ -> reportCanceled(console);
            case IOException _ when Thread.currentThread().isInterrupted() -> reportCanceled(console);
            case JenException e -> {
                e.problems().forEach(p -> console.error(p.toString()));
                yield ExitCode.BAD_INPUT;
            }
            case Throwable e when FileHandles.areExhausted(e) ->
                    reportError(console, "there are not enough file handles; raise their limit, as "
                            + "with 'ulimit -n 4096', and start again");
            case InvalidPathException e ->
                    reportError(console, "the name " + Quote.of(e.getInput()) + " cannot be a file's here: " + e.getReason()
                            + "; where it has letters beyond ASCII, start with a locale of UTF-8, as LC_ALL=C.UTF-8");
            case UserFacingException told -> reportError(console, told.getMessage());
            case IOException e -> reportError(console, FileErrorMessage.of(e));
            case PictureTooLargeException e -> reportError(console, e.message(way -> suggestion(way, options)));
            case OutOfMemoryError _ ->
                    reportError(console, "there is not enough memory; ask for a smaller --size where the picture is large, "
                            + "or give Java more with JAVA_TOOL_OPTIONS=-Xmx8g");
            default -> reportError(console, "an error of the program itself, not of your input: " + problem
                    + sourceLocation(problem) + "; please report it with the command and the scene");
        };
    }

    /** A way out with the option that takes it; empty where the scene cannot say it and the command has no option for it. */
    private static Optional<String> suggestion(PictureTooLargeException.Suggestion remedy, Predicate<String> options) {
        String option = switch (remedy) {
            case PictureTooLargeException.Suggestion.Size _ -> "--size";
            case PictureTooLargeException.Suggestion.Samples _ -> "--samples";
            case PictureTooLargeException.Suggestion.NoAntialias _ -> "--antialias";
            case PictureTooLargeException.Suggestion.MirrorsAsShapes _ -> "--storage";
        };
        String value = switch (remedy) {
            case PictureTooLargeException.Suggestion.Size size -> size.width() + "x" + size.height();
            case PictureTooLargeException.Suggestion.Samples samples -> String.valueOf(samples.grid());
            case PictureTooLargeException.Suggestion.NoAntialias _ -> "off";
            case PictureTooLargeException.Suggestion.MirrorsAsShapes _ -> "shapes";
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

    /** The one line of our own code where it happened. */
    private static String sourceLocation(Throwable problem) {
        for (StackTraceElement element : problem.getStackTrace()) {
            if (element.getClassName().startsWith("lightning.")) {
                return " (" + element.getFileName() + ", line " + element.getLineNumber() + ")";
            }
        }
        return "";
    }
}
