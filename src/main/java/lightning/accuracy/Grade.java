package lightning.accuracy;

/** The grades of accuracy, each a way to show an edit, from the roughest to the full trace. */
public enum Grade {
    HALF_RESOLUTION("half resolution", "re-rendered exactly, mirrors included, at half the width and height; each pixel enlarged to "
            + "those nearest to it"),
    FAST_SHADING("fast shading", "re-rendered without shadows and reflections, as previews of other editors are (paper §1.1, §2.3)"),
    RATIO("ratio", "the paper's update of stored contributions; mirrors stay as they were"),
    EXACT("exact", "bit-equal to a full trace whose mirrors stay as they were"),
    EXACT_UPDATED("exact, mirrors updated", "exact, and then the mirrors: both times together (paper §4.8)"),
    EXACT_CURRENT("exact, mirrors current", "bit-equal to a full trace, mirrors included, in one step"),
    FULL_TRACE("full trace", "a traditional trace that keeps nothing: the reference");

    private final String label;
    private final String note;

    Grade(String label, String note) {
        this.label = label;
        this.note = note;
    }

    /** A few words, for a table. */
    public String label() {
        return label;
    }

    /** What it does, in a line. */
    public String note() {
        return note;
    }
}
