package lightning.format.jen;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/** Replacements in a text, by offsets of the old text; an empty range is an insertion. */
final class Edits {
    private record Edit(int start, int end, String with) {}

    private final String text;
    private final List<Edit> edits = new ArrayList<>();

    Edits(String text) {
        this.text = text;
    }

    void replace(int start, int end, String with) {
        edits.add(new Edit(start, end, with));
    }

    void insert(int offset, String what) {
        replace(offset, offset, what);
    }

    /**
     * The characters from {@code start} to {@code end} of the old text with all replacements made.
     * They must not overlap; insertions at one place come in the order of their making, before a
     * replacement that starts there.
     */
    String apply(int start, int end) {
        var out = new StringBuilder(end - start + 64);
        int done = start;
        edits.sort(Comparator.comparingInt(Edit::start).thenComparingInt(e -> e.start == e.end ? 0 : 1));
        for (Edit edit : edits) {
            if (edit.start < done) {
                throw new IllegalStateException("two edits overlap at character " + edit.start);
            }
            out.append(text, done, edit.start).append(edit.with);
            done = edit.end;
        }
        return out.append(text, done, end).toString();
    }
}
