package lightning.format.jen;

import java.util.List;
import java.util.stream.Collectors;
import lightning.base.text.UserFacingException;
import lightning.format.jen.asset.JenLimits;

/** Invalid scene file, with all problems in file order. */
public final class JenException extends Exception implements UserFacingException {
    private static final long serialVersionUID = 1;

    private final transient List<Problem> problems;

    JenException(List<Problem> problems) {
        super(problems.stream().map(Problem::toString).collect(Collectors.joining("\n")));
        this.problems = List.copyOf(problems);
    }

    /**
     * Returns at least one problem, sorted by position; at most {@link JenLimits#PROBLEMS}, plus one that reports further
     * problems.
     */
    public List<Problem> problems() {
        return problems;
    }
}
