package lightning.format.jen;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/** Collects the problems of one file, at most one for each place. */
final class Problems {
    private record Found(int offset, String message) {}

    private final List<Found> found = new ArrayList<>();
    private final Set<Integer> places = new HashSet<>();

    /** Notes a problem at the character {@code offset}, unless one is known there. */
    void add(int offset, String message) {
        if (!isFull() && places.add(offset)) {
            found.add(new Found(offset, message));
            if (isFull()) {
                found.add(new Found(Integer.MAX_VALUE,
                        "more than " + JenLimits.PROBLEMS + " problems, the rest of the file was not looked at"));
            }
        }
    }

    boolean isEmpty() {
        return found.isEmpty();
    }

    /** Whether there are so many that reading should stop. */
    boolean isFull() {
        return places.size() >= JenLimits.PROBLEMS;
    }

    /** All problems in the order of the file. */
    List<Problem> in(Source source) {
        return found.stream().sorted(Comparator.comparingInt(Found::offset))
                .map(f -> source.problem(f.offset(), f.message())).toList();
    }

    /** The messages without their places. */
    List<String> messages() {
        return found.stream().sorted(Comparator.comparingInt(Found::offset)).map(Found::message).toList();
    }
}
