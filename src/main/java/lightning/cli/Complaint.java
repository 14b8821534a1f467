package lightning.cli;

import java.io.IOException;
import java.nio.file.InvalidPathException;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.function.Predicate;
import lightning.base.file.FileHandles;
import lightning.base.file.FileSentence;
import lightning.base.text.Quote;
import lightning.base.text.Told;
import lightning.format.jen.JenException;
import lightning.render.relight.PictureTooLarge;

/** Turns whatever went wrong into sentences and an exit code; the only place that does. */
final class Complaint {
    private Complaint() {}

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
            case CancellationException _ -> cancelled(console);
            case InterruptedException _ -> cancelled(console);
            case IOException _ when Thread.currentThread().isInterrupted() -> cancelled(console);
            case JenException e -> {
                e.problems().forEach(p -> console.complain(p.toString()));
                yield ExitCode.BAD_INPUT;
            }
            case Throwable e when FileHandles.areMissing(e) -> sentence(console, "there are not enough file handles; raise their limit, as "
                    + "with 'ulimit -n 4096', and start again");
            case InvalidPathException e ->
                    sentence(console, "the name " + Quote.of(e.getInput()) + " cannot be a file's here: " + e.getReason()
                            + "; where it has letters beyond ASCII, start with a locale of UTF-8, as LC_ALL=C.UTF-8");
            case Told told -> sentence(console, told.getMessage());
            case IOException e -> sentence(console, FileSentence.of(e));
            case PictureTooLarge e -> sentence(console, e.message(way -> words(way, options)));
            case OutOfMemoryError _ -> sentence(console, "there is not enough memory; ask for a smaller --size where the picture is large, "
                    + "or give Java more with JAVA_TOOL_OPTIONS=-Xmx8g");
            default -> sentence(console, "an error of the program itself, not of your input: " + problem
                    + place(problem) + "; please report it with the command and the scene");
        };
    }

    /** A way out with the option that takes it; empty where the scene cannot say it and the command has no option for it. */
    private static Optional<String> words(PictureTooLarge.Way way, Predicate<String> options) {
        String option = switch (way) {
            case PictureTooLarge.Way.Size _ -> "--size";
            case PictureTooLarge.Way.Samples _ -> "--samples";
            case PictureTooLarge.Way.NoAntialias _ -> "--antialias";
            case PictureTooLarge.Way.Shapes _ -> "--storage";
        };
        String value = switch (way) {
            case PictureTooLarge.Way.Size size -> size.width() + "x" + size.height();
            case PictureTooLarge.Way.Samples samples -> String.valueOf(samples.grid());
            case PictureTooLarge.Way.NoAntialias _ -> "off";
            case PictureTooLarge.Way.Shapes _ -> "shapes";
        };
        return options.test(option) ? Optional.of(way.text() + " (" + option + " " + value + ")")
                : way instanceof PictureTooLarge.Way.Shapes ? Optional.empty() : Optional.of(way.text());
    }

    private static int cancelled(Console console) {
        console.complain("lightning: cancelled");
        return ExitCode.CANCELLED;
    }

    private static int sentence(Console console, String sentence) {
        console.complain("lightning: " + sentence);
        return ExitCode.BAD_INPUT;
    }

    /** The one line of our own code where it happened. */
    private static String place(Throwable problem) {
        for (StackTraceElement element : problem.getStackTrace()) {
            if (element.getClassName().startsWith("lightning.")) {
                return " (" + element.getFileName() + ", line " + element.getLineNumber() + ")";
            }
        }
        return "";
    }
}
