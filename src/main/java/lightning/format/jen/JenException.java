package lightning.format.jen;

import java.util.List;
import java.util.stream.Collectors;
import lightning.base.text.UserFacingException;

/** A scene file cannot be used; holds every problem found in it, in the order of the file. */
public final class JenException extends Exception implements UserFacingException {
    private static final long serialVersionUID = 1;

    private final transient List<Problem> problems;

    JenException(List<Problem> problems) {
        super(problems.stream().map(Problem::toString).collect(Collectors.joining("\n")));
        this.problems = List.copyOf(problems);
    }

    /** At least one, sorted by place; at most {@link JenLimits#PROBLEMS} and one that says that there are more. */
    public List<Problem> problems() {
        return problems;
    }
}
