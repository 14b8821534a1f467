package lightning.format.jen;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/** Collects the problems of one file, at most one for each place. */
final class ProblemList {
    private record Entry(int offset, String message) {}

    private final List<Entry> entries = new ArrayList<>();
    private final Set<Integer> offsets = new HashSet<>();

    /** Notes a problem at the character {@code offset}, unless one is known there. */
    void add(int offset, String message) {
        if (!isFull() && offsets.add(offset)) {
            entries.add(new Entry(offset, message));
            if (isFull()) {
                entries.add(new Entry(Integer.MAX_VALUE,
                        "more than " + JenLimits.PROBLEMS + " problems, the rest of the file was not looked at"));
            }
        }
    }

    boolean isEmpty() {
        return entries.isEmpty();
    }

    /** Whether there are so many that reading should stop. */
    boolean isFull() {
        return offsets.size() >= JenLimits.PROBLEMS;
    }

    /** All problems in the order of the file. */
    List<Problem> toProblems(SourceText source) {
        return entries.stream().sorted(Comparator.comparingInt(Entry::offset))
                .map(f -> source.toProblem(f.offset(), f.message())).toList();
    }

    /** The messages without their places. */
    List<String> messages() {
        return entries.stream().sorted(Comparator.comparingInt(Entry::offset)).map(Entry::message).toList();
    }
}
