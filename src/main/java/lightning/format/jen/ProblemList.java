package lightning.format.jen;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import lightning.format.jen.asset.JenLimits;

/** Problems of one file, at most one for each position. */
final class ProblemList {
    private record Entry(int offset, String message) {}

    private final List<Entry> entries = new ArrayList<>();
    private final Set<Integer> offsets = new HashSet<>();

    /** Adds a problem at a character offset, unless one exists there. */
    void add(int offset, String message) {
        if (!isFull() && offsets.add(offset)) {
            entries.add(new Entry(offset, message));
            if (isFull()) {
                entries.add(new Entry(Integer.MAX_VALUE,
                        "more than " + JenLimits.PROBLEMS + " problems, the rest of the file was not checked"));
            }
        }
    }

    boolean isEmpty() {
        return entries.isEmpty();
    }

    /** Returns whether the maximum is reached and reading should stop. */
    boolean isFull() {
        return offsets.size() >= JenLimits.PROBLEMS;
    }

    /** Returns all problems in file order. */
    List<Problem> toProblems(SourceText source) {
        return entries.stream().sorted(Comparator.comparingInt(Entry::offset))
                .map(f -> source.toProblem(f.offset(), f.message())).toList();
    }

    /** Returns the messages without positions. */
    List<String> messages() {
        return entries.stream().sorted(Comparator.comparingInt(Entry::offset)).map(Entry::message).toList();
    }
}
