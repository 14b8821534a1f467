package lightning.format.jen;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/** Text replacements by offsets in the old text; an empty range is an insertion. */
final class TextEdits {
    private record Edit(int start, int end, String replacement) {}

    private final String text;
    private final List<Edit> edits = new ArrayList<>();

    TextEdits(String text) {
        this.text = text;
    }

    void replace(int start, int end, String replacement) {
        edits.add(new Edit(start, end, replacement));
    }

    void insert(int offset, String inserted) {
        replace(offset, offset, inserted);
    }

    /**
     * Returns the old text from {@code start} to {@code end} with all replacements applied. Replacements must not overlap;
     * insertions at one offset keep their order, before a replacement that starts there.
     */
    String apply(int start, int end) {
        var out = new StringBuilder(end - start + 64);
        int copied = start;
        edits.sort(Comparator.comparingInt(Edit::start).thenComparingInt(e -> e.start == e.end ? 0 : 1));
        for (Edit edit : edits) {
            if (edit.start < copied) {
                throw new IllegalStateException("two edits overlap at character " + edit.start);
            }
            out.append(text, copied, edit.start).append(edit.replacement);
            copied = edit.end;
        }
        return out.append(text, copied, end).toString();
    }
}
