package lightning.serve;

import java.util.List;
import lightning.base.text.UserFacingException;
import lightning.format.jen.Problem;
import org.jspecify.annotations.Nullable;

/** Refusal of a request, answered as data. */
final class RequestException extends RuntimeException implements UserFacingException {
    private static final long serialVersionUID = 1;

    private final ErrorCode code;
    private final String place;
    private final transient List<Problem> problems;

    /**
     * @param place   field of the request or position in a file; may be empty
     * @param message sentence without its full stop
     */
    RequestException(ErrorCode code, String place, @Nullable String message) {
        this(code, place, message, List.of());
    }

    /** @param problems all problems of a scene file */
    RequestException(ErrorCode code, String place, @Nullable String message, List<Problem> problems) {
        super(message, null, false, false);
        this.code = code;
        this.place = place;
        this.problems = List.copyOf(problems);
    }

    ErrorCode code() {
        return code;
    }

    String place() {
        return place;
    }

    List<Problem> problems() {
        return problems;
    }
}
