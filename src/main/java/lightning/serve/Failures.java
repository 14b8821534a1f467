package lightning.serve;

import static java.util.Objects.requireNonNull;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.InvalidPathException;
import java.util.concurrent.CancellationException;
import lightning.base.file.FileErrorMessage;
import lightning.base.file.FileHandles;
import lightning.base.text.Quote;
import lightning.format.jen.JenException;
import lightning.format.jen.Problem;
import lightning.render.relight.PictureTooLargeException;

/** Converts exceptions to errors of the protocol. */
final class Failures {
    private Failures() {}

    static RequestException of(Throwable problem) {
        return switch (problem) {
            case RequestException e -> e;
            case CancellationException _ -> new RequestException(ErrorCode.CANCELED, "", "the request was canceled");
            case JenException e -> ofScene(e);
            case PictureTooLargeException e -> new RequestException(ErrorCode.MEMORY, "", e.getMessage());
            case OutOfMemoryError _ -> new RequestException(ErrorCode.MEMORY, "",
                    "not enough memory; close other scenes, or give Java more memory with JAVA_TOOL_OPTIONS=-Xmx8g");
            case InvalidPathException e -> new RequestException(ErrorCode.FILE, "",
                    "not a valid file name: " + Quote.of(e.getInput()) + ": " + e.getReason());
            case Throwable e when FileHandles.areExhausted(e) ->
                    new RequestException(ErrorCode.FILE, "", "not enough file handles; raise the limit, for example with 'ulimit -n 4096'");
            case UncheckedIOException e -> of(requireNonNull(e.getCause()));
            case IOException e -> new RequestException(ErrorCode.FILE, "", FileErrorMessage.of(e));
            default -> new RequestException(ErrorCode.INTERNAL, "",
                    "internal error, not caused by your request: " + problem + "; please report it with the request and the scene");
        };
    }

    private static RequestException ofScene(JenException e) {
        Problem first = e.problems().getFirst();
        return new RequestException(ErrorCode.BAD_SCENE, Quote.path(first.file()) + ":" + first.line() + ":" + first.column(),
                first.message(), e.problems());
    }
}
